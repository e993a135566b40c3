"""Random lines and systems by the thousand, each answer and each refusal checked by other means."""
