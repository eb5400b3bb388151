(expect BadNumber 2:7)
G01 X Y1.
