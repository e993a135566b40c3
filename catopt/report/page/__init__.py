"""The calculation note: one HTML page that holds all it shows.

`note` gathers what a page is made of, `sections` lists its parts in order, and `render` puts them
together. A section is a builder here and a template in ``templates``; it is left out where its
builder has nothing to show.
"""
