(expect NoSuchAxis 3:8)
G17 G91
G01 X1 U5.
