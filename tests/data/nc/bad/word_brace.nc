(expect BadWord 2:1)
{BEGIN}
