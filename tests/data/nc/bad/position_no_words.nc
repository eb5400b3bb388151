(expect MissingWord 2:1)
G92
