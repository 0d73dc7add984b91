"""Devices whose messages are lost or damaged."""

from __future__ import annotations

import json
from typing import Any

import pytest

from housefly.config.site import Site, changed
from housefly.twin.faults.faulty_devices import FaultyDevices
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.people import load_scene
from housefly.twin.sensors.devices import DeviceMessage, SimulatedDevices
from housefly.wires.devices import Channel, Delivered, decode_reading

START = 1.7e9
"""When the scene begins [s, Unix time]."""
LONG = 900
"""Tenths of a second in which the scene's door opens."""


Told = tuple[float, DeviceMessage]


def told(*faults: str, count: int = 200) -> list[Told]:
    """Return what arrives in a scene, and when [s]."""
    site = changed(Site(), faults=[{"fault": fault} for fault in faults])
    devices = FaultyDevices(load_scene("bsen"), "lab", FaultInjector(site, Injection.WIRES))
    return [
        (0.1 * n, message)
        for n in range(count)
        for message in devices.messages(0.1 * n, START + 0.1 * n)
    ]


def sent(*faults: str, count: int = 200) -> list[DeviceMessage]:
    return [message for _, message in told(*faults, count=count)]


def values(message: DeviceMessage) -> dict[str, Any]:
    found = json.loads(message.payload)
    assert isinstance(found, dict)
    return found


def of_kind(kind: str, messages: list[DeviceMessage]) -> list[dict[str, Any]]:
    return [values(m) for m in messages if m.address.kind == kind and m.channel is Channel.STATE]


def test_devices_are_true_but_for_their_faults() -> None:
    true = SimulatedDevices(load_scene("bsen"), "lab")
    messages = [message for n in range(200) for message in true.messages(0.1 * n, START + 0.1 * n)]
    assert sent() == messages
    assert sent("devices:off") == []
    assert len(sent("devices:intermittent=0.3")) == pytest.approx(0.7 * len(messages), rel=0.15)
    noise = sent("devices:garbage")
    assert [message.address for message in noise] == [message.address for message in messages]
    assert all(a.payload != b.payload for a, b in zip(noise, messages, strict=True))


def test_devices_that_stand_still_say_what_was_under_fresh_stamps_and_have_no_news() -> None:
    true, stuck = sent(count=LONG), sent("devices:stuck@5s", count=LONG)
    assert any(message.channel is Channel.EVENT for message in true)
    assert not any(message.channel is Channel.EVENT for message in stuck)
    last: dict[object, dict[str, Any]] = {}
    for at, message in told("devices:stuck@5s", count=LONG):
        now = values(message)
        assert now.pop("time") == pytest.approx(START + at)
        assert at < 5.0 or message.address not in last or now == last[message.address]
        last[message.address] = now
    moved = {str(row["people"]) for row in of_kind("floor", stuck)}
    assert len(moved) < len({str(row["people"]) for row in of_kind("floor", true)}) / 5


def test_what_is_measured_is_so_many_times_as_much_and_nothing_else_changes() -> None:
    for true, wrong in zip(sent(), sent("devices:wrong=2"), strict=True):
        assert wrong.address == true.address
        was, told_now = values(true), values(wrong)
        assert told_now.keys() == was.keys() and told_now["time"] == was["time"]
        for before, after in zip(was.get("people", ()), told_now.get("people", ()), strict=True):
            assert (after["x"], after["y"]) == pytest.approx((2 * before["x"], 2 * before["y"]))
            assert (after["weight"], after["extent"]) == (2 * before["weight"], before["extent"])
    (load, *_), (twice, *_) = of_kind("bed", sent()), of_kind("bed", sent("devices:wrong=2"))
    assert twice["load"] == pytest.approx(2 * load["load"])


def test_a_state_can_be_told_the_other_way_round() -> None:
    true, wrong = sent(count=LONG), sent("devices.state:wrong", count=LONG)
    for kind, key in (("door", "open"), ("motion", "motion"), ("cabinet", "open")):
        was = [row[key] for row in of_kind(kind, true)]
        assert was and [row[key] for row in of_kind(kind, wrong)] == [not value for value in was]


def test_slow_devices_send_fewer_messages_each() -> None:
    def floors(messages: list[Told]) -> int:
        return sum(message.address.kind == "floor" for _, message in messages)

    slow, true = told("devices:slow=0.5"), told()
    assert floors(true) == 200 * len({m.address for _, m in true if m.address.kind == "floor"})
    assert floors(slow) == floors(true) / 20
    assert {m.address for _, m in slow} == {m.address for _, m in true}


def test_late_messages_have_true_stamps_and_come_in_order() -> None:
    late, true = told("devices:delayed@3s=2"), sent()
    arrived = [message for _, message in late]
    assert arrived == true[: len(arrived)]
    waited = [at + START - values(message)["time"] for at, message in late]
    assert waited[0] == pytest.approx(0.0, abs=1e-3)
    assert all(
        wait == pytest.approx(2.0, abs=0.101)
        for (at, _), wait in zip(late, waited, strict=True)
        if at > 5.0
    )


@pytest.mark.parametrize(
    "fault",
    ["stuck@3s", "wrong=1.5", "delayed=1", "slow=1"],
)
def test_what_a_faulty_device_says_can_be_read_by_the_real_reader(fault: str) -> None:
    for at, message in told(f"devices:{fault}"):
        delivered = Delivered(message.address, message.channel, message.payload, START + at)
        assert decode_reading(delivered).unknown == ()


def test_a_device_that_lies_in_noise_is_noise() -> None:
    faults = ("devices:garbage", "devices:wrong=2", "devices:stuck")
    assert sent(*faults) == sent(*faults)
