;(expect NoSuchLabel 3:7)
DEF REAL A
GOTOF NOWHERE
