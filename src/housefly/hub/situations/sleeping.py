"""Who lies in an occupied bed that no other source sees: whoever was last seen beside it."""

from __future__ import annotations

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.hub.situations.situation import Assessment, Evidence

_BED_REACH = 1.0
"""Farthest distance from the bed of whoever lies down [m]."""
_BED_JOIN = 5.0
"""Longest time between their last sighting and the load on the bed [s]."""
_SLEEPER_CONFIDENCE = 0.85
"""Confidence that it was they who lay down."""


def assess_sleeper(
    person: str, now: float, tracks: PersonTracks, beds: Beds, layout: Layout
) -> Assessment | None:
    """Assess that a person lies in a bed; None without evidence, or if it might be two people."""
    for bed in sorted(layout.beds):
        claim = beds.situation(bed)
        if claim is None or _who(bed, claim.since, now, tracks, layout) != person:
            continue
        evidence = (*claim.evidence, Evidence(f"last seen beside {bed}"))
        return Assessment(
            SituationKind.PERSON_LYING,
            _SLEEPER_CONFIDENCE * claim.confidence,
            claim.since,
            evidence,
            (("on", bed), *claim.facts),
        )
    return None


def _who(bed: str, since: float, now: float, tracks: PersonTracks, layout: Layout) -> str:
    """Return the only person who may lie in a bed, "" if there is none or more than one."""
    candidates = [
        person
        for person in tracks.people()
        if _vanished_at(person, bed, since, now, tracks, layout)
    ]
    return candidates[0] if len(candidates) == 1 else ""


def _vanished_at(
    person: str, bed: str, since: float, now: float, tracks: PersonTracks, layout: Layout
) -> bool:
    track = tracks.latest(person)
    if track is None or tracks.best(person, now) is not None:
        return False
    return (
        abs(track.last.at - since) <= _BED_JOIN
        and layout.beds[bed].distance(track.last.position) <= _BED_REACH
    )
