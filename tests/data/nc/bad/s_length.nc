;(expect UnknownCode 3:6)
DEF REAL A
G1 X=ACP(5)
