(expect MissingWord 2:1)
M98
