(expect BadNumber 3:3)
G21 G90 G1 F100
Z1e2
M30
