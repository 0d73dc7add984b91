"""Hysteresis in time: which of several situations is claimed of one thing, with one beginning and
one end each.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from housefly.hub.situations.situation import Finding, Situation
from housefly.hub.situations.trust import CLAIM, KNOWN
from housefly.messages import Happening

ENDED = " ended"
"""A happening of the situation's own kind is its beginning; with this behind it, its end."""
NOT_KNOWN = "not known any more"
EITHER_WAY = 0.5
"""Confidence of an end that only says that nothing is known any more."""


class Latch:
    """Claims at most one situation of a thing at a time; another must be found for a while before
    it takes its place.

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
        """What is claimed, or ""."""
        return self.situation.kind if self.situation else ""

    def step(self, now: float, finding: Finding | None) -> tuple[Happening, ...]:
        """Return what begins or ends by what is found at a time [s]; None where nothing is known."""
        if finding is None or finding.confidence < KNOWN:
            self._candidate = ""
            return self._end(now, now, NOT_KNOWN, EITHER_WAY)
        if finding.kind == self.kind:
            self._candidate = self.kind
            self._refresh(finding)
            return ()
        since = self._waiting_since(now, finding)
        if now - since < self._dwell[finding.kind]:
            return ()
        return self._change(now, since, finding)

    def _waiting_since(self, now: float, finding: Finding) -> float:
        found_since = now if finding.since is None else finding.since
        if self._candidate != finding.kind:
            self._candidate, self._candidate_since = finding.kind, found_since
        return max(min(self._candidate_since, now), self._changed_at)

    def _change(self, now: float, since: float, finding: Finding) -> tuple[Happening, ...]:
        sure = finding.confidence >= CLAIM
        why, confidence = (
            ("; ".join(finding.evidence), finding.confidence) if sure else (NOT_KNOWN, EITHER_WAY)
        )
        ended = self._end(now, since, why, confidence)
        self._candidate = finding.kind if sure else self.kind
        return (*ended, *self._begin(now, since, finding)) if sure and finding.kind else ended

    def _begin(self, now: float, since: float, found: Finding) -> tuple[Happening, ...]:
        self._changed_at = since
        self.situation = Situation(
            found.kind, self._thing, since, found.confidence, found.evidence, found.facts
        )
        facts = (*found.facts, ("evidence", "; ".join(found.evidence)), ("noticed_at", now))
        return (
            Happening(
                found.kind, self._thing, since, self._source, found.cause, found.confidence, facts
            ),
        )

    def _end(self, now: float, at: float, why: str, confidence: float) -> tuple[Happening, ...]:
        if self.situation is None:
            return ()
        over, self.situation = self.situation, None
        self._changed_at = at
        facts = (("because", why), ("lasted", at - over.since), ("noticed_at", now))
        return (Happening(over.kind + ENDED, self._thing, at, self._source, "", confidence, facts),)

    def _refresh(self, found: Finding) -> None:
        if self.situation is not None:
            self.situation = replace(
                self.situation,
                confidence=found.confidence,
                evidence=found.evidence,
                facts=found.facts,
            )
