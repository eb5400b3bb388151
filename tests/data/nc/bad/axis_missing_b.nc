(expect NoSuchAxis 2:8)
G00 X0 B90.
