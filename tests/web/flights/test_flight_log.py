"""The logs of flights: written while they are flown, read again, and never believed unread."""

from __future__ import annotations

from dataclasses import replace
from math import inf, nan
from pathlib import Path

import pytest
from fake_pilot import FakePilot
from fake_room import example_room
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.clock import SteppedClock
from housefly.errors import RecordingError
from housefly.messages import DroneStatus, Order, OrderKind, Phase, SafetyMode, Severity
from housefly.web.flights.flight_book import FlightBook
from housefly.web.flights.flight_log import (
    FlightEnd,
    FlightHead,
    FlightNote,
    FlightPath,
    Line,
    LoggedPose,
    LoggedStage,
    line_text,
    parsed_line,
)
from housefly.web.flights.flight_log_writer import FlightLogWriter
from housefly.web.status.state_feed import StateFeed

TOPICS = DroneTopics()

START = 1_800_000_000.25
NAME = "20270115T080000250Z"
TIME, METRES, WORDS = st.floats(0.0, 2400.0), st.floats(-1e4, 1e4), st.text(max_size=40)
PLACE = st.tuples(METRES, METRES, METRES)
NUMBERS = st.lists(METRES, max_size=4).map(tuple)
LINES: st.SearchStrategy[Line] = st.one_of(
    st.builds(FlightHead, st.just(1), WORDS, st.floats(0.0, 1e11)),
    st.builds(
        LoggedPose,
        TIME,
        st.none() | PLACE,
        st.floats(-3.2, 3.2),
        st.floats(0.0, 9.0),
        st.floats(0.0, 1.0),
    ),
    st.builds(LoggedStage, TIME, st.sampled_from(Phase), st.sampled_from(SafetyMode), WORDS),
    st.builds(
        FlightPath,
        TIME,
        st.lists(st.tuples(METRES, METRES), max_size=4).map(tuple),
        NUMBERS,
        NUMBERS,
        NUMBERS,
    ),
    st.builds(FlightNote, TIME, st.sampled_from(Severity), WORDS, WORDS),
    st.builds(FlightEnd, TIME, WORDS, st.sampled_from(Severity)),
)


@given(LINES)
def test_every_line_comes_back_as_it_was_written(line: Line) -> None:
    assert parsed_line(line_text(line)) == line
    assert line_text(line).count("\n") == 1


@given(st.one_of(st.text(max_size=200), LINES.map(line_text).map(lambda text: text[:-3])))
def test_what_is_no_line_is_refused_in_words(text: str) -> None:
    with pytest.raises(RecordingError, match="not a line of a flight's log"):
        parsed_line(text)


@pytest.mark.parametrize(
    "text",
    [
        '{"sample":{"t":-1.0,"place":null,"yaw":0.0,"speed":0.0,"battery":0.5}}',
        '{"sample":{"t":1.0,"place":[1.0,2.0],"yaw":0.0,"speed":0.0,"battery":0.5}}',
        '{"sample":{"t":1.0,"place":[1e9,2.0,1.0],"yaw":0.0,"speed":0.0,"battery":0.5}}',
        '{"sample":{"t":1.0,"place":null,"yaw":0.0,"speed":0.0,"battery":50}}',
        '{"sample":{"t":1.0,"place":null,"yaw":NaN,"speed":0.0,"battery":0.5}}',
        '{"note":{"t":1.0,"severity":"terrible","code":"","text":""}}',
        '{"flight":{"version":2,"site":"","started_at":0.0}}',
        '{"flight":{"version":1,"site":"","started_at":0.0,"more":1}}',
    ],
)
def test_values_out_of_their_range_are_refused(text: str) -> None:
    with pytest.raises(RecordingError):
        parsed_line(text)


def flown(folder: Path, seconds: float = 12.0, after: float = 6.0) -> FlightBook:
    """Fly with the made-up pilot while a log is kept: up, to the entrance, down.

    The console ends so long [s] after the order to land.
    """
    bus, clock = LocalBus(), SteppedClock(100.0)
    writer = FlightLogWriter(folder, "a site", lambda: START)
    feed = StateFeed(clock, "ardrone", flights=writer)
    feed.listen(bus)
    pilot = FakePilot(bus.join(), example_room(), clock)

    def fly(duration: float) -> None:
        for _ in range(round(50 * duration)):
            clock.advance(0.02)
            pilot.advance(0.02)

    fly(0.5)
    bus.publish(TOPICS.order, Order(OrderKind.GO, place="entrance", sender="me"))
    fly(seconds)
    pilot.add_event(Severity.WARNING, "going_on", "something to worry about")
    bus.publish(TOPICS.order, Order(OrderKind.LAND, sender="me"))
    fly(after)
    assert after < 6.0 or pilot.status is DroneStatus.LANDED
    writer.close()
    return FlightBook(folder)


@pytest.fixture(scope="module")
def book(tmp_path_factory: pytest.TempPathFactory) -> FlightBook:
    return flown(tmp_path_factory.mktemp("site") / "flights")


def test_a_flight_is_kept_from_take_off_until_it_lies_still(book: FlightBook) -> None:
    (found,) = book.flights()
    assert (found.id, found.started_at, found.complete) == (NAME, START, True)
    assert (found.goal, found.worst) == ("Entrance", Severity.WARNING)
    replay = book.replay(NAME)
    assert replay.flight == found
    # Two seconds on the ground, and not the time after them.
    assert 15.0 < found.duration < 17.0 and found.duration - replay.t[-1] <= 0.11
    assert replay.z[0] == pytest.approx(0.0, abs=0.05) and max(z or 0.0 for z in replay.z) > 1.0
    steps = [b - a for a, b in zip(replay.t, replay.t[1:], strict=False)]
    assert max(steps) < 0.13 and min(steps) > 0.09
    phases = [stage.phase for stage in replay.stages]
    assert phases == [Phase.TAKING_OFF, Phase.OUTBOUND, Phase.LANDING, Phase.IDLE]
    assert [len(path.waypoints) > 1 for path in replay.paths] == [True, False]
    texts = [note.text for note in replay.notes]
    assert "something to worry about" in texts and "Landed" in texts


