from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.estimation.commands import ROWS, CommandHistory, row_in_force
from housefly.estimation.lagged_axis import Axis, AxisModel, Spread, predicted, spread_out

MODEL = AxisModel(7.0, 1.0, 0.58, 2.0, 0.4, 0.2)
START = Axis(0.0, 0.1, 0.0, 0.0)
SPREAD = Spread(1e-4, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.1, 0.0, 0.01)


def history(delay: float, *rows: tuple[float, float, bool]) -> CommandHistory:
    made = CommandHistory(delay)
    for at, ax, flown in rows:
        made.add(at, ax, 0.0, flown)
    return made


def test_a_command_acts_one_delay_after_it_was_sent() -> None:
    past = history(0.06, (1.0, 1.0, True))
    assert past.roll(START, START, SPREAD, 1.0, 1.06, MODEL)[0].a == pytest.approx(0.0, abs=1e-9)
    assert past.roll(START, START, SPREAD, 1.0, 1.2, MODEL)[0].a > 0.5


def test_commands_given_between_start_and_end_are_each_used_for_their_time() -> None:
    past = history(0.0, (0.0, 1.0, True), (0.013, -2.0, True), (0.02, 0.0, False))
    rolled, _, spread = past.roll(START, START, SPREAD, 0.005, 0.03, MODEL)
    by_hand, p = START, SPREAD
    for u, flown, dt in ((1.0, True, 0.008), (-2.0, True, 0.007), (0.0, False, 0.01)):
        by_hand, p = predicted(by_hand, u, flown, MODEL, dt), spread_out(p, flown, MODEL, dt)
    assert tuple(rolled) == pytest.approx(tuple(by_hand), abs=1e-12)
    assert tuple(spread) == pytest.approx(tuple(p), abs=1e-12)


@given(st.floats(0.0, 0.3), st.integers(1, 40))
def test_rolling_in_two_parts_ends_where_rolling_at_once_does(delay: float, part: int) -> None:
    past = history(delay, *((0.01 * n, (-1.0) ** (n // 7), True) for n in range(60)))
    whole = past.roll(START, START, SPREAD, 0.1, 0.5, MODEL)[0]
    x, y, p = past.roll(START, START, SPREAD, 0.1, 0.1 + 0.01 * part, MODEL)
    assert tuple(past.roll(x, y, p, 0.1 + 0.01 * part, 0.5, MODEL)[0]) == pytest.approx(tuple(whole), abs=2e-4)


def test_a_start_before_the_first_command_counts_as_not_flown() -> None:
    past = history(0.0, (5.0, 1.0, True))
    rolled = past.roll(START, START, SPREAD, 0.0, 1.0, MODEL)[0]
    assert 0.0 < rolled.v < 0.05
    assert row_in_force(past.table, past.count, 0.0, 4.9) == -1


def test_the_newest_commands_survive_any_length_of_flight() -> None:
    past = history(0.06, *((0.01 * n, float(n), True) for n in range(3 * ROWS)))
    row = row_in_force(past.table, past.count, 0.06, 0.01 * 3 * ROWS)
    assert ROWS // 2 <= past.count <= ROWS
    assert past.table[row, 1] == 3 * ROWS - 6


def test_a_second_command_at_the_same_time_replaces_the_first() -> None:
    past = history(0.0, (1.0, 1.0, True), (1.0, 2.0, True))
    assert past.count == 1 and past.table[0, 1] == 2.0
