"""What devices are called, and how their health is judged."""

from __future__ import annotations

import pytest

from housefly.messages import Observation
from housefly.sensors.device_monitor import DeviceMonitor, titled
from housefly.wires.devices import KINDS, Channel, DeviceAddress, Reading

GOOD = Reading((Observation("window", "window", 0.0, 0.0, facts=(("open", True),)),))
AJAR = Reading((Observation("window", "window", 0.0, 0.0, valid=False),), refused=("it is ajar",))


@pytest.fixture
def contact() -> DeviceMonitor:
    return DeviceMonitor(DeviceAddress("bsen", "contact", "window"), KINDS["contact"], 50.0)


@pytest.mark.parametrize(
    ("kind", "device", "title"),
    [
        ("Intelligent cabinet", "cabinet", "Intelligent cabinet"),
        ("Intelligent cabinet", "cabinet-2", "Intelligent cabinet cabinet-2"),
        ("Door contact", "entrance-door", "Door contact entrance-door"),
    ],
)
def test_a_title_says_no_word_twice_where_the_kind_says_it_all(
    kind: str, device: str, title: str
) -> None:
    assert titled(kind, device) == title


def test_a_refusal_stays_on_show_until_a_good_value_comes(contact: DeviceMonitor) -> None:
    contact.record_malformed("power is 'much'")
    for later in (1.0, 6.0, 600.0):
        assert contact.health(later, "").problem == "power is 'much'"
    contact.record(GOOD, 700.0, retained=False)
    health = contact.health(700.0, "")
    assert (health.problem, health.connected) == ("", True)


def test_well_does_not_outlive_the_last_value_that_was_understood(contact: DeviceMonitor) -> None:
    contact.record(GOOD, 0.0, retained=False)
    contact.record(AJAR, 1.0, retained=False)
    health = contact.health(1.0, "")
    assert (health.problem, health.connected, health.age) == ("it is ajar", False, 1.0)
    contact.record(Reading(online=True), 2.0, retained=False, channel=Channel.AVAILABILITY)
    assert not contact.health(2.0, "").connected


def test_what_else_comes_on_a_topic_is_no_problem_once_a_value_came(contact: DeviceMonitor) -> None:
    other = Reading(absent="contact is missing; there is battery")
    contact.record(other, 0.0, retained=False)
    assert contact.health(0.0, "").problem == "contact is missing; there is battery"
    contact.record(GOOD, 1.0, retained=False)
    contact.record(other, 2.0, retained=False)
    health = contact.health(2.0, "")
    assert (health.problem, health.connected) == ("", True)
    assert dict(health.counts)["without a value"] == 2
