(expect BadExpression 2:13)
IF [1 EQ 1] X5
