"""Rows that begin and rows that go on: nothing that a source said is lost by it."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.geometry import distance
from housefly.hub.store.run_length import MAX_SILENCE, STILL_DISTANCE, Run, RunLengthEncoder
from housefly.messages import Observation

steps = st.tuples(
    st.sampled_from((0.1, 5.0, 100.0)),
    st.sampled_from((0.0, 0.0015, 0.01, -1.0)),
    st.sampled_from(("", "box")),
    st.booleans(),
)


@given(st.lists(steps, max_size=30), st.integers(1, 5))
def test_the_row_that_stands_at_a_moment_says_what_was_said_then(
    walked: list[tuple[float, float, str, bool]], batch: int
) -> None:
    samples, at, x = [], 0.0, 0.0
    for gap, moved, inside, valid in walked:
        at, x = at + gap, x + moved
        samples.append(
            Observation("cup", "vicon", at, at, (x, 0.0, 0.0), inside=inside, valid=valid)
        )
    encoder, rows = RunLengthEncoder(), list[Run]()
    for first in range(0, len(samples), batch):
        rows += encoder.encode(samples[first : first + batch]).begun
    for sample in samples:
        row = [row for row in rows if row.sample.captured_at <= sample.captured_at][-1]
        assert row.until >= sample.captured_at
        assert (row.sample.inside, row.sample.valid) == (sample.inside, sample.valid)
        assert row.sample.position is not None and sample.position is not None
        assert distance(row.sample.position, sample.position) <= STILL_DISTANCE


@given(st.lists(st.floats(0.01, 2 * MAX_SILENCE), max_size=20))
def test_a_standing_thing_gets_a_row_for_each_long_silence_and_no_more(gaps: list[float]) -> None:
    encoder, at, rows, silences = RunLengthEncoder(), 1000.0, 0, 0
    for gap in (0.0, *gaps):
        silences += (at + gap) - at > MAX_SILENCE
        at += gap
        rows += len(encoder.encode([Observation("cup", "vicon", at, at, (1.0, 2.0, 3.0))]).begun)
    assert rows == 1 + silences


def test_a_row_that_goes_on_is_told_once_a_batch_and_a_new_row_not_twice() -> None:
    encoder = RunLengthEncoder()
    samples = [Observation("cup", "vicon", float(at), float(at)) for at in range(6)]
    first, then = encoder.encode(samples[:3]), encoder.encode(samples[3:])
    assert [(run.sample.captured_at, run.until) for run in first.begun] == [(0.0, 5.0)]
    assert first.extended == ()
    assert [run.until for run in then.extended] == [5.0]
    assert then.begun == ()
    encoder.reset()
    assert len(encoder.encode(samples[3:]).begun) == 1


def test_a_row_ends_when_another_source_puts_the_thing_into_something_else() -> None:
    encoder = RunLengthEncoder()

    def said(at: float, source: str, inside: str) -> int:
        return len(encoder.encode([Observation("cup", source, at, at, inside=inside)]).begun)

    assert said(0.0, "cabinet", "cabinet") == 1
    assert said(10.0, "cabinet", "cabinet") == 0
    assert said(15.0, "detector", "somebody") == 1
    assert said(30.0, "cabinet", "cabinet") == 1
    assert said(40.0, "cabinet", "cabinet") == 0
