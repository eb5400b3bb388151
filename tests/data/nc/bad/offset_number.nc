(expect BadValue 2:8)
G10 L2 P77 X0
