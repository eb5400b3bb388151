(expect BadFlow 2:1)
WHILE [1 EQ 2] DO1
G00 X1
