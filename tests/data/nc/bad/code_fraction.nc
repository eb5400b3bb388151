(expect BadValue 2:1)
G1.55 X1
