(expect UnknownCode 2:1)
G06.2 P4 K0 X0 Y0
