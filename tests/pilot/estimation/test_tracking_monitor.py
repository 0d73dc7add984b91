"""Flights in MuJoCo under a tracking system that lies, scored on the truth."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from math import dist, hypot, isnan, radians

import pytest
from lying_tracking import (
    Lie,
    LiedFlight,
    drifting,
    gap,
    mirrored,
    misdefined,
    moved,
    shifted,
    stepping,
    unstamped,
)

import housefly
from housefly.messages import DroneStatus, Order, OrderKind, Phase, Sighting, Telemetry
from housefly.pilot.estimation.tracking_monitor import TrackingMonitor
from housefly.sites.loaded_site import LoadedSite

CRUISING = 12.0
"""The drone is under way at full speed by then [s]."""
HARMLESS = 0.75
"""A drone that is told 9 cm after it began to move becomes no faster [m/s]: trajectories push
harder from the start than the flight along corners did.
"""


@pytest.fixture(scope="module")
def site() -> LoadedSite:
    return housefly.load_site("bsen", twin__seed=3)


@pytest.fixture(scope="module")
def quick_site() -> LoadedSite:
    """Return the same with half the steps of the pilot and half the tracking."""
    return housefly.load_site("bsen", twin__seed=3, control__rate_hz=50, twin__mocap_rate_hz=50)


@pytest.fixture(scope="module")
def honest(quick_site: LoadedSite) -> LiedFlight:
    """Return a service that has come to just before ``CRUISING``, under no lie yet."""
    flight = LiedFlight(housefly.Simulation(quick_site))
    flight.begin()
    flight.run(CRUISING - 0.1 - flight.sim.now)
    return flight


@pytest.fixture(scope="module")
def to_the_sofa(quick_site: LoadedSite) -> LiedFlight:
    """Return a service at the sofa that has come to just before 9 s."""
    flight = LiedFlight(housefly.Simulation(quick_site))
    flight.begin("sofa")
    flight.run(8.9 - flight.sim.now)
    return flight


def served(flight: LiedFlight) -> LiedFlight:
    """Return a flight when its service has ended."""
    flight.service()
    return flight


def lied(site: LoadedSite, lie: Lie) -> LiedFlight:
    """Return a service flown under a lie from the start."""
    return served(LiedFlight(housefly.Simulation(site), lie))


def assert_harmless(flight: LiedFlight) -> None:
    assert flight.contacts == 0
    assert flight.speed < HARMLESS
    assert flight.status is DroneStatus.LANDED
    assert any(code.startswith("tracking") for code in flight.codes)
    assert "arrived_to_look" not in flight.codes


@pytest.mark.parametrize(
    "degrees",
    [30, *(pytest.param(angle, marks=pytest.mark.safety) for angle in (60, 90, 180, -90))],
)
def test_a_body_that_is_defined_turned_is_caught_within_thirty_centimetres(
    site: LoadedSite, degrees: float
) -> None:
    flight = lied(site, misdefined(radians(degrees)))
    assert_harmless(flight)
    assert flight.travelled_when_told < 0.3


@pytest.mark.parametrize(
    ("axis", "heading"),
    [
        (0, True),
        *(
            pytest.param(*case, marks=pytest.mark.safety)
            for case in ((1, True), (0, False), (1, False))
        ),
    ],
)
def test_a_mirrored_map_is_caught(site: LoadedSite, axis: int, heading: bool) -> None:
    flight = lied(site, mirrored(site.room.home, axis, heading))
    assert_harmless(flight)


@pytest.mark.parametrize("rate", [0.02, 0.05])
def test_a_drift_is_told_at_ten_centimetres_and_landed_before_thirty(
    honest: LiedFlight, rate: float
) -> None:
    flight = served(honest.lied_to(drifting(0.0, rate, CRUISING), CRUISING))
    assert_harmless(flight)
    assert flight.lied_when_told <= 0.1
    assert flight.lied_when_landing < 0.2


def test_steps_below_the_gate_are_not_believed(honest: LiedFlight) -> None:
    assert_harmless(served(honest.lied_to(stepping(0.14, 1.0, CRUISING), CRUISING)))


def test_poses_late_by_a_third_of_a_second_are_found_within_five_seconds(site: LoadedSite) -> None:
    flight = lied(site, unstamped(0.3))
    assert_harmless(flight)
    first = next(at for at, code, _ in flight.told if code.startswith("tracking"))
    assert first < 0.5 + 5.0
    assert flight.speed < 0.3


@pytest.mark.parametrize("z", [-0.6, 0.6])
def test_a_drone_whose_tracked_height_cannot_be_stays_down(site: LoadedSite, z: float) -> None:
    flight = lied(site, shifted(0.0, 0.0, z))
    assert flight.contacts == 0
    assert "airborne" not in flight.codes and "tracking_on_ground" in flight.codes


def returns() -> list[tuple[float, float]]:
    return list(product((0.3, 0.8, 1.2, 1.5, 1.9), (0.3, 0.4, 0.5, 0.6, 0.8, 1.0)))


def assert_not_believed(honest: LiedFlight, seconds: float, x: float, y: float) -> None:
    flight = served(honest.lied_to(gap(CRUISING, seconds, x, y), CRUISING))
    assert_harmless(flight)
    assert flight.status is DroneStatus.LANDED
    assert flight.outputs is not None and flight.outputs.estimate is not None
    estimate, truth = flight.outputs.estimate, flight.sim.world.truth()
    off = hypot(
        estimate.position[0] - truth.pose.position[0], estimate.position[1] - truth.pose.position[1]
    )
    assert off < 0.3


@pytest.mark.parametrize(("seconds", "off"), [(0.3, 0.3), (0.8, 0.4), (1.2, 0.5), (1.9, 1.0)])
def test_a_wrong_place_after_a_gap_is_not_believed(
    honest: LiedFlight, seconds: float, off: float
) -> None:
    assert_not_believed(honest, seconds, 0.0, off)


@pytest.mark.safety
@pytest.mark.parametrize(("seconds", "off"), returns())
@pytest.mark.parametrize("way", [(1, 0), (-1, 0), (0, 1), (0, -1)])
def test_no_wrong_place_of_the_grid_is_believed(
    honest: LiedFlight, seconds: float, off: float, way: tuple[int, int]
) -> None:
    assert_not_believed(honest, seconds, off * way[0], off * way[1])


@pytest.mark.parametrize("seconds", [0.3, 0.8, 1.2, 1.9])
def test_the_right_place_after_a_gap_is_believed_at_once(
    honest: LiedFlight, seconds: float
) -> None:
    flight = honest.lied_to(gap(CRUISING, seconds, 0.0, 0.0), CRUISING)
    flight.run(CRUISING + seconds + 0.3 - flight.sim.now)
    assert flight.outputs is not None and flight.outputs.estimate is not None
    assert flight.outputs.estimate.pose_age < 0.1
    assert flight.outputs.phase is Phase.OUTBOUND


def test_without_the_check_the_same_place_is_believed(
    honest: LiedFlight, monkeypatch: pytest.MonkeyPatch
) -> None:
    flight = honest.lied_to(gap(CRUISING, 1.2, 0.0, 0.5), CRUISING)
    monkeypatch.setattr(TrackingMonitor, "agrees", lambda *_: True)
    flight.run(CRUISING + 1.5 - flight.sim.now)
    assert flight.outputs is not None and flight.outputs.estimate is not None
    assert flight.outputs.estimate.pose_age < 0.1
    y = flight.sim.world.truth().pose.position[1]
    assert abs(flight.outputs.estimate.position[1] - y) > 0.4


def test_a_body_of_another_thing_is_not_taken_for_a_drone_that_lies_still(
    site: LoadedSite,
) -> None:
    flight = LiedFlight(housefly.Simulation(site))
    flight.run(3.0)
    flight.lie = shifted(2.0, 0.0)
    flight.run(2.0)
    assert "lay still" in " ".join(text for _, _, text in flight.told)
    flight.step(Order(OrderKind.SERVICE, place="entrance"))
    flight.run(3.0)
    assert "order_refused" in flight.codes and "airborne" not in flight.codes
    assert flight.outputs is not None and flight.outputs.estimate is not None
    assert (
        hypot(
            flight.outputs.estimate.position[0] - site.room.home[0],
            flight.outputs.estimate.position[1] - site.room.home[1],
        )
        < 0.1
    )


def test_a_drone_that_was_carried_is_found_where_it_is_now(site: LoadedSite) -> None:
    flight = LiedFlight(housefly.Simulation(site))
    flight.run(3.0)
    x, y = site.room.home
    truth = flight.sim.world.truth()
    flight.sim.world.put_drone((x + 1.0, y, truth.pose.position[2]), site.room.home_yaw + 0.3)
    flight.run(2.0)
    assert "tracking_restarted" in flight.codes
    assert flight.outputs is not None and flight.outputs.estimate is not None
    assert abs(flight.outputs.estimate.position[0] - x - 1.0) < 0.05


def test_an_honest_flight_over_a_table_shows_nothing(site: LoadedSite) -> None:
    flight = LiedFlight(housefly.Simulation(site))
    monitor: list[float] = []
    flight.run(0.5)
    flight.step(Order(OrderKind.GO, place="tv"))
    while flight.sim.now < 20.0:
        flight.step()
        known = flight.sim.pilot.consistency
        assert known.drift == 0.0 or isnan(known.drift)
        assert not known.mirrored and known.refused_for == 0.0
        assert isnan(known.latency_error) or known.latency_error == 0.0
        monitor.append(known.frame_error)
    assert max(angle for angle in monitor if not isnan(angle)) < radians(10.0)


def test_flow_that_errs_is_blamed_and_the_drone_lands_by_tracking(
    honest: LiedFlight,
) -> None:
    flight = honest.lied_to(None, CRUISING)

    def scaled(telemetry: Telemetry) -> Telemetry:
        forward, left, up = telemetry.velocity
        return replace(telemetry, velocity=(1.5 * forward, 1.5 * left, up))

    flight.report = lambda told: scaled(told) if flight.sim.now > CRUISING else told
    flight.service()
    assert_harmless(flight)
    codes = [code for _, code, _ in flight.told]
    assert "flow_wrong" in codes and "tracking_drift" not in codes


def test_an_order_does_not_make_a_drift_on_the_pad_forgotten(site: LoadedSite) -> None:
    flight = LiedFlight(housefly.Simulation(site), lambda s: moved(s, 0.0, on_pad(s.captured_at)))
    flight.run(12.0)
    flight.step(Order(OrderKind.SERVICE, place="entrance", look_s=1.0))
    flight.run(2.0)
    assert flight.status is DroneStatus.LANDED
    refused = next(text for _, code, text in flight.told if code == "order_refused")
    assert "tracking moves the drone although it stands: moved by 0.40 m" in refused


def on_pad(t: float) -> float:
    """Return a lie that grows to 0.4 m within 10 s [m]."""
    return min(0.4, 0.05 * max(0.0, t - 2.0))


def test_after_a_landing_for_a_drift_the_drone_has_to_be_seen_on_its_pad(
    site: LoadedSite, honest: LiedFlight
) -> None:
    flight = served(honest.lied_to(drifting(0.0, 0.02, CRUISING), CRUISING))
    stays = flight.lied
    flight.lie = lambda s: moved(s, 0.0, stays)
    flight.run(3.0)
    flight.step(Order(OrderKind.SERVICE, place="entrance", look_s=1.0))
    flight.run(2.0)
    assert flight.status is DroneStatus.LANDED
    refused = next(text for _, code, text in flight.told if code == "order_refused")
    assert "tracking has not seen the drone on its pad" in refused
    # Carried to its pad, it is tracked as far beside it as the lie goes.
    (x, y), z = site.room.home, flight.sim.world.truth().pose.position[2]
    flight.sim.world.put_drone((x, y, z), site.room.home_yaw)
    flight.run(3.0)
    assert not flight.sim.pilot.origin_confirmed and flight.sim.pilot.origin_revoked
    flight.lie = None
    flight.sim.world.put_drone((x + 0.05, y, z), site.room.home_yaw)
    flight.run(3.0)
    assert flight.sim.pilot.origin_confirmed and not flight.sim.pilot.origin_revoked


@pytest.mark.parametrize(
    ("seconds", "height"), [(0.0, 0.7), (0.5, 0.8), (1.2, 0.5), (0.5, -0.5)], ids=str
)
def test_a_wrong_height_after_a_gap_is_not_believed(
    to_the_sofa: LiedFlight, seconds: float, height: float
) -> None:
    def lie(s: Sighting) -> Sighting | None:
        if s.captured_at < 9.0:
            return s
        return None if s.captured_at < 9.0 + seconds else moved(s, 0.0, 0.0, height)

    flight = to_the_sofa.lied_to(lie, 9.0)
    flight.service(limit=25.5)
    assert flight.contacts == 0
    assert flight.status is DroneStatus.LANDED
    assert "poses_refused" in flight.codes


@pytest.mark.parametrize(("rate", "since"), [(0.05, CRUISING), (0.02, CRUISING)])
def test_a_tracked_height_that_rises_by_itself_lands_the_drone_before_it_is_low(
    honest: LiedFlight, rate: float, since: float
) -> None:
    def lie(s: Sighting) -> Sighting:
        return moved(s, 0.0, 0.0, rate * max(0.0, s.captured_at - since))

    flight = honest.lied_to(lie, since)
    lowest = 1.1
    while flight.sim.now < 40.0 and not {"tracking_height_drift", "grounded"} & {*flight.codes}:
        flight.step()
        if flight.sim.now > since:
            lowest = min(lowest, flight.sim.world.truth().pose.position[2])
    assert "tracking_height_drift" in flight.codes
    assert lowest > 0.7
    flight.run(6.0)
    assert flight.status is DroneStatus.LANDED and flight.contacts == 0


def test_a_drone_exchanged_with_another_body_lands_and_is_not_believed_to_be_there(
    honest: LiedFlight,
) -> None:
    other = (4.0, 2.0, 0.8)

    def exchanged(s: Sighting) -> Sighting:
        if s.captured_at < CRUISING:
            return s
        wobble = 0.001 * (s.captured_at % 1.0)
        return replace(s, pose=replace(s.pose, position=(other[0] + wobble, *other[1:])))

    flight = served(honest.lied_to(exchanged, CRUISING))
    flight.run(3.0)
    assert_harmless(flight)
    assert flight.outputs is not None and flight.outputs.estimate is not None
    assert dist(flight.outputs.estimate.position[:2], other[:2]) > 1.0
    flight.step(Order(OrderKind.SERVICE, place="entrance", look_s=1.0))
    flight.run(2.0)
    assert flight.status is DroneStatus.LANDED and "order_refused" in flight.codes
