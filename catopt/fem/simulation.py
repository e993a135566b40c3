"""Lines, their body, the sea and a state: brought to rest, set in motion, stepped in time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from catopt.compiled import compiled
from catopt.errors import NotConvergedError
from catopt.fem.energy_balance import EnergyBalance, begin_works, own_kinetic_energy
from catopt.fem.march import MarchReport, march
from catopt.fem.moving import Blend, BodyNode, Equations, Moving, MovingLines, WaterAt
from catopt.fem.moving_assembly import assemble_moving
from catopt.fem.newmark import Scheme, solve_moving
from catopt.fem.sampling import Record, Room, Rules, fill_energy, take_sample
from catopt.fem.seabed import drag_feet
from catopt.fem.series import SeriesRows, fill_series, series_rows
from catopt.fem.step_controls import StepControls, StepCounts
from catopt.fem.water_at import fill_water
from catopt.interrupt import waiting_interrupt
from catopt.waves import Sea
from catopt.words import Message, Several

Array = npt.NDArray[np.float64]

_HELD = BodyNode(np.zeros(3), np.zeros(3), np.zeros(3))
_STILL = Sea(1.0)
_AT_REST = Blend(0.0, 0.0, 1.0, 0.0, 0.0)
_REST_LIMIT = 500
_REST_TOLERANCE = 1e-9
_FEW_STEPS = 20
_TURN = 0.2
"""Change of place over a bar that a Newton step on the way to rest may bring, over its length."""
_OF_BARS = (
    "EA", "damping", "mass", "displaced", "added_normal", "added_tangential", "drag_normal",
    "drag_tangential", "weight", "weight_in_air",
)  # fmt: skip
"""What a bar has that breaks."""
_NEXT_TO_NOTHING = 1e-12
"""Part of its stiffness that a broken bar keeps: energies are divided by it."""
_A_BAR = 2e-4
"""Time that a bar takes in one iteration as plain Python, s."""
_ITERATIONS = 3
"""Of a step, about."""
_PIECE = 0.1
"""Seconds of computing between two looks at Ctrl-C and calls of `progress`, about."""


class Break(NamedTuple):
    """Where and when a line parts.

    `line`: from 0; `sample`: after which one; `at_anchor`: at its anchor, whose end is then free;
    otherwise at its fairlead: its last bar is then gone.
    """

    line: int
    sample: int
    at_anchor: bool = False


class Simulation:
    """Lines in motion.

    Parameters
    ----------
    lines : MovingLines
        What moves.
    x : ndarray, shape (nodes, 3)
        Where the nodes start, m.
    body : BodyNode, optional
        What the last nodes are fixed to; held or led in all directions by default.
    led : SeriesRows, optional
        Where the last nodes are led, and after them the first ones, if these are; by default they
        stay.
    load : SeriesRows, optional
        Force on the body, N.
    sea : Sea, optional
        Still water everywhere by default.

    Attributes
    ----------
    state : Moving
        Where the lines are now.
    counts : StepCounts
        What all steps so far took.
    """

    def __init__(
        self,
        lines: MovingLines,
        x: Array,
        *,
        body: BodyNode = _HELD,
        led: SeriesRows | None = None,
        load: SeriesRows | None = None,
        sea: Sea | None = None,
    ) -> None:
        self.lines = lines
        self.body = body
        self.sea = sea
        ends = lines.start[1:] + np.arange(lines.start.size - 1)
        self.led = led or series_rows(x[ends], [None] * ends.size, 0.0)
        self.load = load or series_rows(np.zeros((1, 3)), [None], 0.0)
        self.state = _moving(lines, np.array(x, dtype=float))
        self.counts = StepCounts()
        self._gone = 0.0
        self._before_break: float | None = None
        nodes, bars = x.shape[0], lines.length.size
        still = np.full(nodes, np.inf)
        flow = np.zeros((3, nodes, 3))
        water = WaterAt(flow[0], flow[1], flow[2], still, np.ones((bars, 2)))
        self._room = Room(
            now=_moving(lines, np.array(x, dtype=float)),
            water=water,
            water_before=np.zeros((nodes, 3)),
            equations=Equations(*np.zeros((3, nodes, 3, 3)), *np.zeros((2, nodes, 3))),
            small=np.zeros((2, 3, 3)),
            force=np.zeros(3),
            slope=np.zeros(bars),
            highest=np.zeros(1),
            change=np.zeros((nodes, 3)),
            booked=np.zeros((4, nodes, 3)),
            booked_before=np.zeros((4, nodes, 3)),
            ends=np.zeros((ends.size, 2, 3)),
            ends_before=np.zeros((ends.size, 2, 3)),
            wet_before=np.ones((bars, 2)),
        )

    def _form(self, function: Callable[..., Any], visits: int = 1) -> Callable[..., Any]:
        """Give a kernel function for some visits to every bar, plain or compiled."""
        return compiled(function, _A_BAR * visits * self.lines.length.size)

    def assemble(self, blend: Blend, t: float = 0.0) -> tuple[float, int]:
        """Balance of all nodes as they are, without waves; see `assemble_moving`."""
        if self.sea is not None:
            self._form(fill_water)(
                t, self.state.x, self.lines.start, self.sea.flow_at_rest, 0.0,
                self._room.water_before, self._room.water,
            )  # fmt: skip
        worst, node = self._form(assemble_moving)(
            self.lines, self.body, self._room.water, self.load.base[0].copy(), self.state,
            self.state, blend, self._room.equations,
        )  # fmt: skip
        return float(worst), int(node)

    def assemble_as(self, lines: MovingLines, blend: Blend) -> None:
        """Assemble with other figures of the same lines, where they are."""
        own, self.lines = self.lines, lines
        try:
            self.assemble(blend)
        finally:
            self.lines = own

    def water_at_rest(self) -> WaterAt:
        """Return the water about the lines as they are, without waves; overwritten by the next."""
        self.assemble(_AT_REST)
        return self._room.water

    @property
    def rounding(self) -> float:
        """Force that a bar may be off by because coordinates have 16 digits, over the unit."""
        stiffest = float((self.lines.EA / self.lines.length).max())
        reach = float(np.abs(self.state.x).max())
        unit = max(self.lines.force_scale, float(np.abs(self.state.tension).max()))
        return 4.0 * float(np.finfo(float).eps) * stiffest * reach / unit

    @property
    def equations(self) -> Equations:
        """As `assemble` or a step left them."""
        return self._room.equations

    def settle(self, *, rubbed: bool = False) -> None:
        """Bring the lines to rest from where they are, in the current and without waves.

        Newton's method; a node is held to where it is by a spring that fades as forces balance.

        Parameters
        ----------
        rubbed : bool
            Friction of the bed takes what the bars leave over along it, as far as it can; without,
            the line lies as if it had been laid down without friction.

        Raises
        ------
        NotConvergedError
            With the node and the force left over there.
        """
        at = self.state
        self._stand_still()
        self.assemble(_AT_REST)
        if rubbed and self.lines.friction.any():
            lies = at.reaction > 0.0
            at.foot[lies] = (
                at.x[lies, :2] - at.force[lies, :2] / self.lines.drag_spring[lies, np.newaxis]
            )
            drag_feet(self.lines, at, 0.0)
        self.find_rest()

    def hold_ends(self) -> None:
        """Hold the last nodes where they are now, whatever they were free to do or pushed by."""
        ends = self.state.x[self.lines.start[1:] + np.arange(self.lines.start.size - 1)]
        self.body = _HELD
        self.led = series_rows(ends, [None] * len(ends), 0.0)
        self.load = series_rows(np.zeros((1, 3)), [None], 0.0)
        self.assemble(_AT_REST)

    def _stand_still(self) -> None:
        """Take all speed and friction away, and lift what is below the bed."""
        at, lines = self.state, self.lines
        at.v[:] = 0.0
        at.a[:] = 0.0
        at.foot[:] = np.nan
        # A softer bed than this one, or a level one, may have been laid under the shape given.
        bed = (at.x[:, 0] * lines.bed_sin - lines.bed_depth) / lines.bed_cos
        has_bed = (lines.bed_stiffness > 0.0) & ~lines.held
        at.x[:, 2] = np.where(has_bed, np.maximum(at.x[:, 2], bed), at.x[:, 2])

    def find_rest(self) -> None:
        """Find the place at which no force is left over, from the one at hand and its friction.

        Raises
        ------
        NotConvergedError
            With the node and the force left over there.
        """
        at = self.state
        worst, node = self.assemble(_AT_REST)
        spring = self.lines.force_scale / float(self.lines.length.sum())
        hold = 1.0
        for _ in range(_REST_LIMIT):
            if worst <= max(_REST_TOLERANCE, self.rounding):
                break
            self._hold_nodes(spring * hold * min(worst, 1.0))
            solved = self._form(solve_moving)(
                self.lines, self.body, at, at, _AT_REST, self.equations, self._room.small
            )
            move = self.equations.rest.copy()
            move[self._anchors] = 0.0
            longest = float(np.abs(move).max())
            part = self._part_of(move, longest)
            if not solved or not np.isfinite(longest):
                hold *= 10.0
                worst, node = self.assemble(_AT_REST)
                continue
            at.x[:] += part * move
            last = worst
            worst, node = self.assemble(_AT_REST)
            if worst > 10.0 * last and part == 1.0:
                at.x[:] -= move
                hold *= 10.0
                worst, node = self.assemble(_AT_REST)
            else:
                hold = max(0.3 * hold, 1e-6)
        else:
            raise _not_closed("the lines did not come to rest", self, worst, node, None)
        self.slip_feet()

    def slip_feet(self) -> None:
        """Let the friction springs slip as far as they must, and take stock of the forces."""
        drag_feet(self.lines, self.state, 0.0)
        self.assemble(_AT_REST)

    def _part_of(self, move: Array, longest: float) -> float:
        """Part of a Newton step by which no node moves half a bar, or else no bar turns far."""
        first = np.arange(self.lines.length.size) + np.repeat(
            np.arange(self.lines.start.size - 1), np.diff(self.lines.start)
        )
        apart = np.linalg.norm(move[first + 1] - move[first], axis=1)
        turn = float((apart / self.lines.length).max())
        near = 0.5 * float(self.lines.length.min()) / max(longest, 1e-300)
        return min(1.0, max(near, _TURN / max(turn, 1e-300)))

    def start(self) -> None:
        """Find the accelerations with which the lines set off from the present state."""
        at = self.state
        at.a[:] = 0.0
        self._lead_accelerations()
        self.assemble(Blend(0.0, 0.0, 0.0, 0.0, 1.0))
        self._form(solve_moving)(
            self.lines, self.body, at, at, Blend(0.0, 0.0, 0.0, 0.0, 1.0), self.equations,
            self._room.small,
        )  # fmt: skip
        rest = self.equations.rest.copy()
        rest[self._anchors] = 0.0
        at.a[:] += rest
        self.assemble(Blend(0.0, 0.0, 1.0, 0.0, 0.0))
        self._room.now.foot[:] = at.foot

    def run(
        self,
        samples: int,
        every: int,
        step: float,
        *,
        scheme: Scheme | None = None,
        controls: StepControls | None = None,
        since: float = 0.0,
        nodes: Sequence[int] = (),
        energy: bool = False,
        tensions: bool = False,
        breaks: Break | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> tuple[Record, bool]:
        """Step in time and take samples, the first of them of the present state.

        Parameters
        ----------
        samples : int
            To be taken after the first.
        every : int
            Steps from one sample to the next.
        step : float
            s.
        scheme, controls : Scheme, StepControls, optional
            How to step.
        since : float
            Time from which envelopes are taken, s.
        nodes : sequence of int
            Whose places are kept.
        energy, tensions : bool
            Whether energies are, and the tension of every bar.
        breaks : Break, optional
            Where a line parts, and after which sample.
        progress : callable, optional
            Called with the time reached, s, some times a second.

        Returns
        -------
        record, complete : Record, bool
            Samples, and whether all were taken: Ctrl-C stops a run and keeps what is there.

        Raises
        ------
        NotConvergedError
            With the time, the node and the force left over there.
        """
        how, ways = scheme or Scheme(), controls or StepControls()
        rules = Rules(
            alpha_m=float(how.alpha_m),
            alpha_f=float(how.alpha_f),
            beta=float(how.beta),
            gamma=float(how.gamma),
            step=float(step),
            every=int(every),
            limit=int(ways.max_iterations),
            halvings=int(ways.max_halvings),
            refinements=int(ways.max_refinements),
            surprise=float(ways.surprise),
            tolerance=float(max(ways.tolerance, self.rounding)),
            since=float(since),
        )
        record = self._empty_record(samples + 1, nodes, energy, tensions)
        self._first_sample(rules, record)
        flow = (self.sea or _STILL).flow
        has_sea = self.sea is not None
        at, size, level = 0, 1, 0
        with waiting_interrupt() as ask:
            while at < samples:
                if breaks is not None and at == breaks.sample:
                    part = self._let_go if breaks.at_anchor else self._break
                    part(breaks.line, record)
                stop = breaks.sample if breaks is not None and at < breaks.sample else samples
                end, began = min(at + size, stop), perf_counter()
                march_on = self._form(march, (samples - at) * every * _ITERATIONS)
                report = MarchReport(
                    *march_on(
                        at, end, level, rules, self.lines, self.body, self.led, self.load, flow,
                        has_sea, self.state, self._room, record,
                    )
                )  # fmt: skip
                self.counts.add(report)
                if not report.done:
                    words = Message("truss.not_closed", time=report.time)
                    raise _not_closed(words, self, report.worst, report.node, step)
                at, level = end, report.level
                self._check_ringing(ways, step, at * every * step)
                try:
                    if progress is not None:
                        progress(at * every * step)
                    ask()
                except KeyboardInterrupt:
                    return _cut(record, at), False
                if perf_counter() - began < _PIECE:
                    size *= 2
        return record, True

    def balance(self, record: Record) -> EnergyBalance:
        """Book the energy of a run, from its record and the state at its end."""
        stored = np.zeros(4)
        fill_energy(self.lines, self.state, self._room, record.rest, stored)
        ends, water, drag, bed, friction, damping, kinetic, put_in = map(float, record.works)
        if self._before_break is not None:  # what is set free drives the lines as a force does
            put_in += max(0.0, self._before_break - float(stored[1:].sum()))
        return EnergyBalance(
            ends=ends,
            water=water,
            kinetic=kinetic + float(own_kinetic_energy(self.lines, self.state)),
            elastic=float(stored[1] + stored[3]) + self._gone,
            potential=float(stored[2]),
            drag=-drag,
            bed=-bed - float(stored[3]),
            friction=-friction,
            damping=-damping,
            put_in=put_in,
        )

    def _break(self, line: int, record: Record) -> None:
        """Take the last bar of a line away: no force, no mass, no drag; what it held is booked."""
        bar, at, held = int(self.lines.start[line + 1]) - 1, self.state, np.zeros((2, 4))
        fill_energy(self.lines, at, self._room, record.rest, held[0])
        changed = {name: getattr(self.lines, name).copy() for name in _OF_BARS}
        for name, values in changed.items():
            values[bar] *= _NEXT_TO_NOTHING if name in {"EA", "damping"} else 0.0
        self.lines = self.lines._replace(**changed)
        fill_energy(self.lines, at, self._room, record.rest, held[1])
        self._gone = float((held[0] - held[1])[1:3].sum())
        self._before_break = float(held[1, 1:].sum())
        pull, last = at.tension[bar] * at.axis[bar], bar + line + 1
        at.force[last - 1] -= pull
        at.force[last] += pull
        at.tension[bar] = self._room.slope[bar] = 0.0
        self._room.ends_before[line, 1] = 0.0

    def _let_go(self, line: int, record: Record) -> None:
        """Let the first node of a line move freely; what is stored then drives the lines."""
        held = np.zeros(4)
        fill_energy(self.lines, self.state, self._room, record.rest, held)
        self._before_break = float(held[1:].sum())
        free = self.lines.lower_free.copy()
        free[line] = True
        self.lines = self.lines._replace(lower_free=free)
        self._room.ends_before[line, 0] = 0.0

    def _check_ringing(self, controls: StepControls, step: float, t: float) -> None:
        count = self.counts
        if count.steps > _FEW_STEPS and count.ringing > controls.max_ringing * count.strain:
            part = count.ringing / count.strain
            raise NotConvergedError(
                Message("truss.rings", time=t, part=part, shortest=count.shortest, step=step)
            )

    def _first_sample(self, rules: Rules, record: Record) -> None:
        self._room.equations.acceleration[:] = self.state.a
        take_sample(0, rules, self.lines, self.led, self.body, self.state, self._room, record)
        room = self._room
        begin_works(
            self.lines, self.state, room.water, self.sea is not None, room.booked_before,
            record.works,
        )  # fmt: skip
        room.ends_before[:] = record.end_force[0]
        room.wet_before[:] = room.water.wet

    def _empty_record(
        self, samples: int, nodes: Sequence[int], energy: bool, tensions: bool
    ) -> Record:
        lines, bars = self.lines.start.size - 1, self.lines.length.size
        return Record(
            time=np.zeros(samples),
            end_force=np.zeros((samples, lines, 2, 3)),
            end_tension=np.zeros((samples, lines, 2)),
            fairlead=np.zeros((samples, lines, 3)),
            grounded=np.zeros((samples, lines)),
            place=np.zeros((samples, len(nodes), 3)),
            energy=np.zeros((samples if energy else 0, 4)),
            tension=np.zeros((samples if tensions else 0, bars)),
            chosen=np.array(list(nodes), dtype=np.int64),
            highest=np.full(bars, -np.inf),
            lowest=np.full(bars, np.inf),
            slack_time=np.zeros(bars),
            longest_slack=np.zeros(bars),
            slack_now=np.zeros(bars),
            end_highest=np.zeros((lines, 2)),
            end_time=np.zeros((lines, 2)),
            works=np.zeros(8),
            rest=self.state.x.copy(),
        )

    @property
    def _anchors(self) -> npt.NDArray[np.int64]:
        """First nodes that are held or led."""
        first = self.lines.start[:-1] + np.arange(self.lines.start.size - 1)
        return first[~self.lines.lower_free]

    def _hold_nodes(self, spring: float) -> None:
        diagonal = self.equations.diagonal
        for i in range(3):
            diagonal[:, i, i] += spring

    def _lead_accelerations(self) -> None:
        out = np.zeros((3, 3))
        for k, last in enumerate(self.lines.start[1:] + np.arange(self.lines.start.size - 1)):
            fill_series(0.0, self.led, k, out)
            held = self.body.free == 0.0
            self.state.x[last, held] = out[0, held]
            self.state.v[last, held] = out[1, held]
            self.state.a[last, held] = out[2, held]
        lines = self.lines.start.size - 1
        for row in range(lines, self.led.base.shape[0]):
            first = self.lines.start[row - lines] + row - lines
            fill_series(0.0, self.led, row, out)
            self.state.x[first], self.state.v[first], self.state.a[first] = out


def _moving(lines: MovingLines, x: Array) -> Moving:
    nodes, bars = x.shape[0], lines.length.size
    return Moving(
        x=x,
        v=np.zeros((nodes, 3)),
        a=np.zeros((nodes, 3)),
        axis=np.zeros((bars, 3)),
        tension=np.zeros(bars),
        force=np.zeros((nodes, 3)),
        reaction=np.zeros(nodes),
        rub=np.zeros((nodes, 2)),
        foot=np.full((nodes, 2), np.nan),
        body_force=np.zeros(3),
    )


def _cut(record: Record, last: int) -> Record:
    """Leave out the samples that were not taken."""
    names = (
        "time", "end_force", "end_tension", "fairlead", "grounded", "place", "energy", "tension",
    )  # fmt: skip
    return record._replace(**{name: getattr(record, name)[: last + 1] for name in names})


def _not_closed(
    words: str, of: Simulation, worst: float, node: int, step: float | None
) -> NotConvergedError:
    where = Message("truss.the_body")
    if node >= 0:
        firsts = of.lines.start + np.arange(of.lines.start.size)
        line = int(np.searchsorted(firsts, node, side="right")) - 1
        x, y, z = of.state.x[node]
        place = {"node": node - int(firsts[line]), "line": line + 1}
        where = Message("truss.at_node", x=float(x), y=float(y), z=float(z), **place)
    said = [Message("truss.left_over", what=words, worst=worst, where=where)]
    if step is not None:
        said.append(Message("truss.halved", step=step))
    return NotConvergedError(Several((*said, Message("truss.may_help")), " "))
