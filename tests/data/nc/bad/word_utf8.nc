(expect BadWord 2:5)
G01 äX1
