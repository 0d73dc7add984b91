from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.web.limits import BURST, RATE, Bucket


@given(st.lists(st.floats(0.0, 0.2), max_size=300))
def test_never_more_commands_pass_than_rate_and_burst_allow(pauses: list[float]) -> None:
    bucket, now, passed = Bucket(), 0.0, 0
    for pause in pauses:
        now += pause
        passed += bucket.spend(now)
    assert passed <= BURST + RATE * now + 1


def test_twenty_commands_a_second_always_pass() -> None:
    bucket = Bucket()
    assert all(bucket.spend(n / RATE) for n in range(1000))


def test_refusals_are_counted_until_one_passes() -> None:
    bucket = Bucket(tokens=0.0, at=1.0)
    assert not bucket.spend(1.0)
    assert not bucket.spend(1.0)
    assert bucket.over == 2
    assert bucket.spend(2.0)
    assert bucket.over == 0
