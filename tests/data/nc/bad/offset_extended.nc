(expect BadValue 2:7)
G54.1 P900
