"""``catopt new``: a case to start from."""
