(expect MissingWord 2:5)
G10 L2 X1.
