"""Environmental forces, anchors and sinkers."""

ROUNDING = 1e-12
"""Relative, of some ten operations in double precision."""
