;(expect UnknownCode 3:1)
DEF REAL A
AROT Z45
