(expect BadValue 2:1)
G-1 X1
