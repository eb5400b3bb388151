(expect BadValue 2:1)
M3.5
