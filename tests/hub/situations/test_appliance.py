"""What is on and what is open, by meter, switch and contact."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.hub.situations.appliance import Appliances
from housefly.hub.situations.device_traits import OFF_BELOW, ON_ABOVE, DeviceTraits
from housefly.hub.situations.kinds import SituationKind
from housefly.messages import Fact, Observation

STOVE = {"stove-plug": DeviceTraits("stove", "power", 50.0, 20.0, 60.0)}


def say(
    detector: Appliances, device: str, at: float, *facts: tuple[str, Fact]
) -> list[tuple[str, str, float]]:
    detector.add(Observation(device, device, at, at, facts=facts))
    return [(event.kind, event.thing, event.at) for event in detector.update(at)]


def test_a_stove_is_on_from_its_threshold_and_off_below_the_other() -> None:
    meter = Appliances(STOVE)
    assert say(meter, "stove-plug", 0.0, ("power", 30.0)) == []
    assert say(meter, "stove-plug", 1.0, ("power", 50.0)) == [
        (SituationKind.APPLIANCE_ON, "stove", 1.0)
    ]
    assert say(meter, "stove-plug", 2.0, ("power", 20.0)) == []
    assert [(s.kind, s.thing) for s in meter.active()] == [(SituationKind.APPLIANCE_ON, "stove")]
    assert say(meter, "stove-plug", 3.0, ("power", 19.9)) == [("appliance on ended", "stove", 3.0)]


@given(st.lists(st.floats(OFF_BELOW, ON_ABOVE - 0.001), min_size=1, max_size=20))
def test_noise_between_the_thresholds_switches_nothing(powers: list[float]) -> None:
    meter = Appliances({})
    say(meter, "lamp", 0.0, ("power", 60.0))
    assert [say(meter, "lamp", 1.0 + n, ("power", p)) for n, p in enumerate(powers)] == [
        [] for _ in powers
    ]


def test_a_switch_that_is_on_while_its_stove_draws_nothing_says_nothing() -> None:
    detector = Appliances(STOVE | {"stove-switch": DeviceTraits("stove", "switch")})
    say(detector, "stove-plug", 0.0, ("power", 0.4))
    assert say(detector, "stove-switch", 1.0, ("on", True)) == []
    assert say(detector, "lamp", 1.0, ("on", True)) == [(SituationKind.APPLIANCE_ON, "lamp", 1.0)]


def test_a_meter_that_falls_silent_ends_what_it_said_without_saying_the_contrary() -> None:
    meter = Appliances(STOVE)
    say(meter, "stove-plug", 0.0, ("power", 1420.0))
    assert meter.update(119.0) == ()
    (ended,) = meter.update(300.0)
    assert ended.kind == "appliance on ended"
    assert dict(ended.facts)["because"] == "not known any more"
    assert ended.confidence == pytest.approx(0.5)


def test_a_contact_that_says_what_is_not_understood_is_open_no_longer() -> None:
    detector, contact = Appliances({}), ("kind", "contact")
    say(detector, "window", 0.0, ("open", True), contact)
    refused = (("refused", "contact is 'ajar'"),)
    detector.add(Observation("window", "window", 1.0, 1.0, valid=False, facts=refused))
    (ended,) = detector.update(1.0)
    assert ended.kind == SituationKind.CONTACT_OPEN.ended
    assert dict(ended.facts)["because"] == "not known any more"
    assert say(detector, "window", 2.0, ("open", True), contact) == [
        (SituationKind.CONTACT_OPEN, "window", 2.0)
    ]


def test_a_contact_opens_and_closes_and_a_door_is_left_to_who_knows_doors() -> None:
    detector = Appliances({})
    contact = ("kind", "contact")
    assert say(detector, "window", 0.0, ("open", False), contact) == []
    assert say(detector, "window", 1.0, ("open", True), contact) == [
        (SituationKind.CONTACT_OPEN, "window", 1.0)
    ]
    assert say(detector, "entrance-door", 1.0, ("open", True)) == []
    assert detector.update(1.0) == ()


def test_what_a_device_says_of_others_and_what_is_not_valid_counts_for_nothing() -> None:
    detector = Appliances({})
    detector.add(Observation("cup", "lamp", 0.0, 0.0, facts=(("power", 60.0),)))
    detector.add(Observation("lamp", "lamp", 0.0, 0.0, valid=False, facts=(("power", 60.0),)))
    detector.add(Observation("lamp", "lamp", 0.0, 0.0, facts=(("power", "60"),)))
    assert detector.update(0.0) == ()


def test_what_the_broker_kept_from_no_known_time_switches_nothing() -> None:
    detector = Appliances({})
    kept = (("power", 60.0), ("retained", True))
    detector.add(Observation("lamp", "lamp", 5.0, 5.0, facts=kept))
    assert detector.update(5.0) == ()
    detector.add(Observation("lamp", "lamp", 4.0, 5.0, facts=kept))  # with a time of its own
    assert [event.kind for event in detector.update(5.0)] == [SituationKind.APPLIANCE_ON]
