"""Hysteresis in time: at most one situation per thing, each with one beginning and one end."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from housefly.hub.situations.confidence import CLAIM_THRESHOLD, KNOWN_THRESHOLD
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.situation import (
    Assessment,
    Situation,
    evidence_facts,
    evidence_words,
)
from housefly.messages import Facts, RoomEvent

NOT_KNOWN = "not known any more"
UNKNOWN = ("known", False)
"""The fact of an end that only says that the situation is unknown now."""
UNKNOWN_CONFIDENCE = 0.5
"""Confidence in such an end."""


class Hysteresis:
    """Claims at most one situation per thing; another must last for a while to replace it.

    Args:
        thing: that the situations are of.
        source: id of the detector.
        dwell: how long each kind must be found before it is claimed [s]; of None the time
            before the claim is given up.

    Attributes:
        situation: what is claimed, or None.
    """

    def __init__(
        self, thing: str, source: str, dwell: Mapping[SituationKind | None, float]
    ) -> None:
        self._thing, self._source, self._dwell = thing, source, dwell
        self._candidate: SituationKind | None = None
        self._candidate_since = 0.0
        self._changed_at = float("-inf")
        self.situation: Situation | None = None

    @property
    def kind(self) -> SituationKind | None:
        """The kind of the claimed situation."""
        return self.situation.kind if self.situation else None

    def update(self, now: float, assessment: Assessment | None) -> tuple[RoomEvent, ...]:
        """Return what begins or ends at a time [s] by an assessment, None if nothing is known."""
        if assessment is None or assessment.confidence < KNOWN_THRESHOLD:
            self._candidate = None
            return self._end(now, now, None)
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
        ended = self._end(now, since, assessment if sure else None)
        self._candidate = assessment.kind if sure else self.kind
        if not sure or assessment.kind is None:
            return ended
        return (*ended, self._begin(now, since, assessment.kind, assessment))

    def _begin(self, now: float, since: float, kind: SituationKind, found: Assessment) -> RoomEvent:
        self._changed_at = since
        self.situation = Situation(
            kind, self._thing, since, found.confidence, found.evidence, found.facts
        )
        facts = (*found.facts, *evidence_facts(found.evidence), ("noticed_at", now))
        return RoomEvent(
            kind.value, self._thing, since, self._source, found.cause, found.confidence, facts
        )

    def _end(self, now: float, at: float, why: Assessment | None) -> tuple[RoomEvent, ...]:
        """Return the end of the claim; without a reason it is only unknown now."""
        if self.situation is None:
            return ()
        over, self.situation = self.situation, None
        self._changed_at = at
        because = NOT_KNOWN if why is None else evidence_words(why.evidence)
        facts: Facts = (("because", because), ("lasted", at - over.since), ("noticed_at", now))
        if why is None:
            facts = (*facts, UNKNOWN)
        confidence = UNKNOWN_CONFIDENCE if why is None else why.confidence
        return (RoomEvent(over.kind.ended, self._thing, at, self._source, "", confidence, facts),)

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
