"""Random moorings of every shape, from millinewtons to meganewtons, as case files."""

from __future__ import annotations

import itertools
import math
import random
from dataclasses import dataclass, field

SHAPES = (
    "raft", "crowfoot", "buoy on legs", "plumb", "plumb in a current", "shared line", "line",
    "slack line", "line in a current", "hanging line", "body", "quay", "chain of joints",
    "float at the surface", "two floats in a current", "hanging weight",
    "hanging weight in a current", "legs in a current", "raft in a current", "free end",
)  # fmt: skip


@dataclass(frozen=True)
class Drawn:
    """A mooring as a case file, and what it may be asked for beside its rest."""

    shape: str
    text: str
    asks: tuple[tuple[str, ...], ...]
    """Commands with their options; the file comes last."""


_OF_A_LINE = (("solve",), ("check",), ("solve", "--profile"), ("curve", "--points", "9"))
_OF_POINTS = (("system",), ("check",), ("solve",))
_OF_BODY_ALONE = (("system",), ("check",))
_OF_A_BODY = (("system",), ("check",), ("system", "--line-out"), ("system", "--curve", "30 deg"))


def drawn(seed: int) -> Drawn:
    """Draw a mooring; the shape goes round with the seed."""
    draw = random.Random(seed)
    shape = SHAPES[seed % len(SHAPES)]
    return _File(draw, shape).drawn()


