"""Leads a person through the steps: takes a sample, doubts it, repeats, judges in the end; pure.

A doubt is asked once. Who presses Enter again with the drone where it was stands by it, and is not
asked about the same again: then tracking is wrong, and the verdict says how.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import dist

from housefly.config.tracking import TrackingConfig
from housefly.lab.frames.findings import FrameVerdict
from housefly.lab.frames.latency import tracking_lag
from housefly.lab.frames.plan import STEPS, CarryPlan, CarryStep
from housefly.lab.frames.plausibility import CheckKind, FailedCheck, failed_checks
from housefly.lab.frames.samples import (
    CarryTrack,
    FrameSample,
    NoSample,
    take_sample,
    unseen_sample,
)
from housefly.lab.frames.verdict import frame_verdict
from housefly.numeric import wrapped

_SAME_PLACE, _SAME_ANGLE = 0.08, 0.15
"""A drone that stayed within this was not moved since the last sample [m], [rad]."""
_PASSING = frozenset({CheckKind.LOST, CheckKind.FAST, CheckKind.NOSE, CheckKind.TURN})
"""What depends on how one step was done, and is asked about again in the next."""
_STAND_BY = "If it is as asked, leave it and press Enter again; else put it right, then Enter."


@dataclass(frozen=True, slots=True)
class Answer:
    """What a person is told after a sample.

    Attributes:
        accepted: the step is done.
        words: what was seen, or what to do.
        begins_anew: what was seen until now says nothing about the next sample.
    """

    accepted: bool
    words: tuple[str, ...]
    begins_anew: bool = True


@dataclass(slots=True)
class CarryGuide:
    """One frame check.

    Attributes:
        plan: the ways of the room.
        tracking: as configured.
        samples: one of each step that is done.
        lag: of tracking, from the turn [s]; None before it, or when unknown.
    """

    plan: CarryPlan
    tracking: TrackingConfig
    samples: tuple[FrameSample, ...] = ()
    lag: float | None = None
    _doubted: tuple[FrameSample, tuple[FailedCheck, ...]] | None = None
    _trusted: set[CheckKind] = field(default_factory=set)
    _unseen: int = 0

    @property
    def step(self) -> CarryStep | None:
        """The step that is to be done now, None after the last."""
        return STEPS[len(self.samples)] if len(self.samples) < len(STEPS) else None

    @property
    def instruction(self) -> str:
        """What to do now, in words."""
        return self.plan.instruction(self.step) if self.step else ""

    def offer(self, track: CarryTrack, now: float) -> Answer:
        """Take a sample: the person says that the step is done.

        Args:
            track: all that was seen since the last answer that began anew.
            now: same clock as its times [s].
        """
        assert self.step is not None
        if self.step is CarryStep.TURN:
            points = track.bodies.get(self.tracking.body, ())
            lag = tracking_lag(points, track.onboard)
            self.lag = self.lag if lag is None else lag
        found = take_sample(self.step, self.tracking.body, track, now)
        if isinstance(found, NoSample):
            return self._missed(found, track, now)
        self._unseen = 0
        if self.samples and self.samples[0].position is None:
            self.samples = ()
            return Answer(False, ("Now tracking sees it: begin anew from the pad.",))
        return self._judged(found, track)

    def is_still(self, track: CarryTrack, now: float) -> bool:
        """Return whether a sample could be taken now [s]: the drone is seen, and rests."""
        assert self.step is not None
        found = take_sample(self.step, self.tracking.body, track, now)
        return not isinstance(found, NoSample)

    def verdict(self) -> FrameVerdict:
        """Return what the samples come to; call it after the last step."""
        return frame_verdict(self.plan, self.tracking, self.samples, self.lag)

    def _missed(self, missing: NoSample, track: CarryTrack, now: float) -> Answer:
        assert self.step is not None
        never_seen = all(sample.position is None for sample in self.samples)
        self._unseen += missing.unseen
        if missing.unseen and never_seen and (self.samples or self._unseen > 1):
            return self._accepted(
                unseen_sample(self.step, self.tracking.body, track, now), "not seen"
            )
        words = [missing.words]
        if missing.unseen and never_seen:
            words.append("If it cannot be seen, press Enter again: another body may be carried.")
        return Answer(False, tuple(words), begins_anew=False)

    def _judged(self, sample: FrameSample, track: CarryTrack) -> Answer:
        if self._doubted is not None and _is_same(self._doubted[0], sample):
            self._trusted.update(doubt.kind for doubt in self._doubted[1])
            return self._accepted(sample, "taken as you say")
        found = tuple(
            doubt
            for doubt in failed_checks(self.plan, self.samples, sample, track, self.tracking.body)
            if doubt.kind not in self._trusted
        )
        if found:
            self._doubted = sample, found
            return Answer(False, (*(_sentence(doubt.words) for doubt in found), _STAND_BY))
        return self._accepted(sample, "good")

    def _accepted(self, sample: FrameSample, words: str) -> Answer:
        self.samples = (*self.samples, sample)
        self._doubted, self._unseen = None, 0
        self._trusted -= _PASSING
        return Answer(True, (words,))


def _is_same(a: FrameSample, b: FrameSample) -> bool:
    if a.position is None or b.position is None:
        return False
    near = dist(a.position, b.position) < _SAME_PLACE
    return near and abs(wrapped(a.yaw - b.yaw)) < _SAME_ANGLE


def _sentence(words: str) -> str:
    return words if words.endswith("?") else f"{words}."
