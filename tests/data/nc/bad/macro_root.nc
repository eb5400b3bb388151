(expect BadExpression 2:4)
#1=SQRT[-4]