@pytest.mark.parametrize("after", [0.02, 0.32, 1.0, 1.54, 1.86, 2.0, 3.72])
def test_a_console_that_ends_in_flight_leaves_a_log_that_can_be_read(
    tmp_path: Path, after: float
) -> None:
    book = flown(tmp_path, 2.0, after)
    (found,) = book.flights()
    replay = book.replay(NAME)
    assert found.complete and replay.flight == found
    assert max(replay.t[-1], replay.notes[-1].t, replay.stages[-1].t) <= found.duration


def test_the_files_are_for_their_owner_only(tmp_path: Path) -> None:
    folder = tmp_path / "flights"
    flown(folder, 1.0)
    assert folder.stat().st_mode & 0o777 == 0o700
    assert {one.stat().st_mode & 0o777 for one in folder.iterdir()} == {0o600}


def test_a_flight_whose_console_died_ends_with_its_last_whole_line(
    book: FlightBook, tmp_path: Path
) -> None:
    whole = (book._folder / f"{NAME}.jsonl").read_bytes()
    (tmp_path / f"{NAME}.jsonl").write_bytes(whole[: len(whole) // 2])
    cut = FlightBook(tmp_path)
    (found,) = cut.flights()
    replay = cut.replay(NAME)
    assert not found.complete and not replay.flight.complete
    assert 0.0 < replay.flight.duration < book.flights()[0].duration
    assert replay.flight.duration == found.duration
    assert replay.t == book.replay(NAME).t[: len(replay.t)]


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(st.data())
def test_a_damaged_log_is_refused_or_read_and_nothing_else(
    book: FlightBook, tmp_path: Path, data: st.DataObject
) -> None:
    damaged = bytearray((book._folder / f"{NAME}.jsonl").read_bytes())
    for _ in range(data.draw(st.integers(1, 3))):
        damaged[data.draw(st.integers(0, len(damaged) - 1))] = data.draw(st.integers(0, 255))
    (tmp_path / f"{NAME}.jsonl").write_bytes(damaged)
    other = FlightBook(tmp_path)
    assert len(other.flights()) <= 1
    try:
        replay = other.replay(NAME)
    except RecordingError as error:
        assert NAME in str(error)
    else:
        assert list(replay.t) == sorted(replay.t) and max(replay.t) < inf


def test_times_that_go_back_are_refused(book: FlightBook, tmp_path: Path) -> None:
    rows = (book._folder / f"{NAME}.jsonl").read_text().splitlines(keepends=True)
    (tmp_path / f"{NAME}.jsonl").write_text("".join([rows[0], *rows[:0:-1]]))
    with pytest.raises(RecordingError, match="its times go back"):
        FlightBook(tmp_path).replay(NAME)


@pytest.mark.parametrize("name", ["../room", "room.db", "", NAME + "x", "20270115T080000251Z"])
def test_no_other_file_is_read(book: FlightBook, name: str) -> None:
    with pytest.raises(RecordingError, match="there is no flight"):
        book.replay(name)


def test_a_link_to_another_file_is_not_followed(book: FlightBook, tmp_path: Path) -> None:
    (tmp_path / f"{NAME}.jsonl").symlink_to(book._folder / f"{NAME}.jsonl")
    with pytest.raises(RecordingError, match="there is no flight"):
        FlightBook(tmp_path).replay(NAME)
    assert FlightBook(tmp_path).flights() == ()


def test_the_oldest_flights_are_forgotten(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("housefly.web.flights.flight_log_writer._FLIGHTS_KEPT", 3)
    for day in range(1, 6):
        (tmp_path / f"2026010{day}T080000000Z.jsonl").write_text("")
    flown(tmp_path, 1.0)
    assert sorted(one.stem for one in tmp_path.iterdir()) == [
        "20260103T080000000Z",
        "20260104T080000000Z",
        "20260105T080000000Z",
        NAME,
    ]


def test_a_drone_that_nobody_sees_has_no_place_in_the_log(tmp_path: Path) -> None:
    writer = FlightLogWriter(tmp_path, "a site", lambda: START)
    clock, bus = SteppedClock(100.0), LocalBus()
    feed = StateFeed(clock, "ardrone")
    feed.listen(bus)
    pilot = FakePilot(bus.join(), example_room(), clock)
    pilot.status = DroneStatus.FLYING
    for k in range(100):
        clock.advance(0.02)
        pilot.advance(0.02)
        step = feed.step
        assert step is not None
        seen = step.outputs.estimate
        assert seen is not None
        wild = replace(seen, position=(nan, 1e9, 1.0))
        estimate = seen if k <= 50 else wild if k <= 75 else None
        hidden = replace(step, outputs=replace(step.outputs, estimate=estimate))
        writer.hear(hidden, 0, feed.path)
    writer.close()
    replay = FlightBook(tmp_path).replay(NAME)
    assert [x is None for x in replay.x] == [False] * 11 + [True] * (len(replay.x) - 11)
    assert [x is None for x in replay.x] == [y is None for y in replay.y]
