(expect UnknownCode 2:1)
G07.1 C20.
