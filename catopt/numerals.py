"""Numbers as people write them, with a decimal point or comma and with groups of thousands."""

from __future__ import annotations

import re

_NUMERAL = re.compile(r"([+-]?)(\d[\d.,]*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_THOUSANDS = {
    mark: re.compile(rf"[1-9]\d{{0,2}}(?:{re.escape(mark)}\d{{3}})+", re.ASCII) for mark in ".,"
}


def readings(number: str) -> tuple[str, ...]:
    """List the ways in which a number may be read, each with a decimal point and no groups.

    A comma is a decimal one where no thousands can be meant: ``31,3`` and ``0,343``. One mark with
    three digits behind it parts thousands in one country and decimals in the next: ``50,000`` has
    two readings. So has ``50.000``, whose last zero no decimal needs; ``12.345`` is read as the
    decimal that it is in every file of catopt. Where both marks are there, the last is the decimal
    one. Of what is no number there is none; of two readings the decimal one is first.

    Examples
    --------
    >>> readings("31,3"), readings("50.000"), readings("1.234,5"), readings("1,2,3")
    (('31.3',), ('50.000', '50000'), ('1234.5',), ())
    """
    parts = _NUMERAL.fullmatch(number)
    if parts is None:
        return ()
    sign, digits, power = parts[1], parts[2], parts[3] or ""
    return tuple(f"{sign}{each}{power}" for each in _of_digits(digits, has_power=bool(power)))


def _of_digits(digits: str, *, has_power: bool) -> tuple[str, ...]:
    marks = [each for each in digits if each in ".,"]
    if not marks:
        return (digits,)
    last = marks[-1]
    whole, _, rest = digits.rpartition(last)
    if len(set(marks)) > 1:
        group = "." if last == "," else ","
        is_number = last not in whole and rest and _THOUSANDS[group].fullmatch(whole)
        return (f"{whole.replace(group, '')}.{rest}",) if is_number else ()
    is_grouped = bool(_THOUSANDS[last].fullmatch(digits)) and not has_power
    if len(marks) > 1:
        return (digits.replace(last, ""),) if is_grouped else ()
    if last == "," and not rest:
        return ()
    decimal = f"{whole}.{rest}"
    has_two = is_grouped and (last == "," or rest.endswith("0"))
    return (decimal, whole + rest) if has_two else (decimal,)


def bare_number(text: str) -> float | str:
    """Return the number of a text that is one without a unit; else, or if it has two, the text.

    Examples
    --------
    >>> bare_number("22"), bare_number("31,3"), bare_number("50.000"), bare_number("5 kN")
    (22, 31.3, '50.000', '5 kN')
    """
    found = readings(text.strip())
    if len(found) != 1:
        return text
    return int(found[0]) if found[0].lstrip("+-").isdecimal() else float(found[0])
