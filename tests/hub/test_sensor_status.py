"""How the sensors do that another process listens to."""

from __future__ import annotations

from math import inf

from housefly.clock import SteppedClock
from housefly.config.site import changed
from housefly.hub.sensor_status import NO_REPORT, REPORT_TIMEOUT, SensorStatus
from housefly.messages import SensorReport
from housefly.sites.loaded_site import read_site

SITE = changed(read_site("bsen"), lasers=[{"name": "laser-1"}], depth_cameras=[{"name": "depth-1"}])


def test_every_sensor_of_the_site_is_listed_before_anybody_tells_of_it() -> None:
    laser, camera = SensorStatus(SITE, SteppedClock(100.0)).health()
    assert (laser.id, laser.title, laser.connected, laser.age, laser.problem) == (
        "laser-1",
        "Laser scanner laser-1",
        False,
        inf,
        NO_REPORT,
    )
    assert (camera.id, camera.title, camera.problem) == (
        "depth-1",
        "Depth camera depth-1",
        NO_REPORT,
    )


def test_the_newest_report_holds_and_ages_until_nobody_listens_any_more() -> None:
    clock = SteppedClock(100.0)
    status = SensorStatus(SITE, clock)
    status.update(SensorReport("laser-1", "laser scanner", False, 0.0, inf, "nobody answers"))
    assert status.health()[0].problem == "nobody answers"
    status.update(SensorReport("laser-1", "laser scanner", True, 10.0, 0.05, ""))
    clock.advance(1.0)
    laser = status.health()[0]
    assert (laser.connected, laser.rate_hz, laser.age, laser.problem) == (True, 10.0, 1.05, "")
    clock.advance(REPORT_TIMEOUT)
    laser = status.health()[0]
    assert (laser.connected, laser.rate_hz, laser.problem) == (False, 0.0, NO_REPORT)


def test_what_the_site_does_not_have_is_not_kept() -> None:
    status = SensorStatus(SITE, SteppedClock(100.0))
    for number in range(1000):
        status.update(SensorReport(f"laser-{number + 2}", "laser scanner", True, 10.0, 0.0, ""))
    assert [sensor.id for sensor in status.health()] == ["laser-1", "depth-1"]
