"""The page: its files, what a browser needs beside them, and the server behind ``catopt app``."""
