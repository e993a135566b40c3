"""A buoy on MoorDyn's line, coupled by the script below, beside ours on the truss model.

The hull is the same, so that lines and coupling differ: here its forces and MoorDyn's are stepped
one after the other (1 cm/s and less a step), there all is one Newton iteration. Chain of 82 m in
12 m, current 1.5 m/s, Hs 2 m, Tp 5.1 s; it goes slack and snaps. Ten seeds of 300 s, largest
tensions in kN, ours and MoorDyn's: 40.5 40.3, 29.1 31.1, 27.5 27.2, 25.0 26.1, 33.9 33.5, 27.8
27.8, 35.2 34.6, 40.8 40.5, 33.5 32.0, 26.0 25.9; means within 0.5 %.
"""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np
import pytest

from catopt.compiled import compiled
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.mesh import mesh_line
from catopt.fem.morison import MorisonSection
from catopt.fem.newmark import LineDamping
from catopt.fem.run_settings import TimeStepping
from catopt.fem.seabed import Seabed
from catopt.fem.solve import Leg
from catopt.floater.moored import AtRest, moored_at_rest, run_moored
from catopt.hydro.build import FloatingHull, Radiation, room_of, state_of
from catopt.hydro.cylinder import FloatingCylinder
from catopt.hydro.hull import carry_memory, fill_forces_on_hull, fill_sea
from catopt.model import Line, Segment
from catopt.waves import PowerLawCurrent, Sea, jonswap, random_waves

moordyn = pytest.importorskip("moordyn", reason="optional extra: peers")

D, MASS, DEPTH, BARS, STEP, RAMP = 2.4, 3000.0, 12.0, 40, 0.01, 20.0
LENGTH, NOMINAL, EA = 82.0, 0.03, 2e7
LINEAR = 20e3 * NOMINAL**2
BULK = math.sqrt(LINEAR / 7850.0 * 4.0 / math.pi)
DAMPING = math.sqrt(EA * LINEAR) * LENGTH / BARS
"""Axial, N s."""

INPUT = f"""MoorDyn
---- LINE TYPES ----
TypeName Diam Mass/m EA BA EI Cd Ca CdAx CaAx
(name) (m) (kg/m) (N) (N-s) (N-m2) (-) (-) (-) (-)
chain {BULK} {LINEAR} {EA} {DAMPING} 0 2.0 1.0 {0.4 / math.pi} 0
---- POINTS ----
ID Attachment X Y Z Mass Volume CdA CA
(#) (-) (m) (m) (m) (kg) (m3) (m2) (-)
1 Fixed 0 0 {-DEPTH} 0 0 0 0
2 Coupled @X 0 @Z 0 0 0 0
---- LINES ----
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(#) (name) (#) (#) (m) (-) (-)
1 chain 1 2 {LENGTH} {BARS} -
---- OPTIONS ----
0 writeLog
2e-4 dtM
3e6 kBot
3e5 cBot
{DEPTH} WtrDpth
1 WaveKin
1025 WtrDens
9.80665 gravity
0.0 FrictionCoefficient
60 TmaxIC
1.0 CdScaleIC
0.001 threshIC
---- OUTPUT ----
---- END ----
"""


def _hull() -> FloatingHull:
    draught, centre = MASS / (1025.0 * math.pi * D * D / 4.0) + 0.05, 0.1
    ends = np.linspace(0.0, 1.2, 13)
    return FloatingHull(
        ends[:-1],
        ends[1:],
        np.full(12, 0.5 * D),
        MASS,
        MASS * 0.36,
        centre,
        draught,
        radiation=Radiation.of_cylinder(
            FloatingCylinder(0.5 * D, draught, DEPTH, centre - draught)
        ),
        drag=np.full(12, 0.5 * 1025.0 * 1.2 * D),
        bottom_drag=0.5 * 1025.0 * math.pi * D * D / 4.0,
        bottom_radius=0.5 * D,
        eyes=((0.0, 0.0, -0.2),),
        free=(True, False, True, False, False, False),
    )


def _on_moordyns_line(sea: Sea, rest: AtRest, duration: float) -> np.ndarray:
    """Step hull and line one after the other; the force at the eye of each step, N."""
    laid, flow, room = rest.hull, sea.flow, room_of(rest.hull)
    at, before = (state_of(laid, tuple(rest.state.q)) for _ in range(2))
    kernels = [compiled(each) for each in (fill_sea, carry_memory, fill_forces_on_hull)]
    look, carry, push = kernels
    inverse = np.linalg.inv(np.eye(3) * laid.mass + laid.added[:3, :3])
    below = laid.eye[0, 2]

    def eye() -> list[float]:
        q = at.q
        return [q[0], q[1], q[2] + below - DEPTH]

    place = eye()
    text = INPUT.replace("@X", repr(place[0])).replace("@Z", repr(place[2]))
    Path("line.txt").write_text(text)
    system = moordyn.Create("line.txt")
    try:
        moordyn.Init(system, place, [0.0, 0.0, 0.0])
        moordyn.ExternalWaveKinInit(system)
        pull, found = rest.line[:3].copy(), []
        for i in range(round(duration / STEP)):
            t = i * STEP
            points = np.array(moordyn.ExternalWaveKinGetCoordinates(system)).reshape(-1, 3)
            water = sea.kinematics(t + STEP, points + np.array([0.0, 0.0, DEPTH]))
            moordyn.ExternalWaveKinSet(
                system, water.velocity.tolist(), water.acceleration.tolist(), t + STEP
            )
            before.q[:], before.v[:] = at.q, at.v
            look(t + STEP, laid, at, flow, room)
            carry(STEP, laid, before, room)
            push(laid, at, DEPTH, room)
            before.memory[:] = at.memory
            at.v[:3] += inverse @ (at.force[:3] + pull) * STEP
            at.q[:] += at.v[:3] * STEP
            pull[:] = moordyn.Step(system, eye(), at.v[:3].tolist(), t, STEP)
            found.append(math.hypot(*pull))
    finally:
        moordyn.Close(system)
    return np.array(found)


@pytest.mark.slow
def test_largest_tension_beside_moordyns_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(os.environ, "CATOPT_COMPILE", "auto")
    weight = LINEAR * (1.0 - 1025.0 / 7850.0) * 9.80665
    line = Line((Segment(length=LENGTH, submerged_weight=weight, EA=EA, mass=LINEAR),))
    properties = LineProperties(
        sections=[MorisonSection(BULK, 2.0, 0.4, 1.0, 0.0)],
        damping=LineDamping(stiffness_time=DAMPING / EA),
        seabed=Seabed(3e6 * BULK, 3e5 * BULK, friction=0.0),
    )
    waves = random_waves(jonswap(2.0, 5.1, 3.3), 100, np.random.default_rng(1))
    sea = Sea(DEPTH, waves, (PowerLawCurrent(1.5),), ramp_time=RAMP)
    hull, mesh, duration = _hull(), mesh_line(line, BARS), 60.0
    legs = [Leg(line, (0.0, 0.0, 0.0))]
    stepping = TimeStepping(duration, 0.02, ramp_time=RAMP)
    ours, _ = run_moored(hull, legs, [mesh], stepping, sea=sea, properties=properties)
    rest = moored_at_rest(hull, legs, [mesh], sea=sea, properties=properties)
    theirs = _on_moordyns_line(sea, rest, duration)
    late = theirs[round(RAMP / STEP) :]
    statistics = ours.tension_statistics()
    assert statistics.maximum == pytest.approx(late.max(), rel=0.10)
    assert statistics.mean == pytest.approx(late.mean(), rel=0.02)
