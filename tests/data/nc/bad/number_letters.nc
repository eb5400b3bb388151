(expect BadNumber 3:6)
G00 X0
G01 Xabc
