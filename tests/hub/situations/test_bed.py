"""A bed is occupied."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.bed import BED_HEARTBEAT, LOAD_OFF, LOAD_ON, Beds
from housefly.hub.situations.situation import Evidence
from housefly.messages import Observation, RoomEvent


def watch(*loads: tuple[float, float], until: float) -> tuple[Beds, list[RoomEvent]]:
    """Return what is said of a bed that says (time, load), looked at four times a second."""
    beds, rows = Beds({"bed"}), list(loads)
    told: list[RoomEvent] = []
    for now in (step * 0.25 for step in range(round(until * 4) + 1)):
        while rows and rows[0][0] <= now:
            at, load = rows.pop(0)
            beds.add(Observation("bed", "bed", at, at, facts=(("load", load),)))
        told += beds.update(now)
    return beds, told


def kinds(told: list[RoomEvent]) -> list[str]:
    return [event.kind for event in told]


def test_somebody_lies_down_and_gets_up() -> None:
    beds, told = watch((0, 0.1), (10, 58.0), (20, 58.2), (40, 0.0), until=50)
    assert [(event.kind, event.at) for event in told] == [
        ("bed occupied", 10.0),
        ("bed occupied ended", 40.0),
    ]
    assert beds.active() == ()


def test_the_claim_names_load_source_and_since_when() -> None:
    beds, _ = watch((0, 0.1), (10, 58.0), until=15)
    (claim,) = beds.active()
    assert (claim.kind, claim.thing, claim.since, claim.evidence) == (
        "bed occupied",
        "bed",
        10.0,
        (Evidence("load 58.0 kg", "bed"),),
    )
    assert dict(claim.facts) == {"load": 58.0}


@given(st.lists(st.floats(-5.0, LOAD_ON - 0.01), max_size=30))
def test_a_bag_on_the_bed_is_nobody(loads: list[float]) -> None:
    assert watch(*((float(n), load) for n, load in enumerate(loads)), until=len(loads) + 5)[1] == []


@given(st.lists(st.floats(LOAD_OFF, 500.0), max_size=30))
def test_somebody_who_turns_over_stays_in_bed(loads: list[float]) -> None:
    rows = [(0.0, 60.0), *((float(n), load) for n, load in enumerate(loads, start=3))]
    assert kinds(watch(*rows, until=len(loads) + 8)[1]) == ["bed occupied"]


def test_a_short_load_and_a_short_relief_do_not_count() -> None:
    assert watch((0, 0.0), (5, 60.0), (6, 0.0), until=12)[1] == []
    assert kinds(watch((0, 60.0), (5, 0.0), (7, 60.0), until=20)[1]) == ["bed occupied"]


def test_a_bed_that_falls_silent_is_believed_less_and_then_not_at_all() -> None:
    beds, told = watch((0, 60.0), until=3 * BED_HEARTBEAT)
    (claim,) = beds.active()
    assert claim.confidence == pytest.approx(0.95 / 2)
    beds, told = watch((0, 60.0), until=5 * BED_HEARTBEAT)
    assert kinds(told) == ["bed occupied", "bed occupied ended"] and beds.active() == ()
    assert dict(told[1].facts)["because"] == "not known any more"


def test_a_bed_without_load_cells_is_taken_at_its_word() -> None:
    beds = Beds({"bed"})
    beds.add(Observation("bed", "bed", 0.0, 0.0, facts=(("occupied", True),)))
    assert beds.update(0.0) == () and kinds(list(beds.update(2.0))) == ["bed occupied"]


@pytest.mark.parametrize(
    "said",
    [
        Observation("bed", "floor-1", 0.0, 0.0, facts=(("load", 60.0),)),
        Observation("bed", "bed", 0.0, 0.0, valid=False, facts=(("load", 60.0),)),
        Observation("sofa", "sofa", 0.0, 0.0, facts=(("load", 60.0),)),
        Observation("bed", "bed", 0.0, 0.0, facts=(("load", float("nan")),)),
        RoomEvent("bell pressed", "bed", 0.0, "bed"),
    ],
)
def test_what_is_no_word_of_a_bed_claims_nothing(said: Observation | RoomEvent) -> None:
    beds = Beds({"bed"})
    beds.add(said)
    assert beds.update(5.0) == () and beds.occupied("bed", 5.0) is None
