(expect BadValue 4:13)
o<x> sub
o<x> endsub
G2 X0 Y0 I5 P0.5
M2
