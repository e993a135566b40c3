"""Drawings as plain values: what is in them, and nothing of how a renderer draws it.

Each function takes a result and returns a `catopt.figures.chart.Chart`. Values are in SI, words are
messages. ``render/svg.py`` and ``render/picture.py`` draw charts; none of them knows a kind.
"""
