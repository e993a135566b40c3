"""The water about the lines at the end of a step: of a whole one the sea's own, or within it."""

from __future__ import annotations

from catopt.fem.morison import fill_water, wet_bars
from catopt.fem.moving import Moving
from catopt.fem.sampling import Room, Setting
from catopt.waves.between import fill_between, keep_start, look_ahead


def begin_whole_step(setting: Setting, room: Room) -> None:
    """Keep the water at hand as that at the next whole step's start."""
    if setting.has_sea:
        water = room.water
        keep_start(water.velocity, water.latest, water.surface, room.water_ends)


def take_water(
    start: float, done: float, part: float, setting: Setting, before: Moving, room: Room
) -> None:
    """Write the water at the end of a part of the whole step from `start`, s, some of it done.

    It is taken where the nodes are expected. Whole steps are short beside the waves; parts of them,
    in which a line snaps, need no closer look at the sea than these: `between.fill_between`.
    """
    if not setting.has_sea:
        return
    now, water, rules, first = room.now, room.water, setting.rules, setting.lines.start
    early, water_0 = rules.alpha_f, room.water_before
    if part == 1.0:
        fill_water(start + rules.step, now.x, first, setting.flow, early, water_0, water)
        return
    ends = room.water_ends
    if ends.is_known[0] == 0.0:
        ahead, x, v = (1.0 - done) * rules.step, before.x, before.v
        for n in range(x.shape[0]):
            for i in range(3):
                ends.points[n, i] = x[n, i] + ahead * v[n, i]
        look_ahead(start + rules.step, setting.flow, ends)
    fill_between(done + part, ends, water.velocity, water.latest, water.surface)
    wet_bars(now.x, first, early, water_0, water)
