"""When a flight without a person is ordered."""

from __future__ import annotations

from housefly.app.headless import LONGEST_GAP, STEADY_TIME, Steadiness
from housefly.messages import Action, Command, Inputs, Outputs, PilotStep, Pose, Sighting


def steady_after(seen: list[bool], body: str = "ardrone") -> list[bool]:
    """Return what is thought of each hundredth of a second, in some of which a body was seen."""
    steadiness = Steadiness("ardrone")
    found = []
    for number, is_seen in enumerate(seen):
        now = 5.0 + 0.01 * number
        sightings = (Sighting(body, Pose((1.0, 1.0, 0.1)), now - 0.02, now),) if is_seen else ()
        found.append(
            steadiness.update(
                PilotStep(number, now, Inputs(sightings), Outputs(Command(Action.IDLE)))
            )
        )
    return found


def test_it_is_steady_after_a_second_without_a_gap_at_100_and_at_10_hz() -> None:
    for every in (1, 10):
        found = steady_after([number % every == 0 for number in range(200)])
        assert not any(found[: int(100 * STEADY_TIME) - 1]) and all(
            found[int(100 * STEADY_TIME) + 10 :]
        )


def test_after_a_gap_the_second_begins_anew() -> None:
    gap = int(100 * LONGEST_GAP) + 5
    found = steady_after([True] * 150 + [False] * gap + [True] * 150)
    assert (
        found[149]
        and not any(found[150 + int(100 * LONGEST_GAP) + 2 : 150 + gap + 95])
        and found[-1]
    )


def test_other_bodies_do_not_count_and_silence_is_not_steady() -> None:
    assert not any(steady_after([True] * 300, body="visitor"))
    assert not any(steady_after([False] * 300))
