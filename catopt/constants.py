"""Physical constants, each with its source."""

from __future__ import annotations

STANDARD_GRAVITY = 9.80665
"""g0 in m/s2: the exact standard value (CGPM 1901). It defines kgf and tf."""

SEA_WATER_DENSITY = 1025.0
"""kg/m3: the value IALA's CALMAR reference takes; salt water runs from 1024.7 (20 °C) to 1026.9."""

YEAR = 365.25 * 86400.0
"""The Julian year, s."""
