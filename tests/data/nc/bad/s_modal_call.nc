;(expect UnknownCode 3:1)
DEF REAL A
MCALL CYCLE82(5,0,1,-3)
