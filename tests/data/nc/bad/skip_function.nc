(expect UnknownCode 2:1)
G31 Z-10. F50
