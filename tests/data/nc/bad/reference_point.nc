(expect BadValue 2:5)
G30 P9 Z0
