"""Input files of other mooring programs, read as a case: MoorDyn, MAP++, OrcaFlex, ontology.

From text to a Deck by the format that it has (formats), then to its lines (chains), then to a case
(to_case).
"""
