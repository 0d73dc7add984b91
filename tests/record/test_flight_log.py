"""Samples that come at times of their own are one flight: what was the newest at each time."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import RecordingError
from housefly.record.flight_log import LogSamples, Quantity, on_one_time

TIMES = st.lists(st.floats(0.0, 100.0), min_size=1, max_size=30)


def samples(quantity: Quantity, times: list[float]) -> LogSamples:
    """Return samples whose numbers are their time."""
    told = LogSamples(quantity)
    for at in times:
        told.add(at, *[at] * quantity.columns)
    return told


@given(TIMES, TIMES, st.sampled_from([Quantity.VELOCITY, Quantity.BATTERY, Quantity.WANTED]))
def test_each_row_has_the_newest_sample_that_is_not_too_old(
    places: list[float], others: list[float], quantity: Quantity
) -> None:
    log = on_one_time("log", [samples(Quantity.POSITION, places), samples(quantity, others)])
    told = {
        Quantity.VELOCITY: log.velocity[:, 0],
        Quantity.BATTERY: log.battery,
        Quantity.WANTED: log.wanted[:, 0],
    }[quantity]
    at = sorted(set(places))
    for now, value in zip(at, told, strict=True):
        before = [one for one in others if one <= now and now - one <= quantity.held]
        assert value == max(before) if before else np.isnan(value)
    assert np.allclose(log.time, np.array(at) - at[0])


@given(TIMES)
def test_without_positions_the_attitudes_make_the_rows(times: list[float]) -> None:
    log = on_one_time("log", [samples(Quantity.ATTITUDE, times)])
    assert log.time.size == len(set(times))
    assert np.isnan(log.position).all()
    assert set(log.lacks) == {one.words for one in Quantity} - {Quantity.ATTITUDE.words}


def test_without_either_there_is_no_flight() -> None:
    with pytest.raises(RecordingError, match="this log holds neither positions nor attitudes"):
        on_one_time("log", [samples(Quantity.BATTERY, [1.0])])
