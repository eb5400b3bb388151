;(expect UnknownCode 3:8)
DEF REAL A
G1 X10 RND=2
