;(expect Stopped 3:1)
DEF REAL A
SETAL(65000)
