(expect UnknownCode 2:1)
G66 P100
