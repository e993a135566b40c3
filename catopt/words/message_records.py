"""Messages of a JSON document: by which keys and values its English texts are said."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from catopt.words.message import Listed, Measure, Message, Sentence, Several, Term, Translated


def messages_in(document: object) -> dict[str, Any]:
    """List the messages of a document by their English, so that another language can be read."""
    return {str(message): _saved(message) for message in _walk(document)}


def with_messages(document: Any, messages: Mapping[str, Any]) -> Any:
    """Put messages, as `messages_in` lists them, for the English texts of a document that was read.

    A text that is not among them stays plain. Raises ValueError where a message does not say its
    text: it is of another edition of catopt, or was changed.
    """
    if isinstance(document, str):
        return _said_so(document, messages[document]) if document in messages else document
    if isinstance(document, dict):
        return {key: with_messages(value, messages) for key, value in document.items()}
    if isinstance(document, list):
        return [with_messages(value, messages) for value in document]
    return document


def _said_so(english: str, saved: object) -> str:
    """Restore a message that says what stands there."""
    try:
        message = _restored(saved)
    except (AttributeError, LookupError, TypeError, ValueError, OSError) as error:
        raise ValueError(f"that of {english!r} cannot be read ({type(error).__name__})") from None
    if not isinstance(message, str) or message != english:
        raise ValueError(f"that of {english!r} says something else")
    return message


def _walk(document: object) -> Iterator[Message]:
    if isinstance(document, Message):
        yield document
    elif isinstance(document, Mapping | list):
        for value in document.values() if isinstance(document, Mapping) else document:
            yield from _walk(value)


def _saved(value: object) -> object:
    if isinstance(value, Measure):
        return {"quantity": value.quantity, "value": value.value}
    if isinstance(value, Message):
        return {name: _saved(part) for name, part in vars(value).items()}
    if isinstance(value, dict):
        return {name: _saved(part) for name, part in value.items()}
    return [_saved(part) for part in value] if isinstance(value, tuple) else value


def _restored(saved: Any) -> Any:
    if isinstance(saved, list):
        return [_restored(part) for part in saved]
    if not isinstance(saved, dict):
        return saved
    if "key" in saved:
        values = {name: _restored(value) for name, value in saved["values"].items()}
        return Message(saved["key"], **values)
    if "texts" in saved:
        return Translated(saved["texts"])
    kind = _KINDS[(_KINDS.keys() & saved.keys()).pop()]
    return kind(**{name: _restored(part) for name, part in saved.items()})


_KINDS: dict[str, Callable[..., object]] = {
    "term": Term,
    "quantity": Measure,
    "words": Sentence,
    "last": Listed,
    "separator": Several,
}
"""What else a message is, by a name that only its kind has."""
