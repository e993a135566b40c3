"""Waves and current: dispersion, spectra, random seas, and the motion of the water.

A `Sea` holds what moves; `Sea.flow` with `kinematics.fill_kinematics` is for loops over time steps.
"""

from catopt.waves.components import (
    ElevationRecord,
    Waves,
    regular_wave,
    repetition_warning,
    strongest_return,
    waves_needed,
)
from catopt.waves.kinematics import Flow, fill_elevation, fill_kinematics
from catopt.waves.random_surface import (
    CosineSpreading,
    Spectrum,
    frequency_range,
    jonswap,
    peak_enhancement,
    peak_from_mean,
    peak_from_zero_crossing,
    pierson_moskowitz,
    random_waves,
    s4_range_jonswap,
    s4_range_pierson_moskowitz,
    wave_number,
    wavelength,
    zero_crossing_from_mean,
)
from catopt.waves.sea import (
    Current,
    CurrentSeries,
    Kinematics,
    PowerLawCurrent,
    Sea,
    TableCurrent,
    WindCurrent,
    breaking_height,
    breaking_warning,
    wind_driven_speed,
)

__all__ = [
    "CosineSpreading",
    "Current",
    "CurrentSeries",
    "ElevationRecord",
    "Flow",
    "Kinematics",
    "PowerLawCurrent",
    "Sea",
    "Spectrum",
    "TableCurrent",
    "Waves",
    "WindCurrent",
    "breaking_height",
    "breaking_warning",
    "fill_elevation",
    "fill_kinematics",
    "frequency_range",
    "jonswap",
    "peak_enhancement",
    "peak_from_mean",
    "peak_from_zero_crossing",
    "pierson_moskowitz",
    "random_waves",
    "regular_wave",
    "repetition_warning",
    "s4_range_jonswap",
    "s4_range_pierson_moskowitz",
    "strongest_return",
    "wave_number",
    "wavelength",
    "waves_needed",
    "wind_driven_speed",
    "zero_crossing_from_mean",
]
