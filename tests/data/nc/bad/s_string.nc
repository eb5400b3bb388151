;(expect BadWord 3:11)
DEF REAL A
T="no end)
