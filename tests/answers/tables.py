"""Tables of an answer by their names, as they stand in files."""

from __future__ import annotations

import pandas as pd

from catopt.answers.blocks import Answer, Facts, Table


def tables_of(answer: Answer) -> dict[str, pd.DataFrame]:
    """Return every table and list of an answer."""
    blocks = [each for each in answer.blocks if isinstance(each, Table | Facts)]
    return {each.name: each.to_dataframe() for each in blocks}
