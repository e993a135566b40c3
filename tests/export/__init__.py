"""Lines written for other programs: what stands in the files, and what those programs find."""