@dataclass
class _File:
    """A case file as it is written: all in SI, with a size for lengths and one for forces."""

    draw: random.Random
    shape: str
    points: list[str] = field(default_factory=list)
    lines: list[str] = field(default_factory=list)
    bodies: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        draw = self.draw
        self.depth = 10.0 ** draw.uniform(-0.5, 2.6)
        self.weight = 10.0 ** draw.uniform(-3.0, 6.0) / self.depth  # of a line as long as it: N
        self.is_checked = draw.random() < 0.4
        self.title = f"{self.shape}, {draw.choice(['', 'harbour ', 'a long name of a place '])}"

    def drawn(self) -> Drawn:
        in_current = "in a current" in self.shape
        made = getattr(self, f"_{self.shape.replace(' ', '_')}")()
        draw = self.draw
        bed = draw.choice([0.0, 0.0, 0.4]) if "joint" not in self.shape else 0.0
        head = [
            f'title = "{self.title.strip()}"',
            "[site]",
            f"water_depth = {self.depth!r}",
            *([f"seabed_friction = {bed}"] if bed else []),
        ]
        tail = []
        if self.is_checked:
            tail += ["[checks]", f"safety_factor = {draw.choice([1.5, 5.0])}"]
            if draw.random() < 0.3:
                tail.append("max_anchor_uplift_angle = 0")
        if in_current:
            speed = draw.choice([0.1, 0.4, 1.5])
            tail += ["[current]", 'profile = "table"', f"depths = [0, {self.depth!r}]"]
            tail += [f"speeds = [{speed}, {0.5 * speed}]"]
            if draw.random() < 0.3 and self.shape == "line in a current":
                tail.append("direction = 0.7")
        return Drawn(self.shape, "\n".join([*head, *made[1], *tail]) + "\n", made[0])

    # -------------------------------------------------------------- parts

    def point(self, name: str, kind: str, *rest: str) -> str:
        self.points += ["[[points]]", f'name = "{name}"', f'kind = "{kind}"', *rest]
        return name

    def anchor(self, x: float, y: float) -> str:
        name = f"anchor {len(self.points)}"
        return self.point(name, "anchor", f"x = {x!r}", f"y = {y!r}")

    def fairlead(self, x: float, y: float, height: float, body: str) -> str:
        own = [f"x = {x!r}", f"y = {y!r}", f"height = {height!r}"]
        return self.point(f"eye {len(self.points)}", "fairlead", *own, f'body = "{body}"')

    def joint(self, weight: float, *more: str) -> str:
        own = [f"submerged_weight = {weight!r}"] if weight else []
        return self.point(f"joint {len(self.points)}", "joint", *own, *more)

    def body(self, force: tuple[float, float]) -> str:
        name = self.draw.choice(["raft", "ponton số 1"]) + (f" {len(self.bodies)}")
        self.bodies += ["[[bodies]]", f'name = "{name}"', f"force = [{force[0]!r}, {force[1]!r}]"]
        if self.draw.random() < 0.5:
            self.bodies.append("yaw_free = false")
        return name

    def segments(self, length: float, prefix: str, *, in_current: bool = False) -> list[str]:
        """Cut a length into one to three segments, with point loads on some of them."""
        draw, out = self.draw, []
        parts = [draw.uniform(0.3, 1.0) for _ in range(draw.choice([1, 1, 2, 3]))]
        for number, part in enumerate(parts):
            weight = self.weight * 10.0 ** draw.uniform(-0.7, 0.2)
            out += [f"[[{prefix}.segments]]", f"length = {length * part / sum(parts)!r}"]
            out += [f"submerged_weight = {weight!r}"]
            if draw.random() < (0.8 if prefix == "line" else 0.99) or in_current:
                out.append(f"EA = {weight * self.depth * 10.0 ** draw.uniform(2.5, 5.0)!r}")
            if draw.random() < (0.97 if self.is_checked else 0.5):
                out.append(f"MBL = {weight * self.depth * 10.0 ** draw.uniform(0.5, 2.0)!r}")
            if draw.random() < 0.5:
                out.append(
                    f'name = "{draw.choice(["chain", "wire rope of the upper part"])} {number}"'
                )
            if in_current:
                out += [f"drag_diameter = {0.002 * self.depth * draw.uniform(0.1, 1.0)!r}"]
                out.append("drag_normal = 1.2")
        return out

    def loads(self, length: float, prefix: str, *, in_current: bool = False) -> list[str]:
        draw, out = self.draw, []
        for number in range(draw.choice([0, 0, 1, 2, 4])):
            size = self.weight * self.depth * draw.uniform(-0.05, 0.3)
            out += [f"[[{prefix}.point_loads]]", f"position = {length * (number + 0.5) / 5.0!r}"]
            out.append(f"submerged_weight = {size!r}")
            if draw.random() < 0.6:
                out.append(f'name = "meter {number}"')
            if in_current:
                out += [f"drag_area = {1e-4 * self.depth**2!r}", "drag_coefficient = 1.0"]
        return out

    def tie(self, start: str, end: str, length: float, **how: bool) -> None:
        self.lines += ["[[lines]]", f'start = "{start}"', f'end = "{end}"']
        if self.draw.random() < 0.3:
            self.lines.append(
                f'name = "{self.draw.choice(["leg", "crossed to sea"])} {length:.3g}"'
            )
        self.lines += self.segments(length, "lines", **how)
        self.lines += self.loads(length, "lines", **how)

    @property
    def made(self) -> list[str]:
        return [*self.points, *self.bodies, *self.lines]

    def around(self, count: int, turn: float = 0.0) -> list[float]:
        return [turn + math.tau * k / count for k in range(count)]

    def length(self, span: float, rise: float) -> float:
        return math.hypot(span, rise) * self.draw.choice([1.02, 1.05, 1.1, 1.25])

    def pull(self) -> tuple[float, float]:
        size = self.weight * self.depth * self.draw.choice([0.0, 0.2, 0.6])
        angle = self.draw.uniform(0.0, math.tau)
        return size * math.cos(angle), size * math.sin(angle)

    # -------------------------------------------------------------- shapes

    def _raft(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        draw, d = self.draw, self.depth
        body, count, height = self.body(self.pull()), draw.choice([2, 3, 4, 6]), d * 0.95
        for side in self.around(count, draw.choice([0.0, 0.3])):
            x, y = math.cos(side), math.sin(side)
            away = d * draw.choice([2.0, 4.0])
            at, eye = (
                self.anchor(away * x, away * y),
                self.fairlead(0.2 * d * x, 0.2 * d * y, height, body),
            )
            self.tie(at, eye, self.length(away - 0.2 * d, height))
        return (*_OF_A_BODY, ("system", "--stiffness")), self.made

    def _quay(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        """Lines from bollards above the water to a ship, which hang in the air."""
        d, height = self.depth, 1.2 * self.depth
        ship = self.body((self.weight * d * 0.3, self.weight * d * 0.3))
        for x in (-2.0, -0.5, 0.5, 2.0):
            bollard = f"bollard {x}"
            own = [f"x = {x * d!r}", f"y = {-d!r}", f"height = {1.1 * d!r}"]
            self.point(bollard, "anchor", *own)
            eye = self.fairlead(0.8 * x * d, 0.0, height, ship)
            self.tie(
                bollard, eye, math.hypot(0.2 * x * d, d, 0.1 * d) * self.draw.choice([1.01, 1.05])
            )
        return _OF_A_BODY, self.made

    def _crowfoot(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        draw, d = self.draw, self.depth
        height, count = 0.9 * d, draw.choice([1, 2, 3])
        body = self.body(self.pull()) if draw.random() < 0.5 and count == 3 else ""
        for side in self.around(count):
            x, y = math.cos(side), math.sin(side)
            joint = self.joint(self.weight * d * draw.choice([0.0, 0.2]))
            self.tie(self.anchor(4.0 * d * x, 4.0 * d * y), joint, self.length(2.6 * d, 0.4 * d))
            for across in (-0.2, 0.2):
                eye = self.fairlead(
                    0.4 * d * (x - across * y), 0.4 * d * (y + across * x), height, body
                )
                self.tie(joint, eye, self.length(d, 0.4 * d))
        return (*_OF_POINTS, ("system", "--stiffness"), ("system", "--line-out")), self.made

    def _buoy_on_legs(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d = self.depth
        buoy = self.joint(-self.weight * d * self.draw.choice([2.0, 6.0]))
        for side in self.around(self.draw.choice([2, 3])):
            away = d * 0.7
            at = self.anchor(away * math.cos(side), away * math.sin(side))
            self.tie(at, buoy, 0.9 * math.hypot(away, 0.7 * d))
        return _OF_POINTS, self.made

    def _plumb(self, *, in_current: bool = False) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d = self.depth
        drag = [f"drag_area = {1e-3 * d**2!r}", "drag_coefficient = 0.6"] if in_current else []
        buoy = self.joint(-self.weight * d * self.draw.choice([2.0, 8.0]), *drag)
        self.tie(self.anchor(0.0, 0.0), buoy, 0.8 * d, in_current=in_current)
        return _OF_POINTS, self.made

    def _plumb_in_a_current(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        return self._plumb(in_current=True)

    def _shared_line(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d, height = self.depth, 0.9 * self.depth
        left, right = (self.body(self.pull()) for _ in range(2))
        for body, way in ((left, -1.0), (right, 1.0)):
            for across in (-1.0, 1.0):
                at = self.anchor(way * 5.0 * d, across * 2.0 * d)
                self.tie(at, self.fairlead(way * 2.0 * d, 0.1 * across * d, height, body), 3.9 * d)
        west = self.fairlead(-1.8 * d, 0.0, height, left)
        east = self.fairlead(1.8 * d, 0.0, height, right)
        self.tie(west, east, 3.6 * d * self.draw.choice([1.01, 1.03]))
        return (*_OF_POINTS, ("system", "--line-out")), self.made

    def _chain_of_joints(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d, count = self.depth, self.draw.choice([1, 2, 3])
        names = [self.anchor(0.0, 0.0)]
        names += [self.joint(-self.weight * d * self.draw.choice([0.5, 1.0])) for _ in range(count)]
        names.append(self.anchor((count + 1) * 0.6 * d, 0.0))
        for first, second in itertools.pairwise(names):
            self.tie(first, second, 0.75 * d)
        return _OF_POINTS, self.made

    def _float_at_the_surface(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        """Hold a buoy by one to three legs that are longer than the water is deep."""
        d, draw = self.depth, self.draw
        high = [f"float_height = {0.05 * d!r}"] if draw.random() < 0.5 else []
        buoy = self.joint(-self.weight * d * draw.choice([1.0, 20.0]), *high)
        for side in self.around(draw.choice([1, 2, 3])):
            at = self.anchor(2.0 * d * math.cos(side), 2.0 * d * math.sin(side))
            self.tie(at, buoy, math.hypot(2.0 * d, d) * draw.choice([1.01, 1.1, 1.5]))
        return _OF_POINTS, self.made

    def _two_floats_in_a_current(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d = self.depth
        drag = [f"drag_area = {1e-3 * d**2!r}", "drag_coefficient = 0.6"]
        west, east = (self.joint(-self.weight * d * 10.0, *drag) for _ in range(2))
        for way, buoy in ((-1.0, west), (1.0, east)):
            self.tie(self.anchor(3.0 * way * d, 0.0), buoy, 3.0 * d, in_current=True)
        self.tie(west, east, 2.0 * d * self.draw.choice([1.0, 1.1]), in_current=True)
        return _OF_POINTS, self.made

    def _hanging_weight(
        self, *, in_current: bool = False
    ) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        """Hang a weight on a line from a place above."""
        d = self.depth
        drag = [f"drag_area = {1e-4 * d**2!r}", "drag_coefficient = 1.0"] if in_current else []
        weight = self.joint(self.weight * d * self.draw.choice([0.3, 3.0]), *drag)
        self.tie(
            self.point("ice", "fairlead", "x = 0.0", "y = 0.0", f"height = {d!r}"), weight,
            self.draw.choice([0.3, 0.8]) * d, in_current=in_current,
        )  # fmt: skip
        return _OF_POINTS, self.made

    def _hanging_weight_in_a_current(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        return self._hanging_weight(in_current=True)

    def _legs_in_a_current(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d = self.depth
        buoy = self.joint(-self.weight * d * self.draw.choice([4.0, 8.0]))
        for side in self.around(self.draw.choice([2, 3])):
            at = self.anchor(0.7 * d * math.cos(side), 0.7 * d * math.sin(side))
            self.tie(at, buoy, 0.9 * math.hypot(0.7 * d, 0.7 * d), in_current=True)
        return _OF_POINTS, self.made

    def _raft_in_a_current(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d, height = self.depth, 0.95 * self.depth
        body = self.body(self.pull())
        for side in self.around(self.draw.choice([3, 4])):
            x, y = math.cos(side), math.sin(side)
            eye = self.fairlead(0.2 * d * x, 0.2 * d * y, height, body)
            length = self.length(2.8 * d, height)
            self.tie(self.anchor(3.0 * d * x, 3.0 * d * y), eye, length, in_current=True)
        return (*_OF_BODY_ALONE, ("system", "--line-out")), self.made

    def _free_end(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        """Hang a chain over the side, to a joint that bears nothing."""
        d = self.depth
        end = self.joint(0.0)
        ice = self.point("ice", "fairlead", "x = 0.0", "y = 0.0", f"height = {d!r}")
        self.tie(ice, end, self.draw.choice([0.4, 0.9]) * d)
        return _OF_POINTS, self.made

    def one_line(
        self, kind: str, length: float, height: float, low: float, *load: str
    ) -> list[str]:
        in_current = kind == "current"
        own = ["[line]", f"fairlead_height = {height!r}"]
        own += [f"anchor_height = {low!r}"] if low else []
        own += self.segments(length, "line", in_current=in_current)
        own += self.loads(length, "line", in_current=in_current)
        return [*own, "[load]", *load]

    def _line(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d = self.depth
        length = d * self.draw.choice([1.5, 3.0, 8.0])
        size = self.weight * d * self.draw.choice([0.5, 1.5, 5.0])
        load = self.draw.choice(
            [
                f"horizontal_force = {size!r}",
                f"fairlead_tension = {3.0 * size!r}",
                f"span = {0.97 * math.sqrt(length**2 - d**2)!r}",
            ]
        )
        return _OF_A_LINE, self.one_line("", length, d, 0.0, load)

    def _slack_line(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d = self.depth
        return _OF_A_LINE, self.one_line(
            "", 3.0 * d, d, 0.0, f"span = {self.draw.choice([0.5, 1.9]) * d!r}"
        )

    def _hanging_line(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d, low = self.depth, self.draw.choice([0.7, 0.9])
        span = f"span = {d!r}"
        return _OF_A_LINE, self.one_line(
            "", self.draw.choice([1.05, 1.3]) * d, 0.9 * d, low * d, span
        )

    def _line_in_a_current(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        d = self.depth
        force = f"horizontal_force = {self.weight * d * self.draw.choice([0.5, 3.0])!r}"
        commands = (("solve",), ("solve", "--profile"), ("check",))
        return commands, self.one_line("current", 3.0 * d, d, 0.0, force)

    def _body(self) -> tuple[tuple[tuple[str, ...], ...], list[str]]:
        draw, d = self.draw, self.depth
        sides = [math.degrees(each) for each in self.around(draw.choice([3, 4, 6]))]
        x, y = self.pull()
        length = 3.0 * d
        own = ["[line]", f"fairlead_height = {d!r}", *self.segments(length, "line")]
        own += self.loads(length, "line")
        own += [
            "[system]",
            f"anchor_radius = {2.9 * d!r}",
            f"fairlead_radius = {draw.choice([0.0, 0.1]) * d!r}",
        ]
        listed = ", ".join(f'"{each!r} deg"' for each in sides)
        own += [f"azimuths = [{listed}]", f"force = [{x!r}, {y!r}]"]
        return (*_OF_A_BODY, ("system", "--watch-circle")), own
