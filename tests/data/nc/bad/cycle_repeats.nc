(expect BadValue 2:19)
G81 X1 Y1 Z-5. R2 K2.5
