from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.web.http.rate_limit import COMMAND_BURST, COMMAND_RATE, CommandLimiter


@given(st.lists(st.floats(0.0, 0.2), max_size=300))
def test_never_more_commands_pass_than_rate_and_burst_allow(pauses: list[float]) -> None:
    limiter, now, passed = CommandLimiter(), 0.0, 0
    for pause in pauses:
        now += pause
        passed += limiter.spend(now)
    assert passed <= COMMAND_BURST + COMMAND_RATE * now + 1


def test_twenty_commands_a_second_always_pass() -> None:
    limiter = CommandLimiter()
    assert all(limiter.spend(n / COMMAND_RATE) for n in range(1000))


def test_refusals_are_counted_until_one_passes() -> None:
    limiter = CommandLimiter(tokens=0.0, at=1.0)
    assert not limiter.spend(1.0)
    assert not limiter.spend(1.0)
    assert limiter.refused == 2
    assert limiter.spend(2.0)
    assert limiter.refused == 0
