"""Lines where they hang, written as the input of other programs."""
