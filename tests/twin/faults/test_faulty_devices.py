"""Devices whose messages are lost or damaged."""

from __future__ import annotations

import pytest

from housefly.config.site import Site, changed
from housefly.twin.faults.faulty_devices import FaultyDevices
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import Injection
from housefly.twin.people import load_scene
from housefly.twin.sensors.devices import DeviceMessage, SimulatedDevices


def sent(*faults: str) -> list[DeviceMessage]:
    site = changed(Site(), faults=[{"fault": fault} for fault in faults])
    devices = FaultyDevices(load_scene("bsen"), "lab", FaultInjector(site, Injection.WIRES))
    return [message for n in range(200) for message in devices.messages(0.1 * n)]


def test_devices_are_true_but_for_their_faults() -> None:
    true = SimulatedDevices(load_scene("bsen"), "lab")
    messages = [message for n in range(200) for message in true.messages(0.1 * n)]
    assert sent() == messages
    assert sent("devices:off") == []
    assert len(sent("devices:intermittent=0.3")) == pytest.approx(0.7 * len(messages), rel=0.15)
    noise = sent("devices:garbage")
    assert [message.address for message in noise] == [message.address for message in messages]
    assert all(a.payload != b.payload for a, b in zip(noise, messages, strict=True))
