(expect RepeatedWord 3:15)
G01 X0 Y0 F100
G02 X10 Y0 I5 I6
