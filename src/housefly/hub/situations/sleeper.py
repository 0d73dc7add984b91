"""Who lies in a bed that feels somebody, where no other source sees them: who was last seen beside
it just then.
"""

from __future__ import annotations

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.posture import LYING
from housefly.hub.situations.situation import Finding
from housefly.hub.situations.tracks import Tracks

BED_REACH = 1.0
"""Who lies down was last seen at most this far from the bed [m]."""
BED_JOIN = 5.0
"""And at most this long before or after it felt somebody [s]."""
BELIEF = 0.85
"""Confidence that it was they who lay down."""


def sleeper_finding(
    person: str, now: float, tracks: Tracks, beds: Beds, layout: Layout
) -> Finding | None:
    """Return that a person lies in a bed, None when nothing says so or two people might be it."""
    for bed in sorted(layout.beds):
        claim = beds.situation(bed)
        if claim is None or _who(bed, claim.since, now, tracks, layout) != person:
            continue
        words = (*claim.evidence, f"last seen beside {bed}")
        return Finding(
            LYING, BELIEF * claim.confidence, claim.since, words, (("on", bed), *claim.facts)
        )
    return None


def _who(bed: str, since: float, now: float, tracks: Tracks, layout: Layout) -> str:
    """Return the only person who may lie in a bed, "" when there is none or more than one."""
    candidates = [
        person
        for person in tracks.people()
        if _vanished_at(person, bed, since, now, tracks, layout)
    ]
    return candidates[0] if len(candidates) == 1 else ""


def _vanished_at(
    person: str, bed: str, since: float, now: float, tracks: Tracks, layout: Layout
) -> bool:
    track = tracks.latest(person)
    if track is None or tracks.best(person, now) is not None:
        return False
    return (
        abs(track.last.at - since) <= BED_JOIN
        and layout.beds[bed].distance(track.last.position) <= BED_REACH
    )
