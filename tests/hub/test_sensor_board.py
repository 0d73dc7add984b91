"""How the sensors do that another process listens to."""

from __future__ import annotations

from math import inf

from housefly.app.premises import read_site
from housefly.clock import SteppedClock
from housefly.config.site import changed
from housefly.hub.sensor_board import SILENT, UNHEARD, SensorBoard
from housefly.messages import SensorReport

SITE = changed(read_site("bsen"), lasers=[{"name": "laser-1"}], depth_cameras=[{"name": "depth-1"}])


def test_every_sensor_of_the_site_is_listed_before_anybody_tells_of_it() -> None:
    laser, camera = SensorBoard(SITE, SteppedClock(100.0)).health()
    assert (laser.id, laser.title, laser.connected, laser.age, laser.problem) == (
        "laser-1",
        "Laser scanner laser-1",
        False,
        inf,
        UNHEARD,
    )
    assert (camera.id, camera.title, camera.problem) == ("depth-1", "Depth camera depth-1", UNHEARD)


def test_the_newest_report_holds_and_ages_until_nobody_listens_any_more() -> None:
    clock = SteppedClock(100.0)
    board = SensorBoard(SITE, clock)
    board.heard(SensorReport("laser-1", "laser scanner", False, 0.0, inf, "nobody answers"))
    assert board.health()[0].problem == "nobody answers"
    board.heard(SensorReport("laser-1", "laser scanner", True, 10.0, 0.05, ""))
    clock.advance(1.0)
    laser = board.health()[0]
    assert (laser.connected, laser.rate_hz, laser.age, laser.problem) == (True, 10.0, 1.05, "")
    clock.advance(SILENT)
    laser = board.health()[0]
    assert (laser.connected, laser.rate_hz, laser.problem) == (False, 0.0, UNHEARD)


def test_what_the_site_does_not_have_is_not_kept() -> None:
    board = SensorBoard(SITE, SteppedClock(100.0))
    for number in range(1000):
        board.heard(SensorReport(f"laser-{number + 2}", "laser scanner", True, 10.0, 0.0, ""))
    assert [sensor.id for sensor in board.health()] == ["laser-1", "depth-1"]
