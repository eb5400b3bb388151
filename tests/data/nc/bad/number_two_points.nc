(expect BadWord 2:8)
G01 X1..5
