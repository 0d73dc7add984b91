"""What the last gate remembers of the last seconds."""

from __future__ import annotations

from housefly.pilot.safety.timers import Window


def test_what_is_as_old_as_the_span_still_counts() -> None:
    window: Window[str] = Window(0.5)
    window.add(0.0, "first")
    window.add(0.25, "second")
    assert window.oldest(0.5) == "first" and window.values(0.5) == ["first", "second"]
    assert window.values(0.501) == ["second"] and window.values(0.751) == []


def test_what_is_kept_twice_in_a_row_counts_from_its_newest_time() -> None:
    window: Window[float] = Window(1.0)
    for at, value in ((0.0, 1.0), (0.5, 1.0), (0.75, 2.0)):
        window.add_or_renew(at, value)
    assert window.values(1.5) == [1.0, 2.0] and window.values(1.6) == [2.0]
