(expect BadValue 2:1)
G83 X1 Y1 Z-5. R2. F100
