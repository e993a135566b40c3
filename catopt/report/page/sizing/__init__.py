"""The calculation note of a sizing: loads, candidates, what holds it, and the line's own note.

`note` puts it together and `parts` lists the sections in order; those of the recommended line are
the sections of a line's note as they are.
"""
