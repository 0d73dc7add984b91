import numpy as np
import pytest

from housefly.geometry import quaternion_from_euler
from housefly.twin.quadrotor.body import STANDING_HEIGHT
from housefly.twin.quadrotor.onboard_sensors import FLOW_DELAY, OnboardSensors
from housefly.twin.simulated_body import CONTROL_PERIOD, BodyState

STILL = BodyState(
    (0.0, 0.0, 1.0 + STANDING_HEIGHT),
    (1.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0),
)


@pytest.fixture
def sensors() -> OnboardSensors:
    return OnboardSensors(np.random.default_rng(3))


def test_speed_is_told_forty_milliseconds_late(sensors: OnboardSensors) -> None:
    for _ in range(100):
        sensors.read(STILL)
    moving = STILL._replace(velocity=(1.0, 0.0, 0.0))
    readings = [sensors.read(moving).forward for _ in range(20)]
    first = next(n for n, value in enumerate(readings) if value > 0.5)
    assert first * CONTROL_PERIOD == pytest.approx(FLOW_DELAY)


def test_speed_is_told_in_the_body_frame(sensors: OnboardSensors) -> None:
    turned = STILL._replace(
        orientation=quaternion_from_euler(0.0, 0.0, np.pi / 2), velocity=(1.0, 0.0, 0.0)
    )
    readings = np.array(
        [(m.forward, m.left) for m in (sensors.read(turned) for _ in range(200))][20:]
    )
    assert readings.mean(axis=0) == pytest.approx((0.0, -1.0), abs=0.03)


def test_height_comes_25_times_a_second_and_never_below_the_floor(sensors: OnboardSensors) -> None:
    heights = [sensors.read(STILL).height for _ in range(200)]
    assert len(set(heights)) <= 26
    assert np.mean(heights[20:]) == pytest.approx(1.0, abs=0.02)
    grounded = STILL._replace(position=(0.0, 0.0, 0.0))
    assert min(sensors.read(grounded).height for _ in range(200)) >= 0.0


def test_a_flat_trim_makes_level_more_level() -> None:
    before, after = [], []
    for seed in range(60):
        sensors = OnboardSensors(np.random.default_rng(seed))
        before.append(sensors.read(STILL).phi)
        sensors.flat_trim()
        after.append(sensors.read(STILL).phi)
    assert np.std(after) < np.std(before) / 2


@pytest.mark.parametrize("lean", [-0.1, 0.05])
def test_a_flat_trim_takes_the_lean_of_the_floor_for_level(
    sensors: OnboardSensors, lean: float
) -> None:
    leaning = STILL._replace(orientation=quaternion_from_euler(0.0, lean, 0.0))
    assert sensors.read(leaning).theta == pytest.approx(lean, abs=0.02)
    sensors.flat_trim()
    assert sensors.read(leaning).theta == pytest.approx(0.0, abs=0.005)
    assert sensors.read(STILL).theta == pytest.approx(-lean, abs=0.005)


def test_the_heading_starts_at_zero_wherever_the_drone_faces_and_drifts_slowly(
    sensors: OnboardSensors,
) -> None:
    facing = STILL._replace(orientation=quaternion_from_euler(0.0, 0.0, 2.0))
    headings = [sensors.read(facing).psi for _ in range(12000)]
    assert abs(headings[0]) < 0.001
    assert 0.0 < abs(headings[-1]) < 0.15


def test_at_rest_the_accelerometer_feels_gravity_upwards(sensors: OnboardSensors) -> None:
    felt = np.mean([sensors.read(STILL).acceleration for _ in range(500)], axis=0)
    assert felt == pytest.approx((0.0, 0.0, 9.80665), abs=0.03)
