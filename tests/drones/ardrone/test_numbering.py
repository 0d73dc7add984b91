"""Sequence numbers against a drone that obeys only rising ones."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.drones.ardrone.numbering import SILENCE, Numbering


class StrictDrone:
    """Obeys numbers above the last one, and 1."""

    def __init__(self, last: int) -> None:
        self.last = last
        self.obeyed_at = 0.0

    def hear(self, number: int, now: float) -> None:
        if number > self.last or number == 1:
            self.last, self.obeyed_at = number, now


def test_numbers_start_at_one_and_rise() -> None:
    numbers = Numbering()
    assert [numbers.take(2, 0.03 * n) for n in range(4)] == [1, 3, 5, 7]


def test_after_two_seconds_of_silence_they_start_again() -> None:
    numbers = Numbering()
    numbers.take(5, 0.0)
    assert numbers.take(1, SILENCE - 0.1) == 6
    assert numbers.take(1, 2 * SILENCE) == 1


def test_short_complaints_do_not_count() -> None:
    numbers = Numbering()
    for step in range(100):
        numbers.take(1, step * 0.03)
        numbers.drone_hears(step % 5 != 0, step * 0.03)
    assert numbers.take(1, 3.0) == 101


@given(st.integers(2, 2**30), st.lists(st.booleans(), max_size=60))
def test_a_drone_that_obeyed_another_client_before_hears_us_soon(
    last: int, arrives: list[bool]
) -> None:
    numbers, drone = Numbering(), StrictDrone(last)
    arriving = [*arrives, *[True] * 40]
    for step, passes in enumerate(arriving):
        now = 0.03 * step
        numbers.drone_hears(now - drone.obeyed_at < 0.1, now)
        number = numbers.take(1, now)
        if passes:
            drone.hear(number, now)
    assert drone.obeyed_at == 0.03 * (len(arriving) - 1)
