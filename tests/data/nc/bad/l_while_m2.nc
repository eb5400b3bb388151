(expect BadFlow 4:1)
G21 G90 G94 F100 G1
#1 = 0
o100 while [#1 LT 3]
x1 y[sqrt[2]]
M2
