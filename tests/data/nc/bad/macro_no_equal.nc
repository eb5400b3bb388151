(expect BadExpression 2:4)
#1 5
