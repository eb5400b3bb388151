(expect NotConstant 4:5)
o<x> sub
o<x> endsub
G0 X#<_ini[a]b>
M2
