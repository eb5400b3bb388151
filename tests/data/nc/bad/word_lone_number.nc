(expect BadWord 2:5)
G01 12 X1
