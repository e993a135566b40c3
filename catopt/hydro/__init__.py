"""A hull in waves."""
