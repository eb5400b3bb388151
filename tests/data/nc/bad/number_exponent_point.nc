(expect BadNumber 3:14)
G21 G90 G1 F100
G17 X1.5 Y-2.E3 (never)
M30
