"""Cases that tests of the command line take as texts."""

from .page_cases import TEXTS

SWARM, HARMONIC = TEXTS["swarm"], TEXTS["harmonic"]
