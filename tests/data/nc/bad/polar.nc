(expect UnknownCode 2:1)
G16
