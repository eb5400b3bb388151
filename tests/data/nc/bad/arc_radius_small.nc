(expect BadArc 3:13)
G01 X0 Y0 F100
G02 X10. Y0 R2.
