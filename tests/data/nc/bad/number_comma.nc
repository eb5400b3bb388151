(expect UnknownCode 2:7)
G01 X1,5
