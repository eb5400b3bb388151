(expect MissingWord 2:1)
G43 Z10.
