"""Studies: one case, what varies in it, and what is computed of each of its members."""
