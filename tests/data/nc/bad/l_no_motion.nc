(expect NoMotionMode 5:1)
o<x> sub
o<x> endsub
G80
X1
M2
