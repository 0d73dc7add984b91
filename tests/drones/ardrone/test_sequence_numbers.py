"""Sequence numbers against a drone that obeys only rising ones."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.drones.ardrone.link import SESSION_TIMEOUT, SequenceNumbers


class StrictDrone:
    """Obeys numbers above the last one, and 1."""

    def __init__(self, last: int) -> None:
        self.last = last
        self.obeyed_at = 0.0

    def hear(self, number: int, now: float) -> None:
        if number > self.last or number == 1:
            self.last, self.obeyed_at = number, now


def test_numbers_start_at_one_and_rise() -> None:
    numbers = SequenceNumbers()
    assert [numbers.reserve(2, 0.03 * n) for n in range(4)] == [1, 3, 5, 7]


def test_after_two_seconds_of_silence_they_start_again() -> None:
    numbers = SequenceNumbers()
    numbers.reserve(5, 0.0)
    assert numbers.reserve(1, SESSION_TIMEOUT - 0.1) == 6
    assert numbers.reserve(1, 2 * SESSION_TIMEOUT) == 1


def test_short_complaints_do_not_count() -> None:
    numbers = SequenceNumbers()
    for step in range(100):
        numbers.reserve(1, step * 0.03)
        numbers.report_reception(step % 5 != 0, step * 0.03)
    assert numbers.reserve(1, 3.0) == 101


@given(st.integers(2, 2**30), st.lists(st.booleans(), max_size=60))
def test_a_drone_that_obeyed_another_client_before_hears_us_soon(
    last: int, arrives: list[bool]
) -> None:
    numbers, drone = SequenceNumbers(), StrictDrone(last)
    arriving = [*arrives, *[True] * 40]
    for step, passes in enumerate(arriving):
        now = 0.03 * step
        numbers.report_reception(now - drone.obeyed_at < 0.1, now)
        number = numbers.reserve(1, now)
        if passes:
            drone.hear(number, now)
    assert drone.obeyed_at == 0.03 * (len(arriving) - 1)
