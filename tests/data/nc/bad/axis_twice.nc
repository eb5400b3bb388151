(expect RepeatedWord 2:9)
G01 X1. X2.
