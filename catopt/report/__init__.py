"""Everything that commands write to a directory: `bundle` draws, `files` writes whole or not."""
