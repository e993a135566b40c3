"""Random lines of every kind, each from (seed, index) alone."""

from __future__ import annotations

import math
from dataclasses import dataclass
from random import Random

from catopt.model import Case, Line, Load, PointLoad, Segment, Site

KINDS = (
    "ordinary",
    "plain",
    "raised anchor",
    "buoyant",
    "buoyant, raised",
    "weightless part",
    "extreme weights",
    "extreme, buoyant",
)
KNOWN = ("horizontal_force", "span", "fairlead_tension")


@dataclass(frozen=True)
class Trial:
    """A line, where it is moored and what is known of it; SI."""

    line: Line
    height: float
    anchor_height: float
    friction: float
    known: str
    value: float
    kind: str = ""
    index: int = -1

    @property
    def rise(self) -> float:
        return self.height - self.anchor_height

    @property
    def shape(self) -> tuple[int, int, str]:
        """What lines must share to be gathered into one call of solve_many."""
        return len(self.line.segments), len(self.line.point_loads), self.known

    @property
    def is_inextensible(self) -> bool:
        return all(math.isinf(segment.EA) for segment in self.line.segments)

    @property
    def is_buoyant(self) -> bool:
        return any(s.submerged_weight < 0.0 for s in self.line.segments) or any(
            p.submerged_weight < 0.0 for p in self.line.point_loads
        )

    @property
    def case(self) -> Case:
        """Return the case file's contents."""
        return Case(
            site=Site(
                max(self.height, 1e-3), seabed_friction=self.friction, accept=("water_depth",)
            ),
            line=self.line,
            load=Load(**{self.known: self.value}),
            fairlead_height=self.height,
            anchor_height=self.anchor_height,
            title=f"{self.kind}, number {self.index}",
        )


