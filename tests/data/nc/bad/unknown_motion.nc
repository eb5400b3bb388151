(expect UnknownCode 2:1)
G234 X10.
