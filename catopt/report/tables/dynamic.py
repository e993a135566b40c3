"""What notes say of a line in motion: `catopt.verify.motion_words`."""

from catopt.verify.motion_words import (
    DYNAMIC_QUANTITY_OF,
    doubts,
    dynamic_sentences,
    motion_sentences,
    proof_sentences,
    stopped_sentence,
)

__all__ = [
    "DYNAMIC_QUANTITY_OF",
    "doubts",
    "dynamic_sentences",
    "motion_sentences",
    "proof_sentences",
    "stopped_sentence",
]
