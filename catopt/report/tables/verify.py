"""What notes say of a verification: `catopt.verify.truss_words`."""

from catopt.verify.truss_words import QUANTITY_OF, in_parts, part_sentence

__all__ = ["QUANTITY_OF", "in_parts", "part_sentence"]
