;(expect BadExpression 3:11)
DEF REAL A
G0 X=(1+2 
