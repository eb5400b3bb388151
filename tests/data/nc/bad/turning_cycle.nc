(expect UnknownCode 2:1)
G71 P10 Q20 U0.5 W0.1
