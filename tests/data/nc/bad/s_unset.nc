;(expect NotConstant 3:6)
DEF REAL A
G0 X=R7
