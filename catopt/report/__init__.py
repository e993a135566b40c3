"""Everything that commands write to a directory.

`bundle` makes the pictures of each command, `files` writes a directory whole or not at all;
`tables` and `workbook` have what is not laid out in blocks yet.
"""
