"""People and things in the way of a lock-step flight, scored on the truth."""

from __future__ import annotations

import pytest

from housefly.lab.safety_case.faulty_flight import fly_trial
from housefly.lab.safety_case.trial import TrialKey


@pytest.mark.parametrize(
    ("row", "seed", "least"),
    [
        pytest.param("F34/walks_up", 2, 0.3, marks=pytest.mark.safety),
        pytest.param("F34/walks_up", 3, 0.3, marks=pytest.mark.safety),
        pytest.param("F34/walks_up", 9, 0.1, marks=pytest.mark.safety),
        pytest.param("F34/head_on", 3, 0.0, marks=pytest.mark.safety),
        ("F34/head_on", 7, 0.3),
        pytest.param("F34/head_on", 9, 0.0, marks=pytest.mark.safety),
        pytest.param("F34/head_on", 10, 0.0, marks=pytest.mark.safety),
        pytest.param("F44/child", 3, 0.4, marks=pytest.mark.safety),
    ],
)
def test_nobody_is_touched(row: str, seed: int, least: float) -> None:
    """Who walks up while the drone climbs, turns, cruises and lands; a child on the pad."""
    result = fly_trial(TrialKey(row, seed))
    assert not result.violations
    assert result.person_clearance is not None
    assert result.person_clearance > least


@pytest.mark.parametrize(
    ("row", "seed"),
    [
        pytest.param("F03/above_child", 1, marks=pytest.mark.safety),
        pytest.param("F03/above_child", 5, marks=pytest.mark.safety),
        ("F03/above_lying", 4),
        pytest.param("F03/above_lying", 1, marks=pytest.mark.safety),
        pytest.param("F03/above_lying", 5, marks=pytest.mark.safety),
    ],
)
def test_without_tracking_it_lands_beside_whom_only_its_sonar_shows(row: str, seed: int) -> None:
    """A child below the drone, or somebody who lies there; without all this it lands on them."""
    result = fly_trial(TrialKey(row, seed))
    assert not result.violations
    assert result.ending == "stands on the floor"
    assert result.person_clearance is not None and result.person_clearance < 1.0


@pytest.mark.parametrize(
    ("row", "seed"),
    [
        ("F44/flat_box", 6),
        pytest.param("F44/pole", 6, marks=pytest.mark.safety),
        pytest.param("F44/pole", 0, marks=pytest.mark.safety),
    ],
)
def test_what_stands_or_lies_where_it_wants_to_land_is_landed_beside(row: str, seed: int) -> None:
    """A box of 0.12 m on the pad, and a thin pole beside it; the pole once, not again and again."""
    result = fly_trial(TrialKey(row, seed))
    assert not result.violations
    assert "not landing: something" in result.told
    assert result.safe_after is not None and result.safe_after < 40.0


@pytest.mark.safety
@pytest.mark.parametrize("seed", [2, 9, 12])
def test_a_chair_that_is_taken_for_a_person_does_not_keep_the_drone_in_the_air(seed: int) -> None:
    """It stands right beside the drone, and beside its pad when it comes home."""
    result = fly_trial(TrialKey("F35/0.65m", seed))
    assert not result.violations
    assert result.ending == "stands on the floor"


@pytest.mark.safety
def test_a_chair_beside_the_pad_is_told_and_landed_beside() -> None:
    """The hull's narrow side would fit; the watch of the way never lets it there."""
    result = fly_trial(TrialKey("F33/1m", 2))
    assert not result.violations
    assert result.told and result.ending == "stands on the floor"


@pytest.mark.safety
def test_who_runs_into_a_drone_that_takes_off_too_late_for_any_steering_is_counted_by_itself() -> (
    None
):
    """At 1.5 m/s from 3 m they arrive 0.6 s after the take-off ends."""
    result = fly_trial(TrialKey("F34/head_on", 1))
    assert not result.violations
    assert "person" in result.walked_into


@pytest.mark.safety
def test_what_a_drone_is_thrown_onto_belongs_to_the_blow() -> None:
    """Somebody runs into its take-off, and it lands on the sofa that it is thrown onto."""
    result = fly_trial(TrialKey("F34/head_on", 17))
    assert not result.violations
    assert "person" in result.walked_into
    assert "0.8 m" in result.ending


@pytest.mark.safety
def test_who_has_gone_by_no_longer_slows_the_drone_down() -> None:
    """It flew the rest of its service at half its speed, in silence: 95 s in place of 68."""
    result = fly_trial(TrialKey("F34/crosses", 20))
    assert not result.violations
    assert result.safe_after is not None and result.safe_after < 80.0
