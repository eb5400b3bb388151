(expect BadValue 2:5)
G97 S-500 M3
M30
