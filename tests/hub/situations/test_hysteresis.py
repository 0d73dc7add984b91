"""One beginning, one end, and never a claim without evidence."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.confidence import CLAIM_THRESHOLD, KNOWN_THRESHOLD
from housefly.hub.situations.hysteresis import (
    NOT_KNOWN,
    UNKNOWN,
    UNKNOWN_CONFIDENCE,
    Hysteresis,
)
from housefly.hub.situations.kinds import BEGUN_BY, SituationKind
from housefly.hub.situations.situation import Assessment, Evidence
from housefly.messages import RoomEvent

A, B = SituationKind.BED_OCCUPIED, SituationKind.APPLIANCE_ON
DWELL = {A: 1.0, B: 2.0, None: 3.0}
OLD = Evidence("old")
FINDINGS = st.none() | st.builds(Assessment, st.sampled_from([A, B, None]), st.floats(0.0, 1.0))


def hysteresis() -> Hysteresis:
    return Hysteresis("thing", "test", DWELL)


@given(st.lists(st.tuples(st.floats(0.0, 5.0), FINDINGS), max_size=60))
def test_beginnings_and_ends_alternate_in_order_of_time(
    rows: list[tuple[float, Assessment | None]],
) -> None:
    subject, now = hysteresis(), 0.0
    told: list[RoomEvent] = []
    for wait, assessment in rows:
        now += wait
        told += subject.update(now, assessment)
        assert subject.situation is None or subject.situation.since <= now
    assert [event.kind in BEGUN_BY for event in told] == [bool(n % 2) for n in range(len(told))]
    for begun, ended in zip(told[::2], told[1::2], strict=False):
        assert ended.kind == SituationKind(begun.kind).ended
    assert [event.at for event in told] == sorted(event.at for event in told)
    assert all(0.0 <= event.confidence <= 1.0 for event in told)
    assert all(event.confidence >= CLAIM_THRESHOLD for event in told[::2])


@given(st.lists(st.tuples(st.floats(0.0, 5.0), st.sampled_from([A, B, None])), max_size=40))
def test_findings_below_the_claim_never_begin_anything(
    rows: list[tuple[float, SituationKind | None]],
) -> None:
    subject, now = hysteresis(), 0.0
    for wait, kind in rows:
        now += wait
        assert subject.update(now, Assessment(kind, CLAIM_THRESHOLD - 0.01)) == ()


def test_what_is_found_shorter_than_its_dwell_is_not_claimed() -> None:
    subject = hysteresis()
    assert subject.update(0.0, Assessment(A, 0.9)) == subject.update(0.9, Assessment(A, 0.9)) == ()
    assert (
        subject.update(0.95, Assessment(None, 0.9)) == subject.update(1.5, Assessment(A, 0.9)) == ()
    )
    (begun,) = subject.update(2.5, Assessment(A, 0.9))
    assert (begun.kind, begun.at) == (A, 1.5)


def test_another_kind_takes_its_place_in_one_moment() -> None:
    subject = hysteresis()
    subject.update(0.0, Assessment(A, 0.9, since=-2.0))
    ended, begun = subject.update(9.0, Assessment(B, 0.8, since=5.0))
    assert (ended.kind, ended.at, begun.kind, begun.at) == (A.ended, 5.0, B, 5.0)
    assert dict(ended.facts)["lasted"] == 7.0 and UNKNOWN not in ended.facts


def test_ignorance_ends_a_claim_and_says_so() -> None:
    subject = hysteresis()
    subject.update(0.0, Assessment(A, 0.9, since=-2.0))
    (ended,) = subject.update(4.0, None)
    assert (ended.kind, ended.at, ended.confidence) == (A.ended, 4.0, UNKNOWN_CONFIDENCE)
    assert dict(ended.facts)["because"] == NOT_KNOWN and UNKNOWN in ended.facts


def test_a_weak_contradiction_ends_a_claim_without_making_another() -> None:
    subject = hysteresis()
    subject.update(0.0, Assessment(A, 0.9, since=-2.0))
    (ended,) = subject.update(9.0, Assessment(B, 0.4, since=5.0))
    assert (
        ended.kind == A.ended
        and dict(ended.facts)["because"] == NOT_KNOWN
        and UNKNOWN in ended.facts
    )
    assert subject.situation is None


def test_the_confidence_of_a_claim_follows_its_evidence() -> None:
    subject = hysteresis()
    subject.update(0.0, Assessment(A, 0.9, since=-2.0))
    subject.update(1.0, Assessment(A, 0.3, evidence=(OLD,)))
    assert subject.situation is not None
    assert (subject.situation.confidence, subject.situation.evidence, subject.situation.since) == (
        0.3,
        (OLD,),
        -2.0,
    )


def test_a_claim_whose_confidence_runs_out_is_not_known_any_more() -> None:
    subject = hysteresis()
    subject.update(0.0, Assessment(A, 0.9, since=-2.0))
    assert subject.update(1.0, Assessment(A, KNOWN_THRESHOLD)) == ()
    (ended,) = subject.update(2.0, Assessment(A, KNOWN_THRESHOLD - 0.01))
    assert dict(ended.facts)["because"] == NOT_KNOWN and UNKNOWN in ended.facts
