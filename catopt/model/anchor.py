"""What holds the line at the bed: a sinker by its weight, or an anchor that digs in."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from catopt.compiled import inlined
from catopt.model.validity import Findings

AnchorKind = Literal["sinker", "drag"]
ANCHOR_KINDS: tuple[str, ...] = get_args(AnchorKind)


@dataclass(frozen=True)
class Anchor:
    """A sinker (deadweight anchor) or a drag anchor.

    Attributes
    ----------
    kind : {"sinker", "drag"}
        Held by its weight and its friction on the soil, or by what its flukes dig into.
    submerged_weight : float or None
        Of a sinker, N; None for a drag anchor.
    friction : float or None
        Of a sinker on the soil, tan(delta); None for a drag anchor.
    holding_capacity : float or None
        Ultimate horizontal holding capacity of a drag anchor, N; None for a sinker.
    safety_factor : float or None
        On sliding or on the holding capacity; None: that of the codes that are checked.
    safety_factor_line_out : float or None
        The same with one line of a body out; None: as for the intact mooring.
    factor_source : str
        Document and place that `safety_factor` is from; empty for the user's own number.
    mass : float or None
        In air, kg; None when not known.
    """

    kind: AnchorKind
    submerged_weight: float | None = None
    friction: float | None = None
    holding_capacity: float | None = None
    safety_factor: float | None = None
    safety_factor_line_out: float | None = None
    factor_source: str = ""
    mass: float | None = None

    def __post_init__(self) -> None:
        found = Findings("Anchor", self)
        found.word("kind", self.kind, ANCHOR_KINDS)
        found.raise_if_any()
        wanted = {
            "sinker": {"submerged_weight": "N", "friction": ""},
            "drag": {"holding_capacity": "N"},
        }
        noun = {"sinker": "sinker", "drag": "drag anchor"}[self.kind]
        units = wanted["sinker"] | wanted["drag"]
        for key, unit in units.items():
            value = getattr(self, key)
            if key in wanted[self.kind]:
                if value is None:
                    found.add(key, "", f"missing; a {noun} needs it")
                else:
                    found.number(key, value, unit, above=0.0)
            elif value is not None:
                found.add(key, f"{value:g}", f"does not go with a {noun}; leave it out")
        found.numbers(self, "", "safety_factor", "safety_factor_line_out", at_least=1.0)
        found.numbers(self, "kg", "mass", above=0.0)
        if self.factor_source and self.safety_factor is None:
            found.add("factor_source", "", "goes with safety_factor, which is missing")
        found.raise_if_any()


@inlined
def sinker_needed(horizontal: float, vertical: float, friction: float, factor: float) -> float:
    """Weight in water of a sinker that just does not slide: V + SF H / mu, N.

    From mu (W - V) >= SF H. H and V are of the line on the sinker, N, V positive where it lifts;
    the factor is on H.
    """
    return vertical + factor * horizontal / friction
