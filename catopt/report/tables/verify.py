"""What notes say of a verification: `catopt.answers.verification`."""

from catopt.answers.verification import QUANTITY_OF, in_parts, part_sentence

__all__ = ["QUANTITY_OF", "in_parts", "part_sentence"]
