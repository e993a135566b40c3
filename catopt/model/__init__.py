"""What is moored, as frozen values in SI: no input, no output, no solving."""

from catopt.model.anchor import Anchor
from catopt.model.case import Case, CatalogueChoice, SwarmSettings
from catopt.model.design import (
    ClumpWeightChoice,
    Design,
    DesignLoad,
    Find,
    GroupChoice,
    GroupDesign,
    SegmentChoice,
    SinkerChoice,
)
from catopt.model.dynamics import Dynamics, Fatigue, FatigueSeaState, SegmentCurve
from catopt.model.line import Line, PointLoad, Segment, StrainTable
from catopt.model.load import Checks, Load, LoadCase, Site
from catopt.model.sea import CurrentProfile, Motion, WaveState, WaveTrain
from catopt.model.service import Service
from catopt.model.system import Body, Buoy, Floater, HullAfloat, Leg, ShipAfloat, System
from catopt.model.title_block import Revision, TitleBlock

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
    "GroupChoice",
    "GroupDesign",
    "HullAfloat",
    "Leg",
    "Line",
    "Load",
    "LoadCase",
    "Motion",
    "PointLoad",
    "Revision",
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
    "TitleBlock",
    "WaveState",
    "WaveTrain",
]
