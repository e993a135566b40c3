"""The commands: each a thin file that reads, calls, and hands the answer to one output object."""
