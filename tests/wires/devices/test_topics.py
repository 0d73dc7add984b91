"""Topics of devices: a scheme that reads back, and refuses everything else."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.devices import (
    Channel,
    DeviceAddress,
    listener_topic,
    parse_topic,
    site_subscription,
)

ids = st.from_regex(r"[A-Za-z0-9][A-Za-z0-9_.:-]{0,63}", fullmatch=True)
sites = st.from_regex(r"[a-z0-9][a-z0-9_-]{0,39}", fullmatch=True)


@given(sites, ids, ids, st.sampled_from(Channel))
def test_a_topic_reads_back(site: str, kind: str, device: str, channel: Channel) -> None:
    address = DeviceAddress(site, kind, device)
    assert parse_topic(address.topic(channel)) == (address, channel)
    assert address.topic(channel).startswith(site_subscription(site)[:-1])


@given(st.text(max_size=200))
def test_any_other_text_is_refused_in_a_line(topic: str) -> None:
    try:
        address, channel = parse_topic(topic)
    except WireError as error:
        assert str(error).isprintable() and len(str(error)) < 250
    else:
        assert address.topic(channel) == topic


@pytest.mark.parametrize(
    "topic",
    ["housefly/bsen/door/d/status", "housefly/bsen/door/state", "housefly/B sen/door/d/state"],
)
def test_a_typing_mistake_is_told_the_scheme(topic: str) -> None:
    with pytest.raises(WireError, match="state"):
        parse_topic(topic)


def test_the_listeners_own_topic_is_no_devices() -> None:
    with pytest.raises(WireError):
        parse_topic(listener_topic("bsen"))
