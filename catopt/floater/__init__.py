"""Bodies afloat, by themselves and on their lines."""
