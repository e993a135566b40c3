"""Input files of other mooring programs, read as a case: MoorDyn (version 1 and 2) and MAP++.

From text to a Deck (moordyn, mappp), then to its lines (chains), then to a case (to_case).
"""
