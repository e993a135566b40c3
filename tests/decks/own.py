"""Decks written for these tests.

Figures of OC3 and OC4 are from their reports and MAP++'s output, those of C06 from OrcaFlex's
example of that name, 11.5e, in vamseeachanta/digitalmodel.
"""

from __future__ import annotations

import pytest

from catopt import InputError
from catopt.decks.reading import Asked, Imported, read_deck


def said(found: Imported) -> str:
    return "\n".join(found.remarks)


def problems(text: str, asked: Asked | None = None) -> list[str]:
    with pytest.raises(InputError) as caught:
        read_deck(text, "deck.txt", asked)
    return [str(problem) for problem in caught.value.problems]


MOORDYN = """OC3's mooring, own deck
--- LINE TYPES ---
Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx
(-) (m) (kg/m) (N) (N-s/-) (N-m2) (-) (-) (-) (-)
main 0.09 77.7066 384.243e6 -0.8 0 1.6 1.0 0.1 0.0
--- POINTS ---
ID Attachment X Y Z Mass Volume CdA Ca
(#) (-) (m) (m) (m) (kg) (m3) (m2) (-)
1 Fixed 853.87 0 -320 0 0 0 0
2 Fixed -426.935 739.473112 -320 0 0 0 0
3 Fixed -426.935 -739.473112 -320 0 0 0 0
4 Coupled 5.2 0 -70 0 0 0 0
5 Coupled -2.6 4.503332 -70 0 0 0 0
6 Coupled -2.6 -4.503332 -70 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(#) (name) (#) (#) (m) (-) (-)
1 main 1 4 902.2 20 -
2 main 5 2 902.2 20 -
3 main 3 6 902.2 20 -
--- OPTIONS ---
9.80665 g
1025 rho
320 WtrDpth
0.001 FrictionCoefficient
0.001 dtM
--- END ---
"""

V1 = """OC3's line, version 1
--- LINE TYPES ---
1 NTypes number of line types
LineType Diam MassDenInAir EA cIntDamp Can Cat Cdn Cdt
(-) (m) (kg/m) (N) (Pa-s) (-) (-) (-) (-)
main 0.09 77.7066 384.243e6 -0.8 1.0 0.3 1.6 0.1
--- CONNECTION PROPERTIES ---
2 NConnects number of connections
Node Type X Y Z M V FX FY FZ CdA CA
(-) (-) (m) (m) (m) (kg) (m3) (kN) (kN) (kN) (m2) (-)
1 Fixed 853.87 0 -320 0 0 0 0 0 0 0
2 Vessel 5.2 0 -70 0 0 0 0 0 0 0
--- LINE PROPERTIES ---
1 NLines number of lines
Line LineType UnstrLen NumSegs NodeAnch NodeFair Flags
(-) (-) (m) (-) (-) (-) (-)
1 main 902.2 20 1 2 -
--- SOLVER OPTIONS ---
320 WtrDpth
--- need this line ---
"""

TWO_SEGMENTS = """chain, clump weight and rope, written from the fairlead down
--- LINE TYPES ---
Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx
(-) (m) (kg/m) (N) (N-s/-) (N-m2) (-) (-) (-) (-)
rope 0.15 25 30e6 -0.8 120000 1.2 1 0.1 0
chain 0.2 200 2e9 -1 0 1.3 1 0.2 0.5
--- POINTS ---
ID Attachment X Y Z Mass Volume CdA Ca
(#) (-) (m) (m) (m) (kg) (m3) (m2) (-)
1 Fixed 0 0 -300 0 0 0 0
2 Free 500 0 -250 5000 0.64 1.5 0.5
3 Coupled 800 0 0 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(#) (name) (#) (#) (m) (-) (-)
1 rope 3 2 380 20 -
2 chain 2 1 500 20 -
--- OPTIONS ---
9.81 g
1025 rho
300 WtrDpth
--- END ---
"""

MAP = """---- LINE DICTIONARY ----
LineType Diam MassDenInAir EA CB CIntDamp Ca Cdn Cdt
(-) (m) (kg/m) (N) (-) (Pa-s) (-) (-) (-)
main {types}
---- NODE PROPERTIES ----
Node Type X Y Z M B FX FY FZ
(-) (-) (m) (m) (m) (kg) (m3) (N) (N) (N)
1 fix {anchor} depth 0 0 # # #
2 vessel {fairlead} 0 0 # # #
---- LINE PROPERTIES ----
Line LineType UnstrLen NodeAnch NodeFair Flags
(-) (-) (m) (-) (-) (-)
1 main {length} 1 2 tension_fair
---- SOLVER OPTIONS ----
Option
(-)
outer_tol 1e-5
"""

ONTOLOGY = """\
site:
  general: {water_depth: 200, rho_water: 1025.0, rho_air: 1.225}
array:
  keys: [ID, topsideID, platformID, mooringID, x_location, y_location, heading_adjust]
  data:
    - [f1, 1, 1, ms1, -1600, 800, 0]
topsides:
  - {type: Turbine}
platform: {rFair: 58, zFair: -14}
mooring_systems:
  ms1:
    keys: [MooringConfigID, heading, anchorType]
    data:
      - [leg, 30, drag1]
      - [leg, 150, drag1]
      - [leg, 270, drag1]
mooring_line_configs:
  leg:
    span: 642
    sections:
      - {type: chain, length: 497.7}
      - {connectorType: clump}
      - {type: polyester, length: 199.8, adjustable: True}
mooring_line_types:
  chain: {d_nom: 0.155, d_vol: 0.279, m: 480.9, EA: 2058e6, MBL: 25.2e6, cost: 1486}
  keys: [name, d_vol, m, EA, stiffness note]
  data:
    - [polyester, 0.144, 22.5, 164e6, quasi-static]
mooring_connector_types:
  clump: {m: 5000, v: 0.64}
anchor_types:
  drag1: {type: DEA}
"""

