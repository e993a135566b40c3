"""Waves and current of a case file: trains, a recorded surface, a current over time."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from catopt.casefile import parse_case
from catopt.errors import InputError
from catopt.model import WaveState, WaveTrain

PAGE = (Path(__file__).parents[2] / "docs" / "case-file.md").read_text(encoding="utf-8")

CASE = """
[site]
water_depth = "20 m"
[line]
[[line.segments]]
component = "chain studless R3"
diameter = "76 mm"
length = "120 m"
[load]
horizontal_force = "300 kN"
[dynamics]
duration = "60 s"
"""


def waves_of(text: str, folder: str = "") -> WaveState:
    found = parse_case(CASE + text, folder=folder).waves
    assert found is not None
    return found


def problems(text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        parse_case(CASE + text)
    return [str(problem) for problem in caught.value.problems]


def test_the_trains_on_the_page() -> None:
    (text,) = re.findall(r'^```toml title="a wind sea and a swell"\n(.*?)^```$', PAGE, re.M | re.S)
    waves = waves_of(text)
    assert [train.height for train in waves.all_trains] == [2.5, 1.2]
    assert [train.spreading_exponent for train in waves.all_trains] == [3.0, None]
    assert (waves.stretching, waves.all_trains[1].components) == ("wheeler", 100)


def test_one_train_is_the_same_in_either_form() -> None:
    keys = 'spectrum = "jonswap"\nheight = "2 m"\nperiod = "8 s"\nspreading_exponent = 4\n'
    one, several = waves_of(f"[waves]\n{keys}"), waves_of(f"[waves]\n[[waves.trains]]\n{keys}")
    train = WaveTrain("jonswap", 2.0, 8.0, spreading_exponent=4.0)
    assert one.all_trains == several.all_trains == (train,)


def test_a_record_counts_from_the_folder_of_the_case(tmp_path: Path) -> None:
    text = '[waves]\nelevation_file = "e.csv"\nelevation_x = "90 m"\ndirection = "180 deg"\n'
    waves = waves_of(text, str(tmp_path))
    assert waves.elevation_file == str(tmp_path / "e.csv")
    assert (waves.elevation_x, waves.all_trains, waves.is_random) == (90.0, (), False)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            '[waves]\nspectrum = "jonswap"\n',
            [
                "waves.height: missing; spectrum needs it",
                "waves.period: missing; spectrum needs it",
            ],
        ),
        (
            "[waves]\nseed = 2\n",
            [
                "waves: found none of them; exactly one of spectrum, elevation_file, trains is "
                "required"
            ],
        ),
        (
            '[waves]\nelevation_file = "e.csv"\nseed = 1\nheight = "2 m"\n',
            [
                "waves.seed: found 1; cannot be combined with elevation_file; leave it out",
                'waves.height: found "2 m"; cannot be combined with elevation_file; leave it out',
            ],
        ),
        (
            "[waves]\ncomponents = 200\nshortest_period = 2\n[[waves.trains]]\n"
            'spectrum = "regular"\nheight = 2\nperiod = 8\nspreading_exponent = 2\n'
            'peak_enhancement = 3.3\n[[waves.trains]]\nspectrum = "jonswap"\nheight = 2\n'
            "period = 8\nspreading_directions = 10\n",
            [
                "waves.components: found 200; is given in each of the trains; leave it out here",
                "waves.shortest_period: found 2; cannot be combined with trains; leave it out",
                "waves.trains[0].spreading_exponent: found 2; a regular wave has one direction; "
                "leave it out",
                "waves.trains[0].peak_enhancement: found 3.3; goes with jonswap, not with regular; "
                "leave it out",
                "waves.trains[1].spreading_directions: found 10; goes with spreading_exponent, "
                "which is missing",
            ],
        ),
        (
            '[waves]\nspectrum = "jonswap"\nheight = 2\nperiod = 8\nspreading_exponent = 2\n'
            "components = 50\n",
            [
                "waves.components: found 50; must be a multiple of the 20 directions, so that each "
                "has the same energy"
            ],
        ),
        (
            '[waves]\nspectrum = "jonswap"\nheight = 2\nperiod = 8\n[[waves.trains]]\n'
            'spectrum = "jonswap"\nheight = 2\n',
            [
                "waves: found spectrum and trains; exactly one of spectrum, elevation_file, trains "
                "is required",
                'waves.trains[0].period: missing; a time is required, such as "8 s"',
            ],
        ),
    ],
)
def test_what_does_not_go_together_is_told_at_once(text: str, expected: list[str]) -> None:
    assert problems(text) == expected


def test_the_model_refuses_the_same() -> None:
    with pytest.raises(InputError) as caught:
        WaveState(elevation_file="e.csv", seed=2, components=20)
    assert [p.key for p in caught.value.problems] == ["components", "seed"]
    with pytest.raises(InputError, match="a multiple of the 7 directions"):
        WaveTrain("jonswap", 2.0, 8.0, spreading_exponent=2.0, spreading_directions=7)


def test_the_current_on_the_page(tmp_path: Path) -> None:
    title = "a current that turns with depth and changes over time"
    (text,) = re.findall(rf'^```toml title="{title}"\n(.*?)^```$', PAGE, re.M | re.S)
    motion = '[motion]\nperiod = "8 s"\nsurge = "1 m"\n'
    current = parse_case(CASE + motion + text, folder=str(tmp_path)).current
    assert current is not None
    assert current.directions == pytest.approx((0.0, math.pi / 6.0, math.pi / 3.0), rel=1e-15)
    assert current.series_file == str(tmp_path / "current.csv")


def test_what_goes_with_another_current_is_told_at_once() -> None:
    text = (
        '[waves]\nspectrum = "regular"\nheight = 2\nperiod = 8\n[current]\nprofile = "table"\n'
        'depths = [0, 5]\nspeeds = [1, 1]\ndirection = "0 deg"\ndirections = ["0 deg", "100 deg"]\n'
    )
    assert problems(text) == [
        'current.direction: found "0 deg"; goes with one value for all depths; leave it out',
        'current.directions[1]: found "100 deg"; more than a right angle from the row before: '
        "give a row between them",
    ]
