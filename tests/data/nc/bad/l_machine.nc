(expect BadValue 4:1)
o<x> sub
o<x> endsub
G91 G53 G0 X1
M2
