"""What is moored, as frozen values in SI: no input, no output, no solving."""

from catopt.model.anchor import Anchor
from catopt.model.body import Body, Buoy, Floater, ShipAfloat
from catopt.model.case import Case, CatalogueChoice, SwarmSettings
from catopt.model.checks import Checks
from catopt.model.current_profile import CurrentProfile
from catopt.model.design import (
    ClumpWeightChoice,
    Design,
    DesignLoad,
    SegmentChoice,
    SinkerChoice,
)
from catopt.model.dynamics import Dynamics
from catopt.model.fatigue import Fatigue, FatigueSeaState, SegmentCurve
from catopt.model.find import Find
from catopt.model.line import Line, PointLoad, Segment
from catopt.model.load import Load, LoadCase
from catopt.model.motion import Motion
from catopt.model.service import Service
from catopt.model.site import Site
from catopt.model.strain_table import StrainTable
from catopt.model.system import Leg, System
from catopt.model.wave_state import WaveState, WaveTrain

__all__ = [
    "Anchor",
    "Body",
    "Buoy",
    "Case",
    "CatalogueChoice",
    "Checks",
    "ClumpWeightChoice",
    "CurrentProfile",
    "Design",
    "DesignLoad",
    "Dynamics",
    "Fatigue",
    "FatigueSeaState",
    "Find",
    "Floater",
    "Leg",
    "Line",
    "Load",
    "LoadCase",
    "Motion",
    "PointLoad",
    "Segment",
    "SegmentChoice",
    "SegmentCurve",
    "Service",
    "ShipAfloat",
    "SinkerChoice",
    "Site",
    "StrainTable",
    "SwarmSettings",
    "System",
    "WaveState",
    "WaveTrain",
]
