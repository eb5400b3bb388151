;(expect UnknownCode 3:1)
DEF REAL A
CYCLE800(0,"T",0,57,0,0,0,30,0,0,0,0,0,1)
