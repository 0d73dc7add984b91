from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.web.control.lease import LEASE_TIMEOUT, Lease


def test_the_first_who_asks_gets_control() -> None:
    lease = Lease()
    assert lease.acquire(1, 0.0, flying=False, held=False) == ""
    assert lease.holder == 1


def test_on_the_ground_control_is_taken_without_holding() -> None:
    lease = Lease(1)
    assert lease.acquire(2, 0.0, flying=False, held=False) == ""
    assert lease.holder == 2


def test_in_flight_a_take_over_needs_the_hold() -> None:
    lease = Lease(1)
    assert "hold" in lease.acquire(2, 0.0, flying=True, held=False)
    assert lease.holder == 1
    assert lease.acquire(2, 0.0, flying=True, held=True) == ""
    assert lease.holder == 2


def test_only_the_holder_releases_and_gives() -> None:
    lease = Lease(1)
    assert lease.release(2) and lease.hand_over(2, 3, 0.0) and lease.holder == 1
    assert lease.hand_over(1, 3, 0.0) == "" and lease.holder == 3
    assert lease.release(3) == "" and lease.holder is None


def test_control_is_lost_after_three_silent_seconds_and_not_before() -> None:
    lease = Lease(1, renewed_at=10.0)
    assert not lease.expire(10.0 + LEASE_TIMEOUT)
    lease.renew(2, 12.0)
    assert lease.renewed_at == 10.0
    lease.renew(1, 12.0)
    assert not lease.expire(12.0 + LEASE_TIMEOUT)
    assert lease.expire(12.1 + LEASE_TIMEOUT)
    assert lease.holder is None
    assert not lease.expire(99.0)


MOVES = st.lists(
    st.tuples(
        st.sampled_from(["take", "hold", "release", "give"]), st.integers(1, 3), st.integers(1, 3)
    ),
    max_size=20,
)


@given(MOVES)
def test_in_flight_control_changes_only_by_its_holder_or_by_a_held_take_over(
    moves: list[tuple[str, int, int]],
) -> None:
    lease = Lease()
    for move, who, other in moves:
        before = lease.holder
        if move in ("take", "hold"):
            lease.acquire(who, 0.0, flying=True, held=move == "hold")
        elif move == "release":
            lease.release(who)
        else:
            lease.hand_over(who, other, 0.0)
        if before is not None and lease.holder != before:
            assert who == before or move == "hold"