def draw(seed: int, index: int) -> Trial:
    """Draw one line: what is known and the kind go round with the index, the rest is random."""
    rng = Random(f"{seed}:{index}")
    known = KNOWN[index % 3]
    kind = KINDS[index // 3 % len(KINDS)]
    total = _log(rng, 0.1, 11e3)
    segments = _segments(rng, kind, total)
    length = math.fsum(segment.length for segment in segments)
    line = Line(segments, _point_loads(rng, kind, segments, length))
    height, anchor_height = _heights(rng, kind, line)
    friction = 0.0 if rng.random() < 0.3 else rng.uniform(0.0, 2.0)
    trial = Trial(line, height, anchor_height, friction, known, 1.0, kind, index)
    value = {
        "horizontal_force": _horizontal_force,
        "span": _span,
        "fairlead_tension": _fairlead_tension,
    }[known](rng, trial)
    return Trial(line, height, anchor_height, friction, known, value, kind, index)


def gross_weight(line: Line) -> float:
    """Weight and buoyancy of all parts, both counted as positive, N; 1 for a line without any."""
    parts = [abs(s.submerged_weight) * s.length for s in line.segments]
    return math.fsum([*parts, *(abs(p.submerged_weight) for p in line.point_loads)]) or 1.0


def _log(rng: Random, low: float, high: float) -> float:
    return low * math.exp(rng.random() * math.log(high / low))


def _segments(rng: Random, kind: str, total: float) -> list[Segment]:
    count = 1 if rng.random() < 0.25 else rng.randint(1, 6)
    heaviest = _log(rng, 1.0, 1e4)
    ratio = 30.0 if kind == "ordinary" else 1e9 if kind.startswith("extreme") else 1e4
    shares = [_log(rng, 0.01, 1.0) for _ in range(count)]
    floating = rng.random() < 0.5
    stretches = rng.random() < 0.6
    whole = math.fsum(shares)
    segments = []
    for share in shares:
        weight = heaviest / _log(rng, 1.0, ratio)
        if kind == "weightless part" and rng.random() < 0.5:
            weight = 0.0
        elif "buoyant" in kind and floating and rng.random() < 0.4:
            weight = -weight
        EA = math.inf
        if stretches and rng.random() < 0.8:
            # As ropes and chains are, or anything.
            usual = heaviest * total * _log(rng, 3.0, 1e5)
            EA = max(usual if rng.random() < 0.5 else _log(rng, 1e3, 1e12), 1e3)
        segments.append(Segment(total * share / whole, weight, EA))
    return segments


def _point_loads(rng: Random, kind: str, segments: list[Segment], length: float) -> list[PointLoad]:
    count = rng.randint(1, 4) if rng.random() < 0.5 else 0
    if "buoyant" in kind and all(s.submerged_weight >= 0.0 for s in segments):
        count = max(count, 1)
    weight = math.fsum(abs(s.submerged_weight) * s.length for s in segments) or 100.0
    joints = [math.fsum(s.length for s in segments[:k]) for k in range(1, len(segments))]
    loads: list[PointLoad] = []
    for number in range(count):
        place = rng.random()
        if place < 0.1 and joints:
            position = rng.choice(joints)
        elif place < 0.15 and loads:
            position = loads[-1].position
        else:
            position = length * rng.uniform(0.001, 0.999)
        size = weight * _log(rng, 1e-3, 3.0)
        floats = "buoyant" in kind and (number == 0 or rng.random() < 0.4)
        loads.append(PointLoad(position, -size if floats else size))
    return [load for load in loads if 0.0 < load.position < length]


def _heights(rng: Random, kind: str, line: Line) -> tuple[float, float]:
    """Heights of the fairlead and of the anchor above the bed, m."""
    length = line.length
    steep = rng.random()
    rise = length * (
        rng.uniform(0.02, 0.98)
        if steep < 0.75
        else 1.0 - _log(rng, 1e-12, 0.02)
        if steep < 0.82
        else _log(rng, 1e-6, 0.02)
        if steep < 0.9
        else 0.0
        if steep < 0.95
        else rng.uniform(1.0, 1.2)
    )
    if kind == "ordinary":
        rise = length * rng.uniform(0.1, 0.95)
    is_raised = "raised" in kind or (
        kind in ("weightless part", "extreme weights", "extreme, buoyant") and rng.random() < 0.4
    )
    if not is_raised:
        return rise, 0.0
    base = length * _log(rng, 1e-4, 1.0)
    return (base, base + rise) if rng.random() < 0.35 else (base + rise, base)


def _horizontal_force(rng: Random, trial: Trial) -> float:
    weight = gross_weight(trial.line)
    way = rng.random()
    if way < 0.1:
        return max(weight * _log(rng, 1e-18, 1e-9), 1e-25)
    if way < 0.2:
        return weight * _log(rng, 1e4, 1e9)
    return weight * (_log(rng, 1e-3, 1e2) if way < 0.7 else _log(rng, 1e-9, 1e4))


def _span(rng: Random, trial: Trial) -> float:
    length, rise = trial.line.length, abs(trial.rise)
    straight = math.sqrt(max(length * length - rise * rise, 0.0))
    folded = max(length - trial.height - trial.anchor_height, 0.0)
    way = rng.random()
    if way < 0.2 and folded > 0.0:
        return folded * rng.uniform(1e-3, 1.0)
    if way < 0.25:
        return length * _log(rng, 1e-9, 1e-2)
    if way < 0.65 and straight > 0.0:
        return max(folded + (straight - folded) * rng.random(), 1e-6 * length)
    if way < 0.85 and straight > 0.0:
        return straight * (1.0 - _log(rng, 1e-12, 1e-2))
    return max(straight, 1e-3 * length) * (1.0 + _log(rng, 1e-9, 1.0))


def _fairlead_tension(rng: Random, trial: Trial) -> float:
    weight = gross_weight(trial.line)
    # What must hang from the fairlead: less is too small, and little more is just enough.
    least = max(_uppermost(trial.line, min(trial.height, trial.line.length)), 1e-9 * weight)
    way = rng.random()
    if way < 0.12:
        return least * (1.0 - _log(rng, 1e-9, 0.999))
    if way < 0.3:
        return least * (1.0 + _log(rng, 1e-9, 0.1))
    if way < 0.85:
        return least + weight * _log(rng, 1e-4, 1e2)
    return weight * _log(rng, 1e-8, 1e6)


def _uppermost(line: Line, length: float) -> float:
    """Weight of the uppermost `length` of the line, N."""
    reach = line.length - length
    weight = math.fsum(p.submerged_weight for p in line.point_loads if p.position > reach)
    top = line.length
    for segment in reversed(line.segments):
        low = max(top - segment.length, reach)
        weight += segment.submerged_weight * max(top - low, 0.0)
        top -= segment.length
    return weight
