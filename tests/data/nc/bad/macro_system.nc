(expect NotConstant 2:1)
#3000=1 (TOOL MISSING)
