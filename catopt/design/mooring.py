"""Whole moorings evaluated in one call: equal lines about a body, whole and with each gone."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Final

import numpy as np
from numpy.typing import NDArray

from catopt.catenary.solve import solve
from catopt.checks.criteria import Criteria, criteria_of
from catopt.checks.evaluation import NO_CHECK
from catopt.compiled import compiled
from catopt.design.assess import BOUNDS, COST, MASS
from catopt.design.assess_mooring import Search, assess_moorings
from catopt.design.evaluation import Assessed, DesignProblem
from catopt.design.front import Floats, Genes
from catopt.design.mooring_point import mooring_point, under
from catopt.design.result import DesignLoadCase, DesignPoint
from catopt.design.space import (
    ClumpWeightVariable,
    DesignSpace,
    LayoutVariable,
    SegmentVariable,
    resolve,
)
from catopt.design.tables import MooringTables, body_room, mooring_tables, room, tables_of
from catopt.model import Case, Design, DesignLoad, LoadCase, System
from catopt.model.design import loads_of
from catopt.model.kinds import Findings
from catopt.words import Message

_A_LINE: Final = 4e-4
"""Time that a line of a mooring takes in one state as plain Python, s."""
BLOCK: Final = 2**20
"""Designs that are sorted by mass at once."""
BATCHES: Final = 64, 4096
"""Designs evaluated at once, at first and later: each batch is bounded by the front before it."""


@dataclass(frozen=True)
class MooringProblem(DesignProblem):
    """A body's case with its design space and evaluation.

    The states, as load cases of a line, are the mooring with all lines and without one.
    """

    mooring: MooringTables

    least_share: ClassVar[int] = 8

    @classmethod
    def of(cls, case: Case) -> MooringProblem:
        """Make the problem of a case with a body.

        InputError: a figure that objectives or checks need is missing, anchors are
        nearer than fairleads, or a line might be made that does not stretch at all; all at once.
        """
        design, system = case.design, case.own_system
        assert design is not None
        found = Findings("design")
        loads = loads_of(design, system)
        layout = _layout(design, system, loads, found)
        found.raise_if_any()
        criteria = criteria_of(case)
        space, remarks = resolve(case, criteria, _states(loads))
        _check_stretch(space, found)
        found.raise_if_any()
        warnings = (*remarks, *criteria.warnings, *_unlooked(criteria, loads))
        return cls._made(case, replace(space, layout=layout), criteria, loads, warnings)

    @classmethod
    def of_present(cls, case: Case) -> MooringProblem:
        """Make the problem whose only design is the mooring of the case file."""
        assert case.design is not None
        line, legs = case.line, case.own_system.legs
        weights = tuple(
            ClumpWeightVariable(
                (load.mass or 0.0,),
                (load.submerged_weight,),
                (load.position,),
                name=load.name,
                friction=load.friction,
            )
            for load in line.point_loads
        )
        space = DesignSpace(
            tuple(SegmentVariable((each,), (each.length,)) for each in line.segments),
            weights,
            LayoutVariable((tuple(leg.azimuth for leg in legs),), (legs[0].anchor_radius,)),
        )
        return cls._made(case, space, criteria_of(case), loads_of(case.design, case.own_system), ())

    @classmethod
    def _made(
        cls,
        case: Case,
        space: DesignSpace,
        criteria: Criteria,
        loads: Sequence[DesignLoad],
        warnings: tuple[str, ...],
    ) -> MooringProblem:
        states = _states(loads)
        line = tables_of(case, states, space, criteria, None)
        line, mooring = mooring_tables(case, loads, space, line, criteria)
        return cls(case, states, space, line, warnings, mooring)

    def assess(self, genes: Genes, **settings: Any) -> Assessed:
        """Solve and check many moorings; as of single lines, with designs excluded by bounds."""
        found = super().assess(genes, **settings)
        bounds = found.sinker  # the loop writes there which bound has excluded a design
        by_bound = np.bincount(bounds[bounds >= 0], minlength=len(BOUNDS))
        return found._replace(
            sinker=np.full(len(genes), -1, dtype=np.int64), excluded=tuple(by_bound.tolist())
        )

    def _loop(
        self, designs: int, stops_early: bool, best: Floats | None
    ) -> tuple[Callable[..., None], Callable[[], tuple[Any, ...]]]:
        """Return the loop over so many designs, and what makes its tables and a thread's room."""
        tables, columns = self.mooring, np.array(self.columns, dtype=np.int64)
        known = np.empty((0, self.objectives)) if best is None else best
        known = np.ascontiguousarray(known)
        states = len(tables.missing) / len(tables.lines)
        loop = compiled(assess_moorings, _A_LINE * float(tables.lines.mean()) * states * designs)

        def given() -> tuple[Any, ...]:
            least = np.empty(len(columns))
            search = Search(best is not None, stops_early, least, known, columns)
            rooms = room(self.tables), *body_room(tables, self.tables)
            return tables, self.tables, search, *rooms

        return loop, given

    def point(self, genes: tuple[int, ...]) -> DesignPoint:
        """Solve and check a mooring in plain closed form; errors as for `solve_system`."""
        line, found = self.space.line(genes), mooring_point(self, genes)
        lines = len(found.system.legs)
        objectives = self._by_key(line, found.offset, None, found.anchor_load, lines)
        return DesignPoint(line, self.case.anchor, genes, objectives, found.checks, found)

    def load_cases(self, best: DesignPoint) -> tuple[DesignLoadCase, ...]:
        """List every load from every side."""
        del best
        return tuple(
            DesignLoadCase(
                under(load, angle),
                "extreme",
                load.water_level,
                load.force,
                self.case.fairlead_height + load.lift,
                angle,
                load.line_out,
            )
            for load in self.loads
            for angle in load.directions
        )

    def present(self) -> DesignPoint:
        """Check the mooring of the case."""
        own = MooringProblem.of_present(self.case)
        return own.point((0,) * len(own.sizes))

    def batches(self, chunk: int) -> Iterator[Genes]:  # noqa: ARG002 - the same for every machine
        """Yield all designs by rising mass within each block, the first batches small.

        Lighter designs come first, so that what a heavier one would have to be better than is
        known; their sizes depend on nothing, so that the number excluded does not either.
        """
        size, largest = BATCHES
        for first in range(0, self.space.count, BLOCK):
            genes = self.space.genes_between(first, min(first + BLOCK, self.space.count))
            genes = genes[np.argsort(self._masses(genes), kind="stable")]
            start = 0
            while start < len(genes):
                yield genes[start : start + size]
                start += size
                size = min(2 * size, largest)

    def _masses(self, genes: Genes) -> NDArray[np.float64]:
        """Mass, or cost where no mass is known, by which designs are put in order."""
        by = self.tables.price if np.isnan(self.tables.mass).all() else self.tables.mass
        line = self.tables
        total = np.zeros(len(genes))
        for s in range(len(line.segment_optional)):
            option = genes[:, 2 * s] - line.segment_optional[s]
            own = line.length[s, genes[:, 2 * s + 1]] * np.nan_to_num(by[s, np.maximum(option, 0)])
            total += np.where(option >= 0, own, 0.0)
        lines = self.mooring.lines[genes[:, -2]]
        step = self.tables.step[MASS if by is self.tables.mass else COST]
        rounded: NDArray[np.float64] = np.floor(lines * total / step + 0.5)
        return rounded

    @property
    def loads(self) -> tuple[DesignLoad, ...]:
        """What the body has to meet."""
        return loads_of(self.design, self.case.own_system)

    def pretension(self, genes: tuple[int, ...]) -> float | None:
        """Horizontal force in each line with the body at its origin, N, where it is chosen."""
        assert self.space.layout is not None
        known = self.space.layout.pretensions
        return known[genes[-1]] if known else None

    def system(self, genes: tuple[int, ...], lift: float = 0.0) -> System:
        """Build the body with the lines of a design, its fairleads so much higher, m.

        It is under the force of the case, or its first load where it has none.
        """
        assert self.space.layout is not None
        own, load = self.case.own_system, self.loads[0]
        first = own.legs[0]
        line = self.space.line(genes)
        pretension = self.pretension(genes)
        if pretension is None:
            radius = self.space.layout.radii[genes[-1]]
        else:
            solution = solve(line, horizontal_force=pretension, **self.case.place)
            radius = solution.span + first.fairlead_radius
        return System.around(
            line,
            azimuths=self.space.layout.azimuths[genes[-2]],
            anchor_radius=radius,
            fairlead_height=first.fairlead_height + lift,
            fairlead_radius=first.fairlead_radius,
            anchor_height=first.anchor_height,
            seabed_friction=own.seabed_friction,
            force=own.force if any(own.force) else load.towards(load.direction),
            moment=own.moment,
            yaw_free=own.yaw_free,
        )


