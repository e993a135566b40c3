"""What catopt says, by key and values, in every language.

`Message` is a sentence with a key and values; as a `str` it is English. ``say(text, language)``
says it; a user's own words, plain `str`, and `Cited` stay as they are.

Kinds of messages:

- `Message("GROUP.NAME", **values)`: a text of ``texts/GROUP.toml``; ``count`` chooses one or many.
- `Several` and `Listed` join others, `Sentence` ends one with a full stop.
- `Translated` is a text of a data file, ``{ en = "...", vi = "..." }``: notes of codes and
  families, titles of published studies (`catopt.catalogue.table.TomlTable.said`).
- `Measure` is a value with its unit, `Cited` what is the same in every language.

An error has its message as ``error.message``; ``str(error)`` is English. The messages of a JSON
document stand beside it (``messages`` of ``design.json``): `catopt.words.message_records` puts them
back.

The groups of texts that are no sentences:

- ``columns``: headings of columns and names of facts, English to the letter, without symbol and
  unit: ``Message("columns.demand")``. Where every row has a unit of its own,
  ``Message("columns.of_row", name=Message("columns.demand"))`` is ``Demand (unit of the row)``.
- ``quantities``: the names of `catopt.quantities.QUANTITIES` by their keys; `quantity_name` gives
  the message.
- ``terms``: words that code and data have in English, such as regimes, verdicts, soils, kinds of
  ship, titles of tables. ``term("sand")`` looks the message up by its English, among the headings
  and quantities, too, when it is said in another language; what is none of them stays as it is.

`heading` puts a name, the quantity's symbol and its unit together: ``Fairlead tension T (kN)``.

What is wrong with an input is said by `catopt.words.message.say_refusal`.

Not messages yet: the formulas of loads (`catopt.loads.component`), names of drawings of a
reproduction, texts of plots.
"""

from catopt.words.message import (
    LANGUAGES,
    Cited,
    Language,
    Listed,
    Measure,
    Message,
    Sentence,
    Several,
    Translated,
    Unit,
    given_keys,
    heading,
    is_said,
    is_term,
    quantity_name,
    say,
    term,
    typed_name,
)

__all__ = [
    "LANGUAGES",
    "Cited",
    "Language",
    "Listed",
    "Measure",
    "Message",
    "Sentence",
    "Several",
    "Translated",
    "Unit",
    "given_keys",
    "heading",
    "is_said",
    "is_term",
    "quantity_name",
    "say",
    "term",
    "typed_name",
]
