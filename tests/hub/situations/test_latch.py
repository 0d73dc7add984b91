"""One beginning, one end, and never a claim without evidence."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.latch import EITHER_WAY, ENDED, NOT_KNOWN, Latch
from housefly.hub.situations.situation import Finding
from housefly.hub.situations.trust import CLAIM, KNOWN
from housefly.messages import Happening

DWELL = {"a": 1.0, "b": 2.0, "": 3.0}
FINDINGS = st.none() | st.builds(Finding, st.sampled_from(["a", "b", ""]), st.floats(0.0, 1.0))


def latch() -> Latch:
    return Latch("thing", "test", DWELL)


@given(st.lists(st.tuples(st.floats(0.0, 5.0), FINDINGS), max_size=60))
def test_beginnings_and_ends_alternate_in_order_of_time(
    rows: list[tuple[float, Finding | None]],
) -> None:
    subject, now = latch(), 0.0
    told: list[Happening] = []
    for wait, finding in rows:
        now += wait
        told += subject.step(now, finding)
        assert subject.situation is None or subject.situation.since <= now
    assert [happening.kind.endswith(ENDED) for happening in told] == [
        bool(n % 2) for n in range(len(told))
    ]
    for begun, ended in zip(told[::2], told[1::2], strict=False):
        assert ended.kind == begun.kind + ENDED
    assert [happening.at for happening in told] == sorted(happening.at for happening in told)
    assert all(0.0 <= happening.confidence <= 1.0 for happening in told)
    assert all(happening.confidence >= CLAIM for happening in told[::2])


@given(st.lists(st.tuples(st.floats(0.0, 5.0), st.sampled_from(["a", "b", ""])), max_size=40))
def test_findings_below_the_claim_never_begin_anything(rows: list[tuple[float, str]]) -> None:
    subject, now = latch(), 0.0
    for wait, kind in rows:
        now += wait
        assert subject.step(now, Finding(kind, CLAIM - 0.01)) == ()


def test_what_is_found_shorter_than_its_dwell_is_not_claimed() -> None:
    subject = latch()
    assert subject.step(0.0, Finding("a", 0.9)) == subject.step(0.9, Finding("a", 0.9)) == ()
    assert subject.step(0.95, Finding("", 0.9)) == subject.step(1.5, Finding("a", 0.9)) == ()
    (begun,) = subject.step(2.5, Finding("a", 0.9))
    assert (begun.kind, begun.at) == ("a", 1.5)


def test_another_kind_takes_its_place_in_one_moment() -> None:
    subject = latch()
    subject.step(0.0, Finding("a", 0.9, since=-2.0))
    ended, begun = subject.step(9.0, Finding("b", 0.8, since=5.0))
    assert (ended.kind, ended.at, begun.kind, begun.at) == ("a ended", 5.0, "b", 5.0)
    assert dict(ended.facts)["lasted"] == 7.0


def test_ignorance_ends_a_claim_and_says_so() -> None:
    subject = latch()
    subject.step(0.0, Finding("a", 0.9, since=-2.0))
    (ended,) = subject.step(4.0, None)
    assert (ended.kind, ended.at, ended.confidence) == ("a ended", 4.0, EITHER_WAY)
    assert dict(ended.facts)["because"] == NOT_KNOWN


def test_a_weak_contradiction_ends_a_claim_without_making_another() -> None:
    subject = latch()
    subject.step(0.0, Finding("a", 0.9, since=-2.0))
    (ended,) = subject.step(9.0, Finding("b", 0.4, since=5.0))
    assert ended.kind == "a ended" and dict(ended.facts)["because"] == NOT_KNOWN
    assert subject.situation is None


def test_the_confidence_of_a_claim_follows_its_evidence() -> None:
    subject = latch()
    subject.step(0.0, Finding("a", 0.9, since=-2.0))
    subject.step(1.0, Finding("a", 0.3, evidence=("old",)))
    assert subject.situation is not None
    assert (subject.situation.confidence, subject.situation.evidence, subject.situation.since) == (
        0.3,
        ("old",),
        -2.0,
    )


def test_a_claim_whose_confidence_runs_out_is_not_known_any_more() -> None:
    subject = latch()
    subject.step(0.0, Finding("a", 0.9, since=-2.0))
    assert subject.step(1.0, Finding("a", KNOWN)) == ()
    (ended,) = subject.step(2.0, Finding("a", KNOWN - 0.01))
    assert dict(ended.facts)["because"] == NOT_KNOWN
