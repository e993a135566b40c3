"""Lines, their body, the sea and a state: brought to rest, set in motion, stepped in time."""

from __future__ import annotations

import math
from collections.abc import Callable
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np

from catopt.arrays import Array
from catopt.compiled import compiled
from catopt.errors import NotConvergedError
from catopt.fem.afloat import Afloat
from catopt.fem.energy_balance import EnergyBalance
from catopt.fem.extremes import FOLLOWED, STATE
from catopt.fem.march import SLIDING, StepCounts, march
from catopt.fem.mesh import bar_nodes, end_nodes, place_of
from catopt.fem.morison import fill_water
from catopt.fem.moving import Blend, BodyNode, Equations, Moving, MovingLines, WaterAt
from catopt.fem.newmark import assemble_moving, solve_moving
from catopt.fem.run_settings import StepControls, TimeStepping
from catopt.fem.sampling import Record, Room, Setting, fill_energy, first_joint
from catopt.fem.seabed import drag_feet
from catopt.fem.series import SeriesRows, fill_series, series_rows
from catopt.interrupt import waiting_interrupt
from catopt.waves import Sea
from catopt.waves.kinematics import water_ends
from catopt.words import Message, Several

_HELD = BodyNode(np.zeros(3), np.zeros(3), np.zeros(3))
_STILL = Sea(1.0)
_AT_REST, _SETTING_OFF = Blend(0.0, 0.0, 1.0, 0.0, 0.0), Blend(0.0, 0.0, 0.0, 0.0, 1.0)
_REST_LIMIT = 500
_REST_TOLERANCE = 1e-9
_FEW_STEPS = 20
_TURN = 0.2
"""Change of place over a bar that a Newton step on the way to rest may bring, over its length."""
_GONE = [
    "mass",
    "displaced",
    "added_normal",
    "added_tangential",
    "drag_normal",
    "drag_tangential",
    "weight",
    "weight_in_air",
]
"""What a bar has no longer that breaks."""
_NEXT_TO_NOTHING = 1e-12
"""Part of its stiffness that a broken bar keeps: energies are divided by it."""
_A_BAR = 2e-4
"""Time that a bar takes in one iteration as plain Python, s."""
_ITERATIONS = 3
"""Of a step, about."""
_BY_SAMPLE = 8
"""Fields of a record whose first axis counts samples: the first ones."""
_A_LITTLE = 1e-3
"""Way over the length of a bar by which ends go to find how a line follows them."""
_TURNS = 256
"""Turning points of a quantity for which there is room at first."""
_PIECE = 0.1
"""Seconds of computing between two looks at Ctrl-C and calls of `progress`, about."""


class Break(NamedTuple):
    """Where and when a line parts: at a given time, or once a bar of it reaches its strength."""

    line: int  # from 0
    time: float = math.inf  # s, to the nearest sample but the first; infinite: by its strength
    at_anchor: bool = False  # whose end is then free; else at its fairlead: its last bar is gone
    strength: tuple[float, ...] = ()  # of its bars, N: the first that reaches it is then gone


class Parted(NamedTuple):
    """What became of a line that was to part."""

    time: float  # s
    bar: int  # that is gone, of its own from 0; -1: none, its anchor let go