def _states(loads: Sequence[DesignLoad]) -> tuple[LoadCase, ...]:
    """Name the states of the mooring, as load cases of a line."""
    force = max(load.force for load in loads)
    intact = LoadCase("intact", force)
    if not any(load.line_out for load in loads):
        return (intact,)
    return intact, LoadCase("one line out", force, state="one_line_out")


def _layout(
    design: Design, system: System, loads: Sequence[DesignLoad], found: Findings
) -> LayoutVariable:
    """Gather the numbers of lines and the radii."""
    own = tuple(leg.azimuth for leg in system.legs)
    regular = tuple(
        tuple(own[0] + 2.0 * np.pi * k / number for k in range(number)) for number in design.lines
    )
    first = system.legs[0]
    radii = () if design.pretensions else design.anchor_radii or (first.anchor_radius,)
    if radii and radii[0] <= first.fairlead_radius:
        arm = first.fairlead_radius
        allowed = Message("refused_case.must_be_above_m_fairlead", fairlead_radius=arm)
        found.add("design.anchor_radii", f"{radii[0]:g} m", allowed)
    gone = [i for i, load in enumerate(loads) if load.line_out]
    if gone and min(map(len, regular or (own,))) < 2:
        key = f"design.loads[{gone[0]}].line_out" if design.loads else "design.line_out"
        found.add(key, "true", Message("refused_case.with_one_line_alone_none"))
    return LayoutVariable(regular or (own,), radii, design.pretensions)


def _check_stretch(space: DesignSpace, found: Findings) -> None:
    """Find that a line may be made of nothing that stretches, which no start is sure to reach."""
    for variable in space.segments:
        if not variable.is_optional and all(option.EA < np.inf for option in variable.options):
            return
    allowed = Message("refused_case.no_ea_known_some_lines")
    found.add("design.segments", Message("refused_file.do_not_stretch"), allowed)


def _unlooked(criteria: Criteria, loads: Sequence[DesignLoad]) -> Iterator[Message]:
    """Say that nothing is checked, or that no line is taken out though a criterion is for that."""
    if not criteria.all:
        yield Message(NO_CHECK)
    gone = any(load.line_out for load in loads)
    if not gone and any("intact" not in each.states for each in criteria.all):
        yield Message("design.line_out_not_asked")
