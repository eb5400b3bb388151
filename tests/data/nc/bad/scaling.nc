(expect UnknownCode 2:1)
G51 X0 Y0 P2.
