"""Case files: TOML to a Case and back, with every error of a file reported by key path."""

from catopt.casefile.reading import parse_case, read_case, read_mooring
from catopt.casefile.writing import TEMPLATES, case_digest, template, write_case

__all__ = [
    "TEMPLATES",
    "case_digest",
    "parse_case",
    "read_case",
    "read_mooring",
    "template",
    "write_case",
]
