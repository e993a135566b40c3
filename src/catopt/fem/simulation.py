"""Lines, their body, the sea and a state: brought to rest, set in motion, stepped in time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from time import perf_counter

import numpy as np
import numpy.typing as npt

from catopt.compiled import compiled
from catopt.errors import NotConvergedError
from catopt.fem.energy_balance import EnergyBalance, fill_forces
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

__all__ = ["Simulation"]

Array = npt.NDArray[np.float64]

_HELD = BodyNode(np.zeros(3), np.zeros(3), np.zeros(3))
_STILL = Sea(1.0)
_REST_LIMIT = 500
_REST_TOLERANCE = 1e-9
_FEW_STEPS = 20
_TURN = 0.2
"""Change of place over a bar that a Newton step on the way to rest may bring, over its length."""
_PIECE = 0.1
"""Seconds of computing between two looks at Ctrl-C and calls of `progress`, about."""


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
        Where the last nodes are led; by default they stay.
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
        nodes, bars = x.shape[0], lines.length.size
        still = np.full(nodes, np.inf)
        water = WaterAt(_rows(nodes), _rows(nodes), _rows(nodes), still, np.ones((bars, 2)))
        self._room = Room(
            now=_moving(lines, np.array(x, dtype=float)),
            water=water,
            water_before=np.zeros((nodes, 3)),
            equations=Equations(
                _blocks(nodes), _blocks(nodes), _blocks(nodes), _rows(nodes), _rows(nodes)
            ),
            small=np.zeros((2, 3, 3)),
            force=np.zeros(3),
            slope=np.zeros(bars),
            highest=np.zeros(1),
            change=np.zeros((nodes, 3)),
            booked=np.zeros((3, nodes, 3)),
            booked_before=np.zeros((3, nodes, 3)),
            ends=np.zeros((ends.size, 2, 3)),
            ends_before=np.zeros((ends.size, 2, 3)),
            wet_before=np.ones((bars, 2)),
        )

    @property
    def node_count(self) -> int:
        """Nodes of all lines."""
        return int(self.state.x.shape[0])

    def assemble(self, blend: Blend, t: float = 0.0) -> tuple[float, int]:
        """Balance of all nodes as they are, without waves; see `assemble_moving`."""
        if self.sea is not None:
            calm = replace(self.sea, waves=None).flow
            compiled(fill_water)(
                t, self.state.x, self.lines.start, calm, 0.0, self._room.water_before,
                self._room.water,
            )  # fmt: skip
        worst, node = compiled(assemble_moving)(
            self.lines, self.body, self._room.water, self.load.base[0].copy(), self.state,
            self.state, blend, self._room.equations,
        )  # fmt: skip
        return float(worst), int(node)

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

    def settle(self, *, pulled: bool = False) -> None:
        """Bring the lines to rest from where they are, in the current and without waves.

        Newton's method; a node is held to where it is by a spring that fades as forces balance.

        Parameters
        ----------
        pulled : bool
            Friction of the bed takes what the bars leave over along it, as far as it can; without,
            the line lies as if it had been laid down without friction.

        Raises
        ------
        NotConvergedError
            With the node and the force left over there.
        """
        at, blend = self.state, Blend(0.0, 0.0, 1.0, 0.0, 0.0)
        at.v[:] = 0.0
        at.a[:] = 0.0
        at.foot[:] = np.nan
        # A softer bed than this one may have been laid under the shape that is given.
        at.x[:, 2] = np.where(
            (self.lines.bed_stiffness > 0.0) & ~self.lines.held,
            np.maximum(at.x[:, 2], -self.lines.bed_depth),
            at.x[:, 2],
        )
        worst, node = self.assemble(blend)
        if pulled and self.lines.friction.any():
            lies = at.reaction > 0.0
            at.foot[lies] = (
                at.x[lies, :2] - at.force[lies, :2] / self.lines.drag_spring[lies, np.newaxis]
            )
            compiled(drag_feet)(self.lines, at, 0.0)
            worst, node = self.assemble(blend)
        spring = self.lines.force_scale / float(self.lines.length.sum())
        hold = 1.0
        for _ in range(_REST_LIMIT):
            if worst <= max(_REST_TOLERANCE, self.rounding):
                break
            self._hold_nodes(spring * hold * min(worst, 1.0))
            solved = compiled(solve_moving)(
                self.lines, self.body, at, at, blend, self.equations, self._room.small
            )
            move = self.equations.rest.copy()
            move[self._anchors] = 0.0
            longest = float(np.abs(move).max())
            part = self._part_of(move, longest)
            if not solved or not np.isfinite(longest):
                hold *= 10.0
                worst, node = self.assemble(blend)
                continue
            at.x[:] += part * move
            last = worst
            worst, node = self.assemble(blend)
            if worst > 10.0 * last and part == 1.0:
                at.x[:] -= move
                hold *= 10.0
                worst, node = self.assemble(blend)
            else:
                hold = max(0.3 * hold, 1e-6)
        else:
            raise _not_closed("the lines did not come to rest", self, worst, node, None)
        compiled(drag_feet)(self.lines, at, 0.0)
        self.assemble(blend)

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
        compiled(solve_moving)(
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
        energy : bool
            Whether energies are.
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
        record = self._empty_record(samples + 1, nodes, energy)
        self._first_sample(rules, record)
        flow = (self.sea or _STILL).flow
        has_sea = self.sea is not None
        fast, at, size = compiled(march), 0, 1
        with waiting_interrupt() as ask:
            while at < samples:
                end, began = min(at + size, samples), perf_counter()
                report = MarchReport(
                    *fast(
                        at, end, rules, self.lines, self.body, self.led, self.load, flow, has_sea,
                        self.state, self._room, record,
                    )
                )  # fmt: skip
                self.counts.add(report)
                if not report.done:
                    words = f"the step at t = {report.time:.6g} s did not close"
                    raise _not_closed(words, self, report.worst, report.node, step)
                at = end
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
        compiled(fill_energy)(self.lines, self.state, self._room, record.rest, stored)
        ends, water, drag, bed, friction, damping, kinetic, put_in = map(float, record.works)
        return EnergyBalance(
            ends=ends,
            water=water,
            kinetic=kinetic,
            elastic=float(stored[1] + stored[3]),
            potential=float(stored[2]),
            drag=-drag,
            bed=-bed - float(stored[3]),
            friction=-friction,
            damping=-damping,
            put_in=put_in,
        )

    def _check_ringing(self, controls: StepControls, step: float, t: float) -> None:
        count = self.counts
        if count.steps > _FEW_STEPS and count.ringing > controls.max_ringing * count.strain:
            part = count.ringing / count.strain
            raise NotConvergedError(
                f"by t = {t:.6g} s the line rings: {part:.0%} of the energy of its "
                "tensions changes from step to step, down to the shortest of "
                f"{count.shortest:.3g} s, and they are not to be trusted. A time step shorter than "
                f"{step:g} s, more line damping, or generalised-alpha with a smaller spectral "
                "radius is wanted."
            )

    def _first_sample(self, rules: Rules, record: Record) -> None:
        self._room.equations.acceleration[:] = self.state.a
        compiled(take_sample)(
            0, rules, self.lines, self.led, self.body, self.state, self._room, record
        )
        room = self._room
        compiled(fill_forces)(
            self.lines, self.state, room.water, self.sea is not None, room.booked_before
        )
        room.ends_before[:] = record.end_force[0]
        room.wet_before[:] = room.water.wet

    def _empty_record(self, samples: int, nodes: Sequence[int], energy: bool) -> Record:
        lines, bars = self.lines.start.size - 1, self.lines.length.size
        return Record(
            time=np.zeros(samples),
            end_force=np.zeros((samples, lines, 2, 3)),
            end_tension=np.zeros((samples, lines, 2)),
            fairlead=np.zeros((samples, lines, 3)),
            grounded=np.zeros((samples, lines)),
            place=np.zeros((samples, len(nodes), 3)),
            energy=np.zeros((samples if energy else 0, 4)),
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
        return self.lines.start[:-1] + np.arange(self.lines.start.size - 1)

    def _hold_nodes(self, spring: float) -> None:
        diagonal = self.equations.diagonal
        for i in range(3):
            diagonal[:, i, i] += spring

    def _lead_accelerations(self) -> None:
        out = np.zeros((3, 3))
        for k, last in enumerate(self.lines.start[1:] + np.arange(self.lines.start.size - 1)):
            compiled(fill_series)(0.0, self.led, k, out)
            held = self.body.free == 0.0
            self.state.x[last, held] = out[0, held]
            self.state.v[last, held] = out[1, held]
            self.state.a[last, held] = out[2, held]


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


def _rows(nodes: int) -> Array:
    return np.zeros((nodes, 3))


def _blocks(nodes: int) -> Array:
    return np.zeros((nodes, 3, 3))


def _cut(record: Record, last: int) -> Record:
    """Leave out the samples that were not taken."""
    kept = {
        name: getattr(record, name)[: last + 1]
        for name in ("time", "end_force", "end_tension", "fairlead", "grounded", "place", "energy")
    }
    return record._replace(**kept)


def _not_closed(
    words: str, of: Simulation, worst: float, node: int, step: float | None
) -> NotConvergedError:
    where = "the body"
    if node >= 0:
        firsts = of.lines.start + np.arange(of.lines.start.size)
        line = int(np.searchsorted(firsts, node, side="right")) - 1
        x, y, z = of.state.x[node]
        where = f"node {node - firsts[line]} of line {line + 1}"
        where += f" (x = {x:.6g} m, y = {y:.6g} m, z = {z:.6g} m)"
    hint = "" if step is None else f" Halved as often as allowed from {step:g} s."
    hint += " Shorter bars, a shorter step or generalised-alpha may help."
    return NotConvergedError(
        f"{words}: {worst:.3g} of the largest tension is left over at {where}.{hint}"
    )
