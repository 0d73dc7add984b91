"""The room as a scanner would see it, against points that are walked along each beam, and against
the simulated scanner.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin
from typing import Any

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.config.site import changed
from housefly.perception.background import HALF_THICKNESS, expected_ranges
from housefly.perception.clusters import foreground_limit
from housefly.room.distance import clearance_field, footprints
from housefly.sites.loaded_site import open_site, read_site
from housefly.twin.world import SimulatedWorld
from housefly.wires.scip import UST_10LX


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(turn=st.floats(-pi, pi))
def test_a_beam_ends_where_the_room_begins(make_hall: Callable[..., Any], turn: float) -> None:
    hall = make_hall()
    laser = hall.configs[0].model_copy(update={"yaw": 0.0, "x": 2.0, "y": 2.0})
    (reach,) = expected_ranges(hall.room.solids, laser, turn, 1.0, 1)
    rows = footprints(hall.room.solids, laser.z - HALF_THICKNESS, laser.z + HALF_THICKNESS)
    for share, touches in ((0.999, False), (1.0, True)):
        x, y = 2.0 + share * reach * cos(turn), 2.0 + share * reach * sin(turn)
        gap = clearance_field(rows, np.array([x]), np.array([y]), 50.0)[0, 0]
        assert (gap < 1e-6) == touches or 1e-3 * reach < 1e-6


def test_the_twins_scanner_sees_the_room_as_the_background_says() -> None:
    site = changed(
        read_site("bsen"),
        twin__visitor_present=False,
        lasers=[{"name": "one", "x": 6.0, "y": 3.0, "z": 1.1}],
    )
    loaded = open_site(site)
    measured = np.array(SimulatedWorld(site, loaded.room).scan("one")) / 1000.0
    laser = site.lasers[0]
    expected = expected_ranges(
        loaded.room.solids, laser, UST_10LX.first_angle, UST_10LX.step, UST_10LX.beams
    )
    reached = measured < 30.0
    assert np.quantile(np.abs(measured - expected)[reached], 0.9) < 0.04
    assert not (np.where(reached, measured, np.inf) < foreground_limit(expected)).any()
