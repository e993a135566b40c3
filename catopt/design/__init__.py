"""Design: the lines that are best in mass, offset or cost at once, out of what can be bought."""
