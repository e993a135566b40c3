"""Published figures beside catopt's own, digit for digit."""

from catopt.reproduce.book import book
from catopt.reproduce.items import Item, Reproduction, Study
from catopt.reproduce.studies import names, reproduce

__all__ = ["Item", "Reproduction", "Study", "book", "names", "reproduce"]
