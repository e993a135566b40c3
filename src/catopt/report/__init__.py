"""Results as tables, figures, workbooks and files.

What needs pandas or matplotlib is found in the modules and loaded by whoever asks for it;
`summary` and `words` need neither.
"""
