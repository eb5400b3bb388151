(expect MissingWord 2:1)
G81 X1 Y1 Z-5. F100
