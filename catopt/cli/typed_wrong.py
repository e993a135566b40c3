"""What typer says of a command line that it cannot read, in plain words of each language."""

from __future__ import annotations

import re
from typing import Any, Final

import typer

from catopt.cli.help_words import usage_in_vietnamese
from catopt.words import Language

_REFUSED: Final = (
    (r"No such option: (\S+)", r"Không có tùy chọn \1"),
    (r"No such command (.+?)\.", r"Không có lệnh \1."),
    (r"\(Possible options: (.*)\)", r"(các tùy chọn gần giống: \1)"),
    (r"Did you mean (.+)\?", r"Có phải ý là \1?"),
    (r"Missing (?:argument|option|parameter) ('.*?')\.?", r"Thiếu \1."),
    (r"Choose from:", r"Chọn một trong:"),
    (r"\(env var: (.*?)\)", r"(biến môi trường: \1)"),
    (r"Invalid value for (.*?): ", r"Giá trị sai của \1: "),
    (r"('.*?') is not one of (.*)", r"\1 không phải là một trong \2"),
    (r"Input should be a valid integer\b.*", r"cần số nguyên"),
    (r"Input should be a valid number\b.*", r"cần một số"),
    (r"Option ('.*?') requires an argument\.?", r"Tùy chọn \1 cần một giá trị."),
    (r"Option ('.*?') requires (\d+) arguments\.?", r"Tùy chọn \1 cần \2 giá trị."),
    (r"Got unexpected extra argument\(s\) \((.*)\)", r"Thừa tham số: \1"),
)
"""What typer says of a command line that it cannot read."""


def run(command: Any, language: Language, **options: Any) -> int:
    """Run the command line; returns the exit status, with what typer refuses said in a language."""
    try:
        status = command(standalone_mode=False, **options)
    except typer.Abort:
        return 1
    except Exception as error:
        if not hasattr(error, "format_message"):
            raise
        return _tell(error, language)
    return status if isinstance(status, int) else 0


def _tell(error: Any, language: Language) -> int:
    context = getattr(error, "ctx", None)
    if type(error).__name__ == "NoArgsIsHelpError" or context is None:
        error.show()
    else:
        said, usage = error.format_message().replace("Value error, ", ""), context.get_usage()
        hint, label = f"Try '{context.command_path} -h' for help.", "Error"
        if language == "vi":
            for english, vietnamese in _REFUSED:
                said = re.sub(english, vietnamese, said)
            usage = usage_in_vietnamese(usage)
            hint, label = f"Gõ '{context.command_path} --help' để xem hướng dẫn.", "Lỗi"
        typer.echo(f"{usage}\n{hint}\n\n{label}: {said}", err=True)
    return int(error.exit_code)
