"""Answers whether something is so: yes, no, or that nobody knows, with the evidence and its age."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from housefly.errors import WireError
from housefly.hub.api.questions import StateQuestion
from housefly.hub.api.state_answers import PersonAnswer, StateAnswer, Verdict
from housefly.hub.device_reports import LastReport, reports_on, why_no_report, why_not_believed
from housefly.hub.device_states import DEVICE_STATES, DeviceProperty
from housefly.hub.person_status import RoomMoment, spoken_name
from housefly.hub.situations.device_traits import DeviceTraits, traits_of
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.things.thing import Thing
from housefly.hub.things.words import age_words, lasting_words

_DEVICE_CONFIDENCE, _DISPUTED_CONFIDENCE = 0.95, 0.825
"""Confidence in a device that reports, and in one that another contradicts."""

PERSON_STATES: dict[str, Callable[[PersonAnswer], bool]] = {
    "lying": lambda who: who.posture == "lying",
    "sitting": lambda who: who.posture == "sitting",
    "standing": lambda who: who.posture == "standing",
    "walking": lambda who: who.posture == "walking",
    "in bed": lambda who: who.activity == "in bed",
    "up": lambda who: who.posture in ("standing", "walking", "sitting"),
    "on the floor": lambda who: who.activity == "on the floor",
    "fallen": lambda who: who.fallen > 0.0,
}
"""The words for a state of a person."""
_PRESENCE: dict[str, Verdict] = {
    "here": "yes", "home": "yes", "present": "yes", "away": "no", "gone": "no",
}  # fmt: skip
STATE_WORDS = tuple(
    sorted({*DEVICE_STATES, *PERSON_STATES, *_PRESENCE}, key=lambda s: (-len(s), s))
)
"""Every word for a state, the longest first."""


def device_answer(
    question: StateQuestion,
    thing: Thing,
    moment: RoomMoment,
    devices: Mapping[str, DeviceTraits],
    was_on: Callable[[str], bool | None],
) -> StateAnswer:
    """Return whether a thing is in a state, by the devices that tell about it.

    Args:
        question: the state.
        thing: of which it is asked.
        moment: the room.
        devices: what is known of measuring devices.
        was_on: whether a thing was on when last decided; for a power in between.
    """
    wanted, positive = _device_state(question.state)
    reports = reports_on(thing, wanted, moment, devices)
    if not reports:
        why = why_no_report(thing, question.state, wanted, devices, question.at is not None)
        return _unknown(question, thing, why, None, ())
    best = reports[0]
    age = max(0.0, moment.at - best.sample.captured_at)
    who, sources = spoken_name(thing.name), (best.sample.source,)
    told_of = traits_of(devices, best.sample.source).thing
    if not (best.is_fresh and moment.known):
        return _unknown(question, thing, why_not_believed(best, moment, len(reports)), age, sources)
    holds = best.verdict.holds
    if holds is None and wanted is DeviceProperty.ON:
        holds = was_on(told_of)
    said = f"{who} {best.verdict.clause}, {age_words(age)}"
    if holds is None:
        return _unknown(question, thing, f"{said}; {best.verdict.lacks}", age, sources)
    since = _since(moment, told_of, wanted) if holds else None
    duration = "" if since is None else lasting_words(moment.at - since)
    lasting = f" ({wanted.value}{duration})" if duration else ""
    others = _others(reports[1:], holds)
    verdict: Verdict = "yes" if holds is positive else "no"
    words = f"{verdict.capitalize()}: {said}{lasting}{others}"
    confidence = _DISPUTED_CONFIDENCE if others else _DEVICE_CONFIDENCE
    return StateAnswer(
        thing.id, thing.name, question.state, verdict, words, confidence, age, since, sources
    )


def person_state_answer(question: StateQuestion, who: PersonAnswer) -> StateAnswer:
    """Return whether somebody is in a state, by what the detectors say of them.

    Whoever lies on the floor without a fall that was seen may have fallen all the same.
    """
    state = _plain(question.state)
    if state in _PRESENCE:
        verdict = _verdict_of_presence(who.present, _PRESENCE[state])
    elif state in PERSON_STATES:
        known = who.posture or who.fallen or who.present == "no"
        holds = PERSON_STATES[state](who)
        if state == "fallen" and not holds and who.activity == "on the floor":
            known = False
        verdict = "unknown" if not known else "yes" if holds else "no"
    else:
        raise _no_such_state(question.state, (*PERSON_STATES, *_PRESENCE))
    start = "I do not know" if verdict == "unknown" else verdict.capitalize()
    confidence = 0.0 if verdict == "unknown" else (who.fallen or who.confidence or 0.9)
    return StateAnswer(
        who.person, who.name, question.state, verdict, f"{start}: {who.words}", confidence,
        who.age, who.since if verdict == "yes" else None, who.sources,
    )  # fmt: skip


def _plain(state: str) -> str:
    return " ".join(state.lower().split())


def _device_state(state: str) -> tuple[DeviceProperty, bool]:
    plain = _plain(state)
    if plain not in DEVICE_STATES:
        raise _no_such_state(state, tuple(DEVICE_STATES))
    return DEVICE_STATES[plain]


def _no_such_state(state: str, allowed: tuple[str, ...]) -> WireError:
    return WireError(f"state is {state!r}; allowed here: {', '.join(allowed)}")


def _verdict_of_presence(present: Verdict, wanted: Verdict) -> Verdict:
    if present == "unknown":
        return "unknown"
    return "yes" if present == wanted else "no"


def _others(reports: Sequence[LastReport], holds: bool) -> str:
    """Return what other sensors say that says otherwise, "" when none does."""
    against = [
        f"{report.sample.source} says that it {report.verdict.clause}"
        for report in reports
        if report.is_fresh and report.verdict.holds not in (None, holds)
    ]
    return f"; but {' and '.join(against)}" if against else ""


_LASTING = {
    DeviceProperty.ON: SituationKind.APPLIANCE_ON,
    DeviceProperty.OPEN: SituationKind.CONTACT_OPEN,
}
"""Situations that tell since when a state holds."""


def _since(moment: RoomMoment, thing: str, wanted: DeviceProperty) -> float | None:
    held = (s for s in moment.situations if s.kind == _LASTING.get(wanted) and s.thing == thing)
    return next((s.since for s in held), None)


def _unknown(
    question: StateQuestion, thing: Thing, why: str, age: float | None, sources: tuple[str, ...]
) -> StateAnswer:
    return StateAnswer(
        thing.id, thing.name, question.state, "unknown", f"I do not know: {why}", 0.0, age, None,
        sources,
    )  # fmt: skip
