from __future__ import annotations

import contextlib

from housefly.web.http.seats import Seats


def test_there_are_seats_for_all_together_too() -> None:
    seats = Seats(most=5, each=2)
    with contextlib.ExitStack() as stack:
        taken = [
            stack.enter_context(seats.taken(name)) for name in ("a", "a", "a", "b", "b", "c", "d")
        ]
        assert taken == [True, True, False, True, True, True, False]
    with seats.taken("d") as free:
        assert free
