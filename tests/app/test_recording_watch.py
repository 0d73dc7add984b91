"""The light follows what the recorder says, and no longer than it says so."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.app.recording_watch import NEWS_AGE_MAX, NO_LIGHT, RecordingWatch
from housefly.config.capabilities import Capabilities
from housefly.messages import RecordingNews


class Lamp:
    """What a drone was told; the rest of a drone is not asked for."""

    def __init__(self, has_light: bool = True) -> None:
        able = {"setpoints": ["velocity"], "silence": {"after": 0.5, "answer": "lands"}}
        self.capabilities = Capabilities.model_validate({**able, "light": has_light})
        self.told: list[bool] = []

    def show_recording(self, records: bool) -> None:
        self.told.append(records)


def watch(lamp: Lamp, clock: list[float]) -> RecordingWatch:
    return RecordingWatch(lamp, lambda: clock[0])  # type: ignore[arg-type]


@given(st.lists(st.tuples(st.floats(0.01, 2.0), st.none() | st.booleans()), max_size=30))
def test_it_is_lit_as_long_as_what_was_said_counts(said: list[tuple[float, bool | None]]) -> None:
    lamp, clock = Lamp(), [100.0]
    shown, newest = watch(lamp, clock), None
    for pause, records in said:
        if records is not None:
            newest = RecordingNews(clock[0], records)
            shown.heard(newest)
        shown.refresh()
        counts = newest is not None and newest.records and clock[0] - newest.at <= NEWS_AGE_MAX
        assert (lamp.told[-1] if lamp.told else False) is counts
        clock[0] += pause


def test_a_drone_without_a_light_is_named_in_words_while_it_is_recorded() -> None:
    clock = [100.0]
    shown = watch(Lamp(has_light=False), clock)
    assert shown.note == ""
    shown.heard(RecordingNews(100.0, records=True))
    assert shown.note == NO_LIGHT
    clock[0] += NEWS_AGE_MAX + 0.1
    assert shown.note == ""


def test_what_comes_late_or_from_the_future_does_not_count() -> None:
    lamp, clock = Lamp(), [100.0]
    shown = watch(lamp, clock)
    shown.heard(RecordingNews(100.5, records=True))
    assert lamp.told == []
    shown.heard(RecordingNews(99.9, records=False))
    shown.heard(RecordingNews(99.5, records=True))
    assert lamp.told == []
