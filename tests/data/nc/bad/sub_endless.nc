(expect TooDeep 3:1)
O1000
M98 P1000