C06 = """\
%YAML 1.1
---
General:
  UnitsSystem: SI
  StageDuration: [10, 100]
Environment:
  WaterSurfaceZ: 0
  Density: 1.025
  SeabedType: Flat
  WaterDepth: 100
  SeabedNormalStiffness: 100
  WindSpeed: 12
LineTypes:
  - Name: 2.5" Chain
    Category: General
    OD: 0.120015
    ID: 0
    MassPerUnitLength: 0.088306275
    EI: [0, ~]
    EA: 407.25725e3
    OuterContactDiameter: 0.2286
    Ca: [1, ~, 0.07]
    Cd: [1, ~, 0.4]
    NormalDragLiftDiameter: 0.14351
    AxialDragLiftDiameter: 0.0121276066
    SeabedLateralFrictionCoefficient: 0
    SeabedAxialFrictionCoefficient: ~
  - Name: Hose
    OD: 0.64
    ID: 0.5
ClumpTypes:
  - {Name: clump, Mass: 5, Volume: 0.64}
6DBuoys:
  - Name: CALM Base
    Connection: Free
    InitialPosition: [-6.866732677463321, 5.580584446653303, -0.7946049904251593]
    InitialAttitude: [0, 0, 0]
Lines:
  - Name: Mooring1
    ? Connection, ConnectionX, ConnectionY, ConnectionZ, ConnectionAzimuth,
      ConnectionDeclination, ConnectionGamma, ConnectionReleaseStage, ConnectionzRelativeTo
    : - [CALM Base, 6, 0, -1.5, 0, 180, 0, ~]
      - [Anchored, 299.13326732253665, 5.580584446653303, 0.1143, 0, 90, 0, ~]
    LineType, Length, TargetSegmentLength:
      - [2.5" Chain, 150, 10]
      - [2.5" Chain, 195, 15]
    LayAzimuth: 180
  - Name: Loadhose
    Connection, ConnectionX, ConnectionY, ConnectionZ:
      - [CALM Base, 6, 0, -1.5]
      - [Fixed, 50, 0, -1.5]
    LineType, Length:
      - [Hose, 60]
"""

MAP_BRIDLE = """---------------------- LINE DICTIONARY ----------------------
LineType Diam MassDenInAir EA CB CIntDamp Ca Cdn Cdt
(-) (m) (kg/m) (N) (-) (Pa-s) (-) (-) (-)
steel 0.25 320.0 9.8e9 1.0 0 0 0 0
nylon 0.30 100.0 9.8e8 1.0 0 0 0 0
---------------------- NODE PROPERTIES ----------------------
Node Type X Y Z M B FX FY FZ
(-) (-) (m) (m) (m) (kg) (m^3) (N) (N) (N)
1 fix 400 0 depth 0 0 # # #
2 connect #90 #0 #-80 0 0 0 0 0
3 vessel 20 20 -10 0 0 # # #
4 vessel 20 -20 -10 0 0 # # #
---------------------- LINE PROPERTIES ----------------------
Line LineType UnstrLen NodeAnch NodeFair Flags
(-) (-) (m) (-) (-) (-)
1 steel 450 1 2 altitude
2 nylon 90 2 3 tension_fair
3 nylon 90 2 4 tension_fair
---------------------- SOLVER OPTIONS ----------------------
Option
(-)
repeat 120 240
"""

BRIDLE = """two legs that split; 20 t of 2.5 m3 in each joint, one leg of two segments
--- LINE TYPES ---
Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx
(-) (m) (kg/m) (N) (N-s/-) (N-m2) (-) (-) (-) (-)
steel 0.25 320 9.8e9 -1 0 1.2 1 0 0
nylon 0.30 100 9.8e8 -1 0 1.2 1 0 0
--- POINTS ---
ID Attachment X Y Z Mass Volume CdA Ca
(#) (-) (m) (m) (m) (kg) (m3) (m2) (-)
1 Fixed 400 0 -350 0 0 0 0
2 Free 62 0 -87 20000 2.5 0 0
3 Coupled 20 20 -10 0 0 0 0
4 Coupled 20 -20 -10 0 0 0 0
5 Fixed -380 0 -350 0 0 0 0
6 Free -150 0 -150 0 0 0 0
7 Free -62 0 -87 20000 2.5 0 0
8 Coupled -20 20 -10 0 0 0 0
9 Coupled -20 -20 -10 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(#) (name) (#) (#) (m) (-) (-)
1 steel 1 2 450 20 -
2 nylon 2 3 90 20 -
3 nylon 4 2 90 20 -
4 steel 5 6 300 20 -
5 nylon 6 7 135 20 -
6 nylon 7 8 90 20 -
7 nylon 9 7 90 20 -
--- OPTIONS ---
9.81 g
1025 rho
350 WtrDpth
--- END ---
"""
