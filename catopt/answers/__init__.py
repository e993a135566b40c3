"""What each kind of answer consists of: blocks without any face, a file a kind."""
