"""What a calculation note needs computed: the case with its answers, and the files it rests on.

Nothing here says how a note looks: `catopt.answers` lays it out.
"""
