(expect BadExpression 2:7)
#1=[1 / 0]
