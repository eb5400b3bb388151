(expect BadArc 3:11)
G01 X0 Y0 F100
G03 X0 Y0 R2.
