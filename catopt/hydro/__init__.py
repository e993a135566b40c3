"""A hull in waves: pressure, radiation, excitation and memory."""
