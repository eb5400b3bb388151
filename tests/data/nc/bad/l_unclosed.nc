(expect UnclosedComment 4:4)
o<x> sub
o<x> endsub
G0 (X1
M2
