(expect NotConstant 2:6)
G00 X#5061
