"""The last reports of a thing's devices about a state, and why one is not believed or missing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from housefly.hub.device_states import (
    NO_VERDICT,
    DeviceProperty,
    DeviceVerdict,
    device_verdict,
    heartbeat_of,
    refused_property,
    strength,
    telling_fact,
    tells,
    weakest_fact,
)
from housefly.hub.person_status import RoomMoment, spoken_name
from housefly.hub.situations.device_traits import DeviceTraits, traits_of
from housefly.hub.situations.situation import is_undated
from housefly.hub.things.thing import Thing
from housefly.hub.things.words import age_words, lasting_words
from housefly.messages import Observation

_MISSED_BEATS = 2.0
"""After this many heartbeats without a word a device is silent."""


@dataclass(frozen=True, slots=True)
class LastReport:
    """The last report of one device about a state, and whether it may be believed still."""

    sample: Observation
    verdict: DeviceVerdict
    fact: str
    silent_for: float | None
    is_kept: bool
    is_offline: bool
    refused: str = ""
    """What the device says of the state that is not understood."""

    @property
    def is_fresh(self) -> bool:
        """Whether it was heard in time and understood, from a device that is there."""
        return (
            self.silent_for is None
            and not self.is_kept
            and not self.is_offline
            and not self.refused
        )


def reports_on(
    thing: Thing, wanted: DeviceProperty, moment: RoomMoment, devices: Mapping[str, DeviceTraits]
) -> tuple[LastReport, ...]:
    """Return what the devices of a thing last said of a state, the best word first."""
    found = (_report(moment, device, wanted, devices) for device in _devices_of(thing, devices))
    return tuple(
        sorted(
            (report for report in found if report is not None),
            # A device of any name may speak on our own topics: it does not outvote a named one.
            key=lambda report: (
                not report.is_fresh,
                report.sample.source not in devices,
                strength(report.fact),
                report.sample.source,
            ),
        )
    )


def why_not_believed(report: LastReport, moment: RoomMoment, count: int) -> str:
    """Return why the newest report is not believed."""
    its = "its sensor" if count == 1 else "every sensor of it"
    if report.refused:
        ago = age_words(max(0.0, moment.at - report.sample.captured_at))
        return f"{its} sent a state that is not understood, {ago}: {report.refused}"
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


def why_no_report(
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


def _devices_of(thing: Thing, devices: Mapping[str, DeviceTraits]) -> tuple[str, ...]:
    own = tuple(device for device, traits in devices.items() if traits.thing == thing.id)
    return tuple(dict.fromkeys((thing.id, *own)))


def _report(
    moment: RoomMoment, device: str, wanted: DeviceProperty, devices: Mapping[str, DeviceTraits]
) -> LastReport | None:
    """Return the last report of a device about itself; None when it tells nothing of a state."""
    if device not in {thing.id for thing in moment.world.things}:
        return None
    sample = next((s for s in moment.world.latest_observations(device) if s.source == device), None)
    facts = dict(sample.facts) if sample is not None else {}
    refused, fact = str(facts.get("refused", "")), telling_fact(wanted, facts)
    refused_key = str(facts.get("refused_key", ""))
    if sample is not None and not fact and refused_property(refused_key) is wanted:
        return LastReport(sample, NO_VERDICT, weakest_fact(wanted), None, False, False, refused)
    if sample is None or not sample.valid or not fact:
        return None
    traits = traits_of(devices, device)
    verdict = device_verdict(wanted, fact, facts, traits)
    age = moment.at - sample.captured_at
    is_silent = age > _MISSED_BEATS * heartbeat_of(fact, traits)
    gone = device in moment.offline
    return LastReport(sample, verdict, fact, age if is_silent else None, is_undated(sample), gone)
