(expect Stopped 4:1)
o<x> sub
o<x> endsub
(abort, no tool)
M2
