"""What holds the line at the bed: a sinker by its weight, or an anchor that digs in."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from catopt.compiled import inlined
from catopt.model.kinds import Factor, Findings, Length, Mass, Positive, Source, Strength
from catopt.model.plausible_ranges import Plausible
from catopt.words import Message

AnchorKind = Literal["sinker", "drag"]
ANCHOR_KINDS: tuple[str, ...] = get_args(AnchorKind)

_NEEDS = {"sinker": ("submerged_weight", "friction"), "drag": ("holding_capacity",)}


@dataclass(frozen=True)
class Anchor(Plausible):
    """A sinker (deadweight anchor) or a drag anchor."""

    kind: AnchorKind
    """Held by its weight and its friction on the soil, or by what its flukes dig into."""
    submerged_weight: Strength | None = None
    """Of a sinker, N; None for a drag anchor."""
    friction: Positive | None = None
    """Of a sinker on the soil, tan(delta); None for a drag anchor."""
    holding_capacity: Strength | None = None
    """Ultimate horizontal holding capacity of a drag anchor, N; None for a sinker."""
    safety_factor: Factor | None = None
    """On sliding or on the holding capacity; None: that of the codes that are checked."""
    safety_factor_line_out: Factor | None = None
    """The same with one line of a body out; None: as for the intact mooring."""
    factor_source: Source = ""
    """Document and place that `safety_factor` is from; empty for the user's own number."""
    mass: Mass | None = None
    """In air, kg; None when not known."""
    max_slide: Length | None = None
    """How far a sinker may slide in the storm, in motion, m, in the place of a factor on sliding;
    None: that factor holds. It needs the mass."""
    base_holding: Strength | None = None
    """Of a sinker on clay, the largest horizontal pull that the soil holds on its base, N, whatever
    it weighs: adhesion times area; None where friction alone holds."""

    def _check(self, found: Findings) -> None:
        found.check("kind")
        found.raise_if_any()
        for key in (*_NEEDS["sinker"], *_NEEDS["drag"]):
            value = getattr(self, key)
            if key not in _NEEDS[self.kind]:
                if value is not None:
                    found.add(key, f"{value:g}", Message(f"refused.not_with_{self.kind}"))
            elif value is None:
                found.add(key, "", Message(f"refused.needed_by_{self.kind}"))
            else:
                found.check(key)
        if self.base_holding is not None and self.kind != "sinker":
            found.add("base_holding", f"{self.base_holding:g}", Message("refused.not_with_drag"))
        found.check("base_holding", "safety_factor", "safety_factor_line_out", "mass", "max_slide")
        if self.max_slide is not None and self.kind != "sinker":
            found.add("max_slide", f"{self.max_slide:g} m", Message("refused.not_with_drag"))
        elif self.max_slide is not None and self.mass is None:
            found.add("mass", "", Message("refused.needed_by_max_slide"))
        found.check("factor_source")
        if self.factor_source and self.safety_factor is None:
            found.add("factor_source", "", Message("refused.with_safety_factor"))


@inlined
def sinker_needed(horizontal: float, vertical: float, friction: float, factor: float) -> float:
    """Weight in water of a sinker that just does not slide: V + SF H / mu, N.

    From mu (W - V) >= SF H. H and V are of the line on the sinker, N, V positive where it lifts;
    the factor is on H.
    """
    return vertical + factor * horizontal / friction
