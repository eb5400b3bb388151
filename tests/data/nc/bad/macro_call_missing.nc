(expect NoSuchLabel 2:1)
G65 P9010 A1.
