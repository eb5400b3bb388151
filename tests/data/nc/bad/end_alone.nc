(expect BadFlow 2:1)
END1
