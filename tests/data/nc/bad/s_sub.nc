;(expect NoSuchLabel 3:1)
DEF REAL A
L100 P2
