"""Case files: TOML to a Case and back, with every error of a file reported by key path."""

from catopt.casefile.new_case import TEMPLATES, template
from catopt.casefile.reading import parse_case, read_case, read_mooring
from catopt.casefile.writing import case_digest, write_case

__all__ = [
    "TEMPLATES",
    "case_digest",
    "parse_case",
    "read_case",
    "read_mooring",
    "template",
    "write_case",
]
