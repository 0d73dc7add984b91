"""Where people are and how fast they move."""

from __future__ import annotations

from math import cos, hypot, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.person_tracks import (
    MAX_TRACKS,
    OUT_OF_SIGHT_AFTER,
    TRACK_HEARTBEAT,
    PersonTracks,
)
from housefly.hub.situations.posture import STOP_SPEED, WALK_SPEED
from housefly.messages import Observation

PERSON = (("kind", "person"),)


def seen(
    at: float,
    x: float,
    y: float = 0.0,
    person: str = "ann",
    source: str = "floor",
    sigma: float = 0.05,
) -> Observation:
    return Observation(
        person,
        source,
        at,
        at,
        (x, y, 0.0),
        covariance=(sigma**2, 0, 0, sigma**2, 0, 0),
        facts=PERSON,
    )


def tracks(*items: Observation) -> PersonTracks:
    subject = PersonTracks()
    for item in items:
        subject.add(item)
    return subject


@given(st.floats(0.0, 2.0), st.floats(-3.1, 3.1), st.floats(0.01, 1.5))
def test_a_straight_walk_has_its_speed_at_any_rate(
    speed: float, heading: float, period: float
) -> None:
    times = [n * period for n in range(round(3.0 / period) + 1)]
    walk = tracks(*(seen(t, speed * t * cos(heading), speed * t * sin(heading)) for t in times))
    track = walk.best("ann", times[-1])
    assert track is not None and track.speed() == pytest.approx(speed, abs=1e-6)


def test_the_noise_of_a_floor_is_no_walk_and_hides_none() -> None:
    rng = np.random.default_rng(3)
    for true, low, high in ((0.0, 0.0, STOP_SPEED), (0.8, WALK_SPEED, 1.2)):
        subject, speeds = PersonTracks(), []
        for t in (n * 0.1 for n in range(3000)):
            subject.add(
                seen(t, true * t + 0.03 * rng.standard_normal(), 0.03 * rng.standard_normal())
            )
            track = subject.best("ann", t)
            speeds.append(track.speed() if track else None)
        known = [speed for speed in speeds if speed is not None]
        assert len(known) > 2900 and low <= min(known) and max(known) < high


def test_one_position_has_no_speed() -> None:
    track = tracks(seen(0.0, 1.0)).best("ann", 0.1)
    assert track is not None and track.speed() is None


def test_the_more_exact_of_two_fresh_sources_is_taken() -> None:
    subject = tracks(
        seen(0.0, 1.0, source="laser", sigma=0.02), seen(0.0, 1.3, source="floor", sigma=0.05)
    )
    track = subject.best("ann", 0.5)
    assert track is not None and track.source == "laser"
    subject.add(seen(4.0, 1.3, source="floor"))
    track = subject.best("ann", 4.0)
    assert track is not None and track.source == "floor"


def test_a_silent_source_is_believed_less_and_then_not_at_all() -> None:
    subject = tracks(seen(0.0, 1.0))
    (track,) = subject.of("ann")
    assert subject.confidence(track, 2.0 * TRACK_HEARTBEAT) == 1.0
    assert subject.confidence(track, 3.0 * TRACK_HEARTBEAT) == 0.5
    assert subject.best("ann", 4.1 * TRACK_HEARTBEAT) is None and not subject.out_of_sight(track)


def test_who_is_not_seen_by_a_source_that_speaks_is_out_of_sight() -> None:
    subject = tracks(
        seen(0.0, 1.0),
        *(Observation("floor", "floor", t, t) for t in (0.5, 1.0, OUT_OF_SIGHT_AFTER + 0.1)),
    )
    (track,) = subject.of("ann")
    assert subject.out_of_sight(track) and subject.best("ann", OUT_OF_SIGHT_AFTER + 0.1) is None


def test_invalid_positions_things_and_contents_are_no_people() -> None:
    subject = tracks(
        Observation("ann", "floor", 0.0, 0.0, (1.0, 1.0, 0.0), valid=False, facts=PERSON),
        Observation("cup", "vicon", 0.0, 0.0, (1.0, 1.0, 0.0)),
        Observation("ann", "gate", 0.0, 0.0, None, facts=PERSON),
    )
    assert subject.people() == ()


def test_a_source_that_does_not_say_what_a_thing_is_is_helped_by_the_layout() -> None:
    subject = PersonTracks(frozenset({"visitor"}))
    subject.add(Observation("visitor", "vicon", 0.0, 0.0, (1.0, 1.0, 0.0)))
    assert subject.people() == ("visitor",)


def test_it_is_known_who_was_where_a_moment_ago() -> None:
    subject = tracks(*(seen(n * 0.1, n * 0.1) for n in range(50)))
    ((away, person, believed),) = subject.distances((2.0, 0.0), 2.0)
    assert (person, believed) == ("ann", 1.0) and away == pytest.approx(0.0, abs=0.06)


def test_a_flood_of_people_does_not_fill_the_memory() -> None:
    subject = tracks(*(seen(n * 0.01, 0.0, person=f"p{n}") for n in range(3 * MAX_TRACKS)))
    assert len(subject.people()) == MAX_TRACKS and f"p{3 * MAX_TRACKS - 1}" in subject.people()


def test_a_walk_seen_by_two_sources_that_disagree_has_the_speed_of_one() -> None:
    rows = [
        row
        for n in range(40)
        for row in (seen(n * 0.1, 0.0), seen(n * 0.1 + 0.05, 0.4, source="laser"))
    ]
    track = tracks(*rows).best("ann", 4.0)
    assert track is not None and hypot(track.speed() or 0.0) < 1e-9
