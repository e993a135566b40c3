"""Cases that hang, move or are moored in ways of their own, for every language and face."""

from __future__ import annotations

from .conftest import CASES, CHAIN_AND_WIRE, CHAIN_IN_MOTION
from .test_system import SPREAD, TWO_HEADINGS

BUOYED = """
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "300 m"
submerged_weight = "1000 N/m"
EA = "500 MN"
[[line.point_loads]]
position = "150 m"
submerged_weight = "-50 kN"
[load]
horizontal_force = "300 kN"
[checks]
max_anchor_uplift_angle = "3 deg"
"""

KNOWN_SHIP = """
[site]
water_depth = "22 m"
[ship]
length = "234 m"
breadth = "31.3 m"
draught = "12.4 m"
"""

TWO = 'azimuths = ["0 deg", "180 deg"]'
FOUR = 'azimuths = ["0 deg", "90 deg", "180 deg", "270 deg"]'
CASE_TEXTS = {
    "four lines": SPREAD,
    "with strength": SPREAD.replace('EA = "800 MN"', 'EA = "800 MN"\nMBL = "2 MN"'),
    "untitled, two lines": SPREAD.replace('title = "Buoy on four lines"\n', "").replace(FOUR, TWO),
    "one line": SPREAD.replace(FOUR, 'azimuths = ["180 deg"]').replace(
        'fairlead_radius = "10 m"\n', ""
    ),
    "two headings": TWO_HEADINGS,
    "no force": SPREAD.replace('force = ["200 kN", "0 kN"]', ""),
    "taut": SPREAD.replace('EA = "800 MN"\n', "").replace("600 m", "563 m"),
}


TWICE = """
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "300 m"
submerged_weight = "1000 N/m"
EA = "500 MN"
[[line.point_loads]]
name = "float"
position = "150 m"
submerged_weight = "-50 kN"
[load]
horizontal_force = "20 kN"
"""

BIGHTS = """
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "80 m"
submerged_weight = "1000 N/m"
[load]
span = "10 m"
"""

TENSION_KNOWN = BIGHTS.replace('span = "10 m"', 'fairlead_tension = "80 kN"')

AT_SEA = (
    CHAIN_IN_MOTION.replace("[load]\n", '[[load_cases]]\nname = "storm"\n').replace(
        "elements = 20", "elements = 10\nruns = 2"
    )
    + """
[waves]
spectrum = "jonswap"
height = "4 m"
period = "9 s"
components = 20
[current]
profile = "power"
speed = "0.8 m/s"
"""
)

EXAMPLE = CASES / "dynamic-chain-56m"

RAOS = (
    (EXAMPLE / "case.toml")
    .read_text("utf-8")
    .replace('"5 min"', '"20 s"\nelements = 10')
    .replace('period = "9 s"', 'period = "4 s"')
)
"""Waves of the example that are shorter than its table of RAOs goes."""

TWICE_IN_MOTION = (
    TWICE.replace('EA = "500 MN"', 'EA = "500 MN"\nmass = "120 kg/m"\ndrag_normal = 0').replace(
        '"-50 kN"', '"-50 kN"\nmass = "1 t"'
    )
    + CHAIN_IN_MOTION[CHAIN_IN_MOTION.index("[motion]") :]
)

LED = (
    AT_SEA[: AT_SEA.index("[[load_cases]]")]
    + """
[system]
anchor_radius = "117 m"
fairlead_radius = "4 m"
azimuths = ["180 deg", "60 deg", "-60 deg"]
force = ["30 kN", "0 kN"]
"""
    + AT_SEA[AT_SEA.index("[waves]") :]
    + """
[motion]
rao_file = "ship.csv"
rao_phase = "lag"
rao_reference = ["0 m", "0 m", "22 m"]
rao_rotation = "deg/m"
rao_per = "amplitude"
[dynamics]
duration = "24 s"
elements = 10
"""
)
SHIP = """heading (deg),period (s),surge (m/m),surge_phase (deg),heave (m/m),pitch (deg/m)
0,5,0.2,-90,0.3,0.5
0,10,0.6,-90,0.8,1.5
"""
PUSHED = (
    LED[: LED.index("[waves]")]
    + """
[body]
mass = "200 t"
force_file = "force.csv"
[dynamics]
duration = "24 s"
elements = 10
"""
)
FORCE = "t (s),Fx (kN),Fz (kN)\n" + "".join(f"{t},{2 * t * (24 - t)},1\n" for t in range(25))

FILES = {
    "chain-and-wire.toml": CHAIN_AND_WIRE,
    "buoyed.toml": BUOYED,
    "known-ship.toml": KNOWN_SHIP,
    **{f"{name}.toml": text for name, text in CASE_TEXTS.items()},
    "led.toml": LED,
    "ship.csv": SHIP,
    "pushed.toml": PUSHED,
    "force.csv": FORCE,
    "twice.toml": TWICE,
    "bights.toml": BIGHTS,
    "tension-known.toml": TENSION_KNOWN,
    "moving.toml": CHAIN_IN_MOTION,
    "raos.toml": RAOS,
    "rao.csv": (EXAMPLE / "rao.csv").read_text("utf-8"),
    "twice-in-motion.toml": TWICE_IN_MOTION,
    "at-sea.toml": AT_SEA,
    "slack-in-motion.toml": CHAIN_IN_MOTION.replace('surge = "0.5 m"', 'heave = "3 m"')
    .replace("300 kN", "20 kN")
    .replace("24 s", "12 s"),
}
