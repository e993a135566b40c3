"""Workbooks, and the sheets that they are made of."""
