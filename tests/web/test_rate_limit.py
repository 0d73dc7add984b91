from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.web.rate_limit import COMMAND_BURST, COMMAND_RATE, TokenBucket


@given(st.lists(st.floats(0.0, 0.2), max_size=300))
def test_never_more_commands_pass_than_rate_and_burst_allow(pauses: list[float]) -> None:
    bucket, now, passed = TokenBucket(), 0.0, 0
    for pause in pauses:
        now += pause
        passed += bucket.spend(now)
    assert passed <= COMMAND_BURST + COMMAND_RATE * now + 1


def test_twenty_commands_a_second_always_pass() -> None:
    bucket = TokenBucket()
    assert all(bucket.spend(n / COMMAND_RATE) for n in range(1000))


def test_refusals_are_counted_until_one_passes() -> None:
    bucket = TokenBucket(tokens=0.0, at=1.0)
    assert not bucket.spend(1.0)
    assert not bucket.spend(1.0)
    assert bucket.refused == 2
    assert bucket.spend(2.0)
    assert bucket.refused == 0
