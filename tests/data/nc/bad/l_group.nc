(expect CodeConflict 4:4)
o<x> sub
o<x> endsub
G0 G1 X1
M2
