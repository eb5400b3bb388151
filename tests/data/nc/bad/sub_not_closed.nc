(expect NoEnd 5:1)
M98 P2
M30
O2
G00 X1.
