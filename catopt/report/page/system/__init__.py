"""The calculation note of a body that several lines moor.

`note` gathers what a page is made of, and `parts` lists the sections in order; each is a builder in
a file of its own, with a template of its key.
"""
