;(expect UnknownCode 3:1)
DEF REAL A
CYCLE81(10,0,2,-5)
