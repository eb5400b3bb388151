(expect RepeatedWord 4:12)
o<x> sub
o<x> endsub
G1 X1 F100 F200
M2
