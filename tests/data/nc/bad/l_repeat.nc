(expect BadFlow 4:1)
o<x> sub
o<x> endsub
o7 repeat [0]
G0 X1
M2