class Simulation:
    """Lines in motion.

    Parameters
    ----------
    lines, x : MovingLines, ndarray
        What moves, and where its nodes start, (nodes, 3), m.
    body : BodyNode, optional
        What the last nodes are fixed to; held or led in all directions by default.
    prescribed_motion : SeriesRows, optional
        Where the last nodes are led, and after them the first ones, if these are; else they stay.
    load, sea : SeriesRows and Sea, optional
        Force on the body, N; still water everywhere by default.
    """

    def __init__(
        self,
        lines: MovingLines,
        x: Array,
        *,
        body: BodyNode = _HELD,
        prescribed_motion: SeriesRows | None = None,
        load: SeriesRows | None = None,
        sea: Sea | None = None,
    ) -> None:
        self.lines = lines
        self.body = body
        self.sea = sea
        self._held, self._ends = end_nodes(lines.start)
        joints = 3 * (x.shape[0] - first_joint(lines))
        stays, unloaded = self._undriven(x)
        self.prescribed_motion, self.load = prescribed_motion or stays, load or unloaded
        self.afloat: Afloat | None = None  # what floats at the last nodes, to which `body` is free
        self.state = _moving(lines, np.array(x, dtype=float))  # where the lines are now
        self.counts = StepCounts()  # what all steps so far took
        self.parted: Parted | None = None  # the line that was to part
        self._gone = 0.0
        self._before_break: float | None = None
        nodes, bars = x.shape[0], lines.length.size
        u, rate, latest = np.zeros((3, nodes, 3))
        self._room = Room(
            now=_moving(lines, np.array(x, dtype=float)),
            water=WaterAt(u, rate, latest, np.full(nodes, np.inf), np.ones((bars, 2))),
            water_before=np.zeros((nodes, 3)),
            water_ends=water_ends(nodes),
            equations=Equations(*np.zeros((3, nodes, 3, 3)), *np.zeros((2, nodes, 3))),
            small=np.zeros((2, 3, 3)),
            force=np.zeros(3),
            slope=np.zeros(bars),
            loose=np.zeros(bars, dtype=bool),
            highest=np.zeros(1),
            short=np.zeros(2),
            change=np.zeros((nodes, 3)),
            booked=np.zeros((4, nodes, 3)),
            booked_before=np.zeros((4, nodes, 3)),
            ends=np.zeros((self._ends.size, 2, 3)),
            ends_before=np.zeros((self._ends.size, 2, 3)),
            wet_before=np.ones((bars, 2)),
            side=np.zeros((nodes if joints else 0, 3, 3)),
            joints=np.zeros((joints, joints)),
            at_joints=np.zeros(joints),
        )

    def _undriven(self, x: Array) -> tuple[SeriesRows, SeriesRows]:
        """Series that leave the last nodes where they are in x, and no force on the body."""
        prescribed_motion = series_rows(x[self._ends], [None] * self._ends.size, 0.0)
        return prescribed_motion, series_rows(np.zeros((1, 3)), [None], 0.0)

    def _form(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """Give a kernel function for one visit to every bar, plain or compiled."""
        return compiled(function, _A_BAR * self.lines.length.size)

    def assemble(self, blend: Blend, t: float = 0.0) -> tuple[float, int]:
        """Balance of all nodes as they are, without waves; see `assemble_moving`."""
        room, at, start = self._room, self.state, self.lines.start
        if self.sea is not None:
            flow, fill = self.sea.flow_at_rest, self._form(fill_water)
            fill(t, at.x, start, flow, 0.0, room.water_before, room.water)
        room.force[:] = self.load.base[0]
        worst, node = self._form(assemble_moving)(self.lines, self.body, at, at, blend, room)
        return float(worst), int(node)

    def _solve(self, blend: Blend) -> tuple[bool, Array]:
        """Solve the equations at hand; say whether they could be, and the move of each node."""
        at = self.state
        solved = self._form(solve_moving)(self.lines, self.body, at, at, blend, self._room)
        move = self.equations.rest.copy()
        move[self._held[~self.lines.lower_free]] = 0.0
        return bool(solved), move

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
        return self._rounded_off / max(self.lines.force_scale, self._largest_tension)

    def uncertain(self, tolerance: float) -> float:
        """Force that rounding or a tolerance may leave over, over the largest tension."""
        unit = max(self.lines.force_scale, self._largest_tension)
        return max(self._rounded_off, tolerance * unit) / max(self._largest_tension, 1e-300)

    @property
    def _rounded_off(self) -> float:
        stiffest = float((self.lines.EA / self.lines.length).max())
        reach = float(np.abs(self.state.x).max())
        return 4.0 * float(np.finfo(float).eps) * stiffest * reach

    @property
    def _largest_tension(self) -> float:
        return float(np.abs(self.state.tension).max())

    @property
    def equations(self) -> Equations:
        """As `assemble` or a step left them."""
        return self._room.equations

    def settle(self, *, rubbed: bool = False) -> None:
        """Bring the lines to rest from where they are, in the current and without waves.

        `rubbed`: friction of the bed takes what the bars leave over along it, as far as it can;
        without, the line lies as if it had been laid down without friction.
        """
        at = self.state
        self._stand_still()
        if rubbed and self.lines.friction.any():
            self.assemble(_AT_REST)
            lies = at.reaction > 0.0
            pulled = at.force[lies, :2] / self.lines.drag_spring[lies, np.newaxis]
            at.foot[lies] = at.x[lies, :2] - pulled
            drag_feet(self.lines, at, 0.0)
        self.find_rest()

    def hold_ends(self) -> None:
        """Hold the last nodes where they are now, whatever they were free to do or pushed by."""
        self.body = _HELD
        self.prescribed_motion, self.load = self._undriven(self.state.x)
        self.assemble(_AT_REST)

    def _stand_still(self) -> None:
        """Take all speed and friction away, and lift what is below the bed."""
        at, lines = self.state, self.lines
        at.v[:] = 0.0
        at.a[:] = 0.0
        at.foot[:] = np.nan
        # A softer bed than this one, or a level one, may have been laid under the shape given. What
        # a clump weight presses in stays: lifted, its node would leave the bar beside it slack.
        has_bed = (lines.bed_stiffness > 0.0) & ~lines.held
        pressed = np.maximum(-lines.node_force[:, 2], 0.0)
        pressed /= np.where(has_bed, lines.bed_stiffness, np.inf)
        bed = (at.x[:, 0] * lines.bed_sin - lines.bed_depth - pressed) / lines.bed_cos
        at.x[:, 2] = np.where(has_bed, np.maximum(at.x[:, 2], bed), at.x[:, 2])

    def find_rest(self) -> None:
        """Find the place at which no force is left over, from the one at hand and its friction.

        Newton's method; a node is held to where it is by a spring that fades as forces balance.
        Raises NotConvergedError with the node and the force left over there.
        """
        at = self.state
        worst, node = self.assemble(_AT_REST)
        spring = self.lines.force_scale / float(self.lines.length.sum())
        hold = 1.0
        for _ in range(_REST_LIMIT):
            if worst <= max(_REST_TOLERANCE, self.rounding):
                break
            for i in range(3):
                self.equations.diagonal[:, i, i] += spring * hold * min(worst, 1.0)
            solved, move = self._solve(_AT_REST)
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
            raise self._not_closed("the lines did not come to rest", worst, node)
        self.slip_feet()

    def slip_feet(self) -> None:
        """Let the friction springs slip as far as they must, and take stock of the forces."""
        if self.lines.friction.any():
            drag_feet(self.lines, self.state, 0.0)
            self.assemble(_AT_REST)

    def _part_of(self, move: Array, longest: float) -> float:
        """Part of a Newton step by which no node moves half a bar, or else no bar turns far."""
        first = bar_nodes(self.lines.start)
        apart = np.linalg.norm(move[first + 1] - move[first], axis=1)
        turn = float((apart / self.lines.length).max())
        near = 0.5 * float(self.lines.length.min()) / max(longest, 1e-300)
        return min(1.0, max(near, _TURN / max(turn, 1e-300)))

    def start(self) -> None:
        """Find the accelerations with which the lines set off from the present state."""
        at = self.state
        at.a[:] = 0.0
        self._set_moving()
        self._lead_ends()
        self.assemble(_SETTING_OFF)
        at.a[:] += self._solve(_SETTING_OFF)[1]
        self.assemble(_AT_REST)
        self._room.now.foot[:] = at.foot

    def run(
        self,
        stepping: TimeStepping,
        *,
        breaks: Break | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> tuple[Record, bool]:
        """Step in time and take samples, the first of them of the present state.

        `breaks`: the line that parts, and when: largest values then count anew; `progress`: called
        with the time reached, s, some times a second. Says, too, whether all samples were taken:
        Ctrl-C stops a run and keeps what is there. NotConvergedError has the time, the node and the
        force left over there.
        """
        samples, every, step = stepping.samples, stepping.every, float(stepping.step)
        rules = stepping.rules(self.rounding)
        record = self._empty_record(stepping)
        blocks = np.array(stepping.blocks, dtype=float).reshape(-1, 4)
        at, part, level, size, speed = 0, 0.0, 0, 1, 0.0
        last, lost = samples * every, -1
        if breaks is not None and math.isfinite(breaks.time):
            lost = every * max(1, round(breaks.time / (every * step)))
        strength = self._strength(breaks)
        with waiting_interrupt() as ask:
            while at < last:
                if at == lost and part == 0.0:
                    assert breaks is not None
                    bar = -1 if breaks.at_anchor else int(self.lines.start[breaks.line + 1]) - 1
                    self._part(breaks.line, bar, at * step, record)
                end, began = lost if at < lost else last, perf_counter()
                # As plain Python steps may take longer than expected, where they are halved.
                work = max(speed, _ITERATIONS * _A_BAR * self.lines.length.size) * (last - at)
                setting = Setting(
                    rules,
                    self.lines,
                    self.body,
                    self.prescribed_motion,
                    self.load,
                    (self.sea or _STILL).flow,
                    self.sea is not None,
                    blocks,
                    strength,
                )
                report = compiled(march, work)(
                    at, part, end, size, level, setting, self.state, self._room, record, self.afloat
                )
                self.counts = self.counts.with_more(report.counts)
                if not report.closed:
                    words = Message("truss.not_closed", time=(report.at + report.part) * step)
                    raise self._not_closed(words, report.worst, report.node, step)
                if report.full:  # twice the room for turning points
                    turns = np.concatenate([record.turns, np.zeros_like(record.turns)], axis=1)
                    record = record._replace(turns=turns)
                took = perf_counter() - began
                speed = took / max(report.at + report.part - at - part, 1e-3)
                at, part, level = report.at, report.part, report.level
                if report.parted >= 0:
                    assert breaks is not None
                    self._part(breaks.line, int(report.parted), (at + part) * step, record)
                    strength = strength[:0]
                self._check_ringing(stepping.controls, step, at * step)
                try:
                    if progress is not None:
                        progress(at * step)
                    ask()
                except KeyboardInterrupt:
                    done = at // every
                    taken: list[Any] = [each[: done + 1] for each in record[:_BY_SAMPLE]]
                    return Record(*taken, *record[_BY_SAMPLE:]), False
                if took < _PIECE and not report.full:
                    size *= 2
        return record, True

    def _stored(self, record: Record) -> Array:
        """Energies as of `sampling.fill_energy` at the present state, J."""
        energy = np.zeros(4)
        fill_energy(self.lines, self.state, self._room, record.at_rest, energy)
        return energy

    def balance(self, record: Record) -> EnergyBalance:
        """Book the energy of a run from its record."""
        stored = record.stored
        ends, water, drag, bed, friction, damping, kinetic, put_in = map(float, record.works)
        if self._before_break is not None:  # what is set free drives the lines as a force does
            put_in += max(0.0, self._before_break - float(stored[1:4].sum()))
        return EnergyBalance(
            ends=ends,
            water=water,
            kinetic=kinetic + float(stored[4]),
            elastic=float(stored[1] + stored[3]) + self._gone,
            potential=float(stored[2]),
            drag=-drag,
            bed=-bed - float(stored[3]),
            friction=-friction,
            damping=-damping,
            put_in=put_in,
        )

    def _strength(self, breaks: Break | None) -> Array:
        """Tension at which each bar parts, N; of no bar where none may."""
        if breaks is None or not breaks.strength:
            return np.zeros(0)
        strength = np.full(self.lines.length.size, np.inf)
        strength[self.lines.start[breaks.line] : self.lines.start[breaks.line + 1]] = (
            breaks.strength
        )
        return strength

    def _part(self, line: int, bar: int, t: float, record: Record) -> None:
        """Let a line part at a bar, or at its anchor for -1; what is largest counts from then."""
        if bar < 0:
            self._let_go(line, record)
        else:
            self._break(line, bar, record)
        self.parted = Parted(t, bar - int(self.lines.start[line]) if bar >= 0 else -1)
        record.max_tension[:], record.min_tension[:] = -np.inf, np.inf
        for kept in (record.slack_time, record.longest_slack, record.slack_now):
            kept[:] = 0.0
        record.course[:] = record.turns[:] = 0.0
        record.turn_count[:] = 0
        if self.afloat is not None:
            self.afloat.record.extreme[:] = (np.inf, -np.inf)

    def _break(self, line: int, bar: int, record: Record) -> None:
        """Take a bar of a line away: no force, no mass, no drag; what it held is booked."""
        at, held = self.state, self._stored(record)
        factors = {"EA": _NEXT_TO_NOTHING, "damping": _NEXT_TO_NOTHING, **dict.fromkeys(_GONE, 0.0)}
        changed = {name: getattr(self.lines, name).copy() for name in factors}
        for name, factor in factors.items():
            changed[name][bar] *= factor
        self.lines = self.lines._replace(**changed)
        left = self._stored(record)
        self._gone = float((held - left)[1:3].sum())
        self._before_break = float(left[1:].sum())
        pull, last = at.tension[bar] * at.axis[bar], bar + line + 1
        at.force[last - 1] -= pull
        at.force[last] += pull
        at.tension[bar] = self._room.slope[bar] = 0.0
        if bar + 1 == self.lines.start[line + 1]:
            self._room.ends_before[line, 1] = 0.0
        if bar == self.lines.start[line]:
            self._room.ends_before[line, 0] = 0.0

    def _let_go(self, line: int, record: Record) -> None:
        """Let the first node of a line move freely; what is stored then drives the lines."""
        self._before_break = float(self._stored(record)[1:].sum())
        free = self.lines.lower_free.copy()
        free[line] = True
        self.lines = self.lines._replace(lower_free=free)
        self._room.ends_before[line, 0] = 0.0

    def _check_ringing(self, controls: StepControls, step: float, t: float) -> None:
        count = self.counts
        if count.steps > _FEW_STEPS and count.ringing > controls.max_ringing * count.strain:
            values = {"part": count.ringing / count.strain, "shortest": count.shortest}
            raise NotConvergedError(Message("truss.rings", time=t, **values, step=step))

    def _empty_record(self, stepping: TimeStepping) -> Record:
        lines, bars = self.lines.start.size - 1, self.lines.length.size
        samples, nodes = stepping.samples + 1, stepping.nodes
        followed = len(FOLLOWED) * lines + (bars if stepping.tensions else 0)
        return Record(
            time=np.zeros(samples),
            end_force=np.zeros((samples, lines, 2, 3)),
            bar_tension=np.zeros((samples, lines, 2)),
            fairlead=np.zeros((samples, lines, 3)),
            grounded_length=np.zeros((samples, lines)),
            nodes=np.zeros((samples, len(nodes), 3)),
            energy=np.zeros((samples if stepping.energy else 0, 4)),
            tension=np.zeros((samples if stepping.tensions else 0, bars)),
            chosen=np.array(list(nodes), dtype=np.int64),
            max_tension=np.full(bars, -np.inf),
            min_tension=np.full(bars, np.inf),
            slack_time=np.zeros(bars),
            longest_slack=np.zeros(bars),
            slack_now=np.zeros(bars),
            course=np.zeros((followed, STATE)),
            turns=np.zeros((followed, _TURNS, 2)),
            turn_count=np.zeros(followed, dtype=np.int64),
            works=np.zeros(8),
            stored=np.zeros(5),
            at_rest=self.state.x.copy(),
            slides=np.zeros((lines, len(stepping.blocks), SLIDING)),
        )

    def _lead_ends(self) -> None:
        """Put the ends to where they are led in the first moment, with speed and acceleration."""
        at, out, prescribed_motion = self.state, np.zeros((3, 3)), self.body.free == 0.0
        nodes = np.concatenate([self._ends, self._held])[: self.prescribed_motion.base.shape[0]]
        joint = self.lines.of_end[:, ::-1].T.ravel()
        for row, node in enumerate(nodes):
            if joint[row] >= 0:
                continue
            fill_series(0.0, self.prescribed_motion, row, out)
            which = prescribed_motion if row < self._ends.size else slice(None)
            at.x[node, which], at.v[node, which], at.a[node, which] = out[:, which]

    def _set_moving(self) -> None:
        """Give all nodes the speed at which they follow ends that set off at speed.

        It is that of the lines at rest as their ends go: a difference of two such shapes a little
        way before and behind. Without it the ends would tear at lines that stand still. Speeds that
        nodes have already stay.
        """
        is_given = self.state.v.any()
        self._lead_ends()
        speed = float(np.abs(self.state.v).max())
        if is_given or speed == 0.0:
            return
        rest, shapes = _copied(self.state), []
        time = _A_LITTLE * float(self.lines.length.min()) / speed
        ends = rest.v.copy()
        for way in (-0.5, 0.5):
            self.state = _copied(rest)
            self.state.v[:] = 0.0
            self.state.a[:] = 0.0
            self.state.x[:] += way * time * ends
            self.assemble(_AT_REST)
            self.find_rest()
            shapes.append(self.state.x)
        self.state = rest
        rest.v[:] = (shapes[1] - shapes[0]) / time

    def _not_closed(
        self, words: str, worst: float, node: int, step: float | None = None
    ) -> NotConvergedError:
        joint = node - first_joint(self.lines)
        at = -1 - joint if joint >= 0 else node
        where = place_of(at, self.lines.start, self.state.x, 2 if joint >= 0 else 1)
        said = [Message("truss.left_over", what=words, worst=worst, where=where)]
        if step is not None:
            said.append(Message("truss.halved", step=step))
        return NotConvergedError(Several((*said, Message("truss.may_help")), " "))


def _copied(state: Moving) -> Moving:
    return Moving(*(array.copy() for array in state))


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
