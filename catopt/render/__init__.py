"""Faces of answers: a file each, which knows blocks and charts and no kind of answer."""
