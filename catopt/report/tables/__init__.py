"""Answers as named columns: the lists behind every table, on a terminal and in files."""
