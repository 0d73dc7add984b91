"""A slow radio is given the newest setpoint and pose, and all else in order."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.drones.crazyflie.outbox import LIMIT, Outbox
from housefly.wires.crazyflie.crtp import Packet, Port
from housefly.wires.crazyflie.high_level import Land, encode_high_level
from housefly.wires.crazyflie.localization import encode_emergency_stop, encode_told_pose
from housefly.wires.crazyflie.setpoints import (
    AltHold,
    Place,
    Stop,
    encode_setpoint,
    notify_setpoints_stop,
)

UPRIGHT = 1.0, 0.0, 0.0, 0.0
LASTING = (
    encode_high_level(Land(0.0, 2.0)),
    notify_setpoints_stop(),
    encode_emergency_stop(),
    encode_setpoint(Stop()),
    Packet(Port.PARAMETERS, 2, b"\x01\x00\x02"),
)


def ageing(number: int) -> tuple[Packet, ...]:
    x = float(number)
    return (
        encode_setpoint(AltHold(0.0, 0.0, 0.0, x)),
        encode_setpoint(Place(x, 0.0, 1.0, 0.0)),
        encode_told_pose((x, 0.0, 1.0), UPRIGHT),
    )


def taken(outbox: Outbox) -> list[Packet]:
    packets = []
    while (packet := outbox.take(0.0)) is not None:
        packets.append(packet)
    return packets


packets = st.one_of(
    st.sampled_from(LASTING), st.integers(0, 9).map(ageing).flatmap(st.sampled_from)
)


@given(st.lists(packets, max_size=LIMIT))
def test_what_must_arrive_arrives_in_order_and_of_what_grows_old_only_the_newest(
    given_packets: list[Packet],
) -> None:
    outbox = Outbox()
    for packet in given_packets:
        outbox.put(packet)
    got = taken(outbox)
    assert [one for one in got if one in LASTING] == [o for o in given_packets if o in LASTING]
    assert outbox.dropped == 0
    setpoints = [one for one in given_packets if one not in LASTING and one.port == 7]
    poses = [one for one in given_packets if one not in LASTING and one.port == 6]
    assert [one for one in got if one not in LASTING and one.port == 7] == setpoints[-1:]
    assert [one for one in got if one not in LASTING and one.port == 6] == poses[-1:]
    if given_packets:
        assert got[-1] == given_packets[-1], "the newest overtakes nobody"


def test_a_setpoint_is_never_sent_before_the_landing_that_it_came_after() -> None:
    outbox = Outbox()
    older, newer = ageing(1)[0], ageing(2)[0]
    for packet in (older, *LASTING[:2], newer):
        outbox.put(packet)
    assert taken(outbox) == [*LASTING[:2], newer]


def test_a_radio_that_takes_nothing_costs_the_oldest_and_that_is_counted() -> None:
    outbox = Outbox()
    questions = [Packet(Port.LOG, 0, bytes((3, number))) for number in range(LIMIT + 5)]
    for packet in questions:
        outbox.put(packet)
    assert taken(outbox) == questions[5:] and outbox.dropped == 5
