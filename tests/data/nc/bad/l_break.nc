(expect BadFlow 4:1)
o<x> sub
o<x> endsub
o5 break
M2
