"""Results for people and for other programs.

`tables` holds the named columns behind every table, `wording` what they say in words, `texts` and
``vocabulary`` those words in English and Vietnamese, `plots` the figures for print, `workbook` the
workbooks, `page` the calculation note, `bundle` the files of each command.

What needs pandas or matplotlib is found in the modules and loaded by whoever asks for it;
`tables.summary` and `wording.names` need neither.
"""
