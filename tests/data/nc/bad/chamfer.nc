(expect UnknownCode 2:9)
G01 X10.,C2.
