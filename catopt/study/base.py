"""What all members of a study have in common."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from catopt.casefile.sizing_file import Moored
from catopt.study.quantities import KEPT, Kept

Computed = Literal["statics", "checks", "motion", "linear", "sizing"]


@dataclass(frozen=True)
class Base:
    """What all members have in common.

    Attributes
    ----------
    document : dict
        Of the case file, or of the file for ``catopt size``, as the TOML reader returns it.
    source, folder : str
        Its name, for messages, and where paths in it count from.
    compute : {"statics", "checks", "motion", "linear", "sizing"}
        What is computed.
    moored : {"buoy", "tanker"} or None
        Of what the file is for ``catopt size``; None for a case file.
    proof : {"step", "none"}
        Of a run in time.
    """

    document: dict[str, Any]
    source: str
    folder: str
    compute: Computed
    moored: Moored | None = None
    proof: Literal["step", "none"] = "step"

    @property
    def kept(self) -> tuple[Kept, ...]:
        """What is kept of each member."""
        at_rest = "system" if "system" in self.document else "line"
        return KEPT[at_rest if self.compute == "statics" else self.compute]
