"""A hull in waves: pressure, radiation, excitation, memory; plain functions, meant to be compiled."""
