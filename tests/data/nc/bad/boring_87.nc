(expect UnknownCode 2:1)
G87 X1 Y1 Z-5 R2 F100
