(expect BadValue 3:4)
G21 G90 G1 F100
X1 F-50
M30
