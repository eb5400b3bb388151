(expect BadFlow 4:1)
o<x> sub
o<x> endsub
o<y> return
M2
