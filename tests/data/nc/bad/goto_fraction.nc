(expect BadValue 2:6)
GOTO 1.5
