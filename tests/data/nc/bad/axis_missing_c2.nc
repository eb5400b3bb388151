(expect NoSuchAxis 2:5)
G00 C2=12.5
