(expect BadExpression 2:8)
#1=[1+2
