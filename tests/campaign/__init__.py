"""Random lines and systems by the thousand, each answer and each refusal checked by other means."""

from catopt.threads import one_thread

one_thread()  # as the command does: a line that snaps feels the last digit of a sum
