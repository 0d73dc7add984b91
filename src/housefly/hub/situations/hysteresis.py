"""Hysteresis in time: at most one situation per thing, each with one beginning and one end."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from housefly.hub.situations.confidence import CLAIM_THRESHOLD, KNOWN_THRESHOLD
from housefly.hub.situations.situation import Assessment, Situation
from housefly.messages import RoomEvent

ENDED_SUFFIX = " ended"
"""The event that ends a situation is its kind with this suffix."""
NOT_KNOWN = "not known any more"
UNKNOWN_CONFIDENCE = 0.5
"""Confidence of an end that only says that the situation is unknown now."""


class Hysteresis:
    """Claims at most one situation per thing; another must last for a while to replace it.

    Args:
        thing: that the situations are of.
        source: id of the detector.
        dwell: how long each kind must be found before it is claimed [s]; of "" the time before the
            claim is given up.

    Attributes:
        situation: what is claimed, or None.
    """

    def __init__(self, thing: str, source: str, dwell: Mapping[str, float]) -> None:
        self._thing, self._source, self._dwell = thing, source, dwell
        self._candidate, self._candidate_since = "", 0.0
        self._changed_at = float("-inf")
        self.situation: Situation | None = None

    @property
    def kind(self) -> str:
        """The kind of the claimed situation, or ""."""
        return self.situation.kind if self.situation else ""

    def update(self, now: float, assessment: Assessment | None) -> tuple[RoomEvent, ...]:
        """Return what begins or ends at a time [s] by an assessment, None if nothing is known."""
        if assessment is None or assessment.confidence < KNOWN_THRESHOLD:
            self._candidate = ""
            return self._end(now, now, NOT_KNOWN, UNKNOWN_CONFIDENCE)
        if assessment.kind == self.kind:
            self._candidate = self.kind
            self._refresh(assessment)
            return ()
        since = self._waiting_since(now, assessment)
        if now - since < self._dwell[assessment.kind]:
            return ()
        return self._change(now, since, assessment)

    def _waiting_since(self, now: float, assessment: Assessment) -> float:
        found_since = now if assessment.since is None else assessment.since
        if self._candidate != assessment.kind:
            self._candidate, self._candidate_since = assessment.kind, found_since
        return max(min(self._candidate_since, now), self._changed_at)

    def _change(self, now: float, since: float, assessment: Assessment) -> tuple[RoomEvent, ...]:
        sure = assessment.confidence >= CLAIM_THRESHOLD
        why, confidence = (
            ("; ".join(assessment.evidence), assessment.confidence)
            if sure
            else (NOT_KNOWN, UNKNOWN_CONFIDENCE)
        )
        ended = self._end(now, since, why, confidence)
        self._candidate = assessment.kind if sure else self.kind
        return (*ended, *self._begin(now, since, assessment)) if sure and assessment.kind else ended

    def _begin(self, now: float, since: float, found: Assessment) -> tuple[RoomEvent, ...]:
        self._changed_at = since
        self.situation = Situation(
            found.kind, self._thing, since, found.confidence, found.evidence, found.facts
        )
        facts = (*found.facts, ("evidence", "; ".join(found.evidence)), ("noticed_at", now))
        return (
            RoomEvent(
                found.kind, self._thing, since, self._source, found.cause, found.confidence, facts
            ),
        )

    def _end(self, now: float, at: float, why: str, confidence: float) -> tuple[RoomEvent, ...]:
        if self.situation is None:
            return ()
        over, self.situation = self.situation, None
        self._changed_at = at
        facts = (("because", why), ("lasted", at - over.since), ("noticed_at", now))
        return (
            RoomEvent(
                over.kind + ENDED_SUFFIX, self._thing, at, self._source, "", confidence, facts
            ),
        )

    def _refresh(self, found: Assessment) -> None:
        if self.situation is not None:
            self.situation = replace(
                self.situation,
                confidence=found.confidence,
                evidence=found.evidence,
                facts=found.facts,
            )


def claimed_by(rows: Iterable[Hysteresis]) -> tuple[Situation, ...]:
    """Return the situations that are claimed, in the order given."""
    return tuple(row.situation for row in rows if row.situation is not None)
