(expect NoSuchLabel 3:1)
G00 X0
M98 P1234
