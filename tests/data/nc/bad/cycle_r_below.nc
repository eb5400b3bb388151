(expect BadValue 2:14)
G81 X1 Y1 Z5 R2. F100
