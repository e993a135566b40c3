"""Several lines on one body."""
