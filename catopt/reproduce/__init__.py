"""Published figures beside catopt's own, digit for digit."""

from catopt.reproduce.items import Item, Reproduction, Study
from catopt.reproduce.studies import book, names, reproduce

__all__ = ["Item", "Reproduction", "Study", "book", "names", "reproduce"]
