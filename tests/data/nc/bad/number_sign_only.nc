(expect BadNumber 2:6)
G01 X- Y1
