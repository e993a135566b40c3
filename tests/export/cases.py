"""Cases that the tests of exports share."""

from __future__ import annotations

from pathlib import Path

from catopt import Case, Line, Load, PointLoad, Segment, Site, read_case

__all__ = ["CASES", "FSO", "chain_and_wire", "suspended", "tanker", "tanker_with_sinker"]

CASES = Path(__file__).parents[2] / "cases"
FSO = CASES / "fso-rang-dong" / "case.toml"


def suspended(EA: float = 2e6) -> Case:
    """S1's buoy on a chain that stretches; nothing of it lies on the bed."""
    chain = Segment(20.0, 93.163175, EA=EA, mass=10.9, name="chain")
    return Case(Site(9.5), Line([chain]), Load(horizontal_force=3363.68), 9.5, title="Suspended")


def tanker(EA: float = 2e8) -> Case:
    """S3's tanker: one chain, 7 m of it on the bed, with an EA given."""
    segment = Segment(55.0, 2100.0, EA=EA, mass=246.0, name="chain 105 mm")
    return Case(Site(20.0), Line([segment]), Load(horizontal_force=100e3), 20.0, title="Tanker")


def tanker_with_sinker() -> Case:
    """S3's tanker with the sinker of Table 2, as its case file has it."""
    found: Case = read_case(CASES / "tanker-20m-sinker" / "case.toml")
    return found


def chain_and_wire(friction: float = 0.0) -> Case:
    """Chain on the bed, wire above, a clump weight that hangs where they meet."""
    chain = Segment(200.0, 1470.0, EA=800e6, mass=178.7, name="chain")
    wire = Segment(200.0, 298.0, EA=382e6, mass=34.9, name="wire")
    clump = PointLoad(200.0, 50e3, mass=6000.0, name="clump")
    return Case(
        Site(56.0, seabed_friction=friction),
        Line([chain, wire], [clump]),
        Load(horizontal_force=600e3),
        50.0,
        title="Chain, wire and clump",
    )
