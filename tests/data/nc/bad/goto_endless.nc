(expect Endless 2:1)
N10 GOTO 10
