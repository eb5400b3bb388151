(expect NoSuchLabel 2:1)
GOTO 77
