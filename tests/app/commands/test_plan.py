"""``housefly plan``: the words under the path mean what a flight's summary means."""

from __future__ import annotations

import re
from math import hypot

import pytest

import housefly
from housefly.cli import main


def test_clearance_is_that_of_the_hull_and_numbers_are_short(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["plan", "--to", "window"]) == 0
    told = capsys.readouterr().out
    loaded = housefly.load_site("bsen")
    path = loaded.plan("window").path
    assert path is not None
    drone = loaded.site.drone
    hull = path.clearance - hypot(drone.hull_length, drone.hull_width) / 2
    assert f"clearance of the hull at least {hull:.2f} m" in told
    assert told.count("clearance") == 1
    assert not re.search(r"\.\d{5}", told + str(path))
