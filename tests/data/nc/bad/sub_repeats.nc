(expect BadValue 2:11)
M98 P1000 L1.5
