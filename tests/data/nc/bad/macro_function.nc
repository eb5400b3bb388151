(expect BadExpression 2:4)
#1=FOO[3]
