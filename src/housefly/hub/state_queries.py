"""Answers whether something is so: yes, no, or that nobody knows, with the evidence and its age."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from housefly.errors import WireError
from housefly.hub.api.questions import StateQuestion
from housefly.hub.api.state_answers import PersonAnswer, StateAnswer, Verdict
from housefly.hub.device_states import (
    DEVICE_STATES,
    DeviceProperty,
    DeviceVerdict,
    device_verdict,
    heartbeat_of,
    strength,
    telling_fact,
    tells,
)
from housefly.hub.person_status import RoomMoment, evidence_sources, lasting_words, spoken_name
from housefly.hub.situations.appliance import APPLIANCE_ON, CONTACT_OPEN
from housefly.hub.situations.device_traits import DeviceTraits, traits_of
from housefly.hub.things.thing import Thing
from housefly.hub.things.words import age_words
from housefly.messages import Observation

_MISSED_BEATS = 2.0
"""After this many heartbeats without a word a device is silent."""
_DEVICE_CONFIDENCE = 0.95
"""Confidence in a device that reports."""

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


@dataclass(frozen=True, slots=True)
class _Report:
    """The last report of one device about a state, and whether it may be believed still."""

    sample: Observation
    verdict: DeviceVerdict
    fact: str
    silent_for: float | None
    is_kept: bool
    is_offline: bool

    @property
    def is_fresh(self) -> bool:
        return self.silent_for is None and not self.is_kept and not self.is_offline


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
    reports = sorted(
        (
            report
            for device in _devices_of(thing, devices)
            if (report := _report(moment, device, wanted, devices)) is not None
        ),
        # A device of any name may speak on our own topics: it does not outvote one that was named.
        key=lambda report: (
            not report.is_fresh,
            report.sample.source not in devices,
            strength(report.fact),
            report.sample.source,
        ),
    )
    if not reports:
        is_past = question.at is not None
        why = _no_report(thing, question.state, wanted, devices, is_past)
        return _unknown(question, thing, why, None, ())
    best = reports[0]
    age = max(0.0, moment.at - best.sample.captured_at)
    who, sources = spoken_name(thing.name), (best.sample.source,)
    told_of = traits_of(devices, best.sample.source).thing
    if not (best.is_fresh and moment.known):
        return _unknown(question, thing, _silence(best, moment, len(reports)), age, sources)
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
    confidence = _DEVICE_CONFIDENCE if not others else 0.5 * (1.0 + _DEVICE_CONFIDENCE) - 0.15
    return StateAnswer(
        thing.id, thing.name, question.state, verdict, words, confidence, age, since, sources
    )


def person_state_answer(question: StateQuestion, who: PersonAnswer) -> StateAnswer:
    """Return whether somebody is in a state, by what the detectors say of them.

    Whoever lies on the floor without a fall that was seen may have fallen all the same.
    """
    state = _plain(question.state)
    sources = evidence_sources(who.evidence)
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
        who.age, who.since if verdict == "yes" else None, sources,
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


def _devices_of(thing: Thing, devices: Mapping[str, DeviceTraits]) -> tuple[str, ...]:
    own = tuple(device for device, traits in devices.items() if traits.thing == thing.id)
    return tuple(dict.fromkeys((thing.id, *own)))


def _report(
    moment: RoomMoment, device: str, wanted: DeviceProperty, devices: Mapping[str, DeviceTraits]
) -> _Report | None:
    """Return the last report of a device about itself; None when it tells nothing of a state."""
    if device not in {thing.id for thing in moment.world.things}:
        return None
    sample = next(
        (s for s in moment.world.latest_observations(device) if s.source == device and s.valid),
        None,
    )
    facts = dict(sample.facts) if sample is not None else {}
    fact = telling_fact(wanted, facts)
    if sample is None or not fact:
        return None
    traits = traits_of(devices, device)
    verdict = device_verdict(wanted, fact, facts, traits)
    age = moment.at - sample.captured_at
    is_silent = age > _MISSED_BEATS * heartbeat_of(fact, traits)
    kept = facts.get("retained") is True and sample.captured_at == sample.received_at
    gone = device in moment.offline
    return _Report(sample, verdict, fact, age if is_silent else None, kept, gone)


def _silence(report: _Report, moment: RoomMoment, count: int) -> str:
    """Return why the newest report is not believed."""
    its = "its sensor" if count == 1 else "every sensor of it"
    if report.is_kept:
        return (
            f"{its} was not heard yet; the broker kept that it {report.verdict.past} at some time"
        )
    ago = age_words(max(0.0, moment.at - report.sample.captured_at))
    if report.is_offline:
        return f"{its} says that it is offline; it {report.verdict.past}, {ago}"
    if report.silent_for is None:
        return f"nothing listens to it now; it {report.verdict.past}, {ago}"
    lasting = lasting_words(report.silent_for)
    listens = "" if moment.known else "; nothing listens to it now"
    return f"{its} has been silent{lasting}; then it {report.verdict.past}{listens}"


def _others(reports: list[_Report], holds: bool) -> str:
    """Return what other sensors say that says otherwise, "" when none does."""
    against = [
        f"{report.sample.source} says that it {report.verdict.clause}"
        for report in reports
        if report.is_fresh and report.verdict.holds not in (None, holds)
    ]
    return f"; but {' and '.join(against)}" if against else ""


_LASTING = {DeviceProperty.ON: APPLIANCE_ON, DeviceProperty.OPEN: CONTACT_OPEN}
"""Situations that tell since when a state holds."""


def _since(moment: RoomMoment, thing: str, wanted: DeviceProperty) -> float | None:
    held = (s for s in moment.situations if s.kind == _LASTING.get(wanted) and s.thing == thing)
    return next((s.since for s in held), None)


def _no_report(
    thing: Thing,
    state: str,
    wanted: DeviceProperty,
    devices: Mapping[str, DeviceTraits],
    is_past: bool,
) -> str:
    """Return why nobody ever told: no sensor that could, or none that spoke."""
    able = [
        device
        for device in _devices_of(thing, devices)
        if device in devices and tells(devices[device].kind, wanted)
    ]
    if able and is_past:
        return f"its sensor had not been heard by then ({', '.join(able)})"
    if able:
        return f"its sensor was never heard ({', '.join(able)}; housefly sensors says why)"
    return (
        f"no sensor tells whether {spoken_name(thing.name)} is {state};"
        " mqtt.sensors in the site file names one (docs/devices.md)"
    )


def _unknown(
    question: StateQuestion, thing: Thing, why: str, age: float | None, sources: tuple[str, ...]
) -> StateAnswer:
    return StateAnswer(
        thing.id, thing.name, question.state, "unknown", f"I do not know: {why}", 0.0, age, None,
        sources,
    )  # fmt: skip
