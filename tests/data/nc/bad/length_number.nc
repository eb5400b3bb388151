(expect BadValue 2:5)
G43 H1.5 Z10.
