;(expect UnknownCode 3:1)
DEF REAL A
CIP X10 Y0 I1=5 J1=5
