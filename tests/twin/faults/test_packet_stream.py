"""Links that lose, delay, repeat and reorder."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.twin.faults.fault import FaultSchedule
from housefly.twin.faults.packet_stream import PacketCodec, PacketStream, noise_bytes
from housefly.twin.faults.parse import parse_fault
from housefly.twin.faults.vocabulary import FaultComponent

CODEC: PacketCodec[bytes] = PacketCodec(noise_bytes, lambda old, new: new[:1] + old[1:])
PERIOD = 0.03


def arrivals(*faults: str, packets: int = 200) -> list[tuple[float, float, bytes]]:
    """Return sending time, arrival and packet of each that arrives, in order of sending."""
    stream = PacketStream(FaultComponent.COMMANDS, CODEC)
    schedule = FaultSchedule(tuple(one for text in faults for one in parse_fault(text)))
    return [
        (n * PERIOD, due, packet)
        for n in range(packets)
        for due, packet in stream.sent(f"{n:4d}".encode(), schedule, n * PERIOD)
    ]


def numbers(found: list[tuple[float, float, bytes]]) -> list[int]:
    return [int(packet) for _, _, packet in found]


def test_without_faults_every_packet_arrives_at_once() -> None:
    found = arrivals("telemetry:off")
    assert numbers(found) == list(range(200))
    assert all(sent == due for sent, due, _ in found)


def test_off_loses_all_and_intermittent_a_share() -> None:
    assert numbers(arrivals("commands:off@3s+1.5s")) == [*range(100), *range(150, 200)]
    assert len(arrivals("commands:intermittent=0.3")) == pytest.approx(140, abs=25)


def test_slow_lets_one_of_each_slot_pass() -> None:
    assert len(arrivals("commands:slow=5")) == 30


@given(st.floats(0.1, 2.0))
def test_delayed_packets_arrive_late_and_in_order(delay: float) -> None:
    found = arrivals(f"commands:delayed@1s+2s={delay}")
    assert numbers(found) == list(range(200))
    assert [due for _, due, _ in found] == sorted(due for _, due, _ in found)
    assert all(due == pytest.approx(sent + delay) for sent, due, _ in found if 1.0 <= sent < 3.0)
    assert all(due >= sent for sent, due, _ in found)


def test_overtaken_packets_come_after_the_next_and_none_is_lost() -> None:
    found = numbers(arrivals("commands.order:wrong=0.3"))
    assert found != sorted(found)
    assert len(set(found)) == len(found) >= 199
    assert all(abs(place - number) <= 1 for place, number in enumerate(found))


def test_copies_come_twice() -> None:
    found = numbers(arrivals("commands.copies:wrong=0.3"))
    assert sorted(set(found)) == list(range(200))
    assert len(found) == pytest.approx(260, abs=25)


def test_stuck_repeats_the_last_content_under_new_numbers() -> None:
    stream = PacketStream(FaultComponent.COMMANDS, CODEC)
    schedule = FaultSchedule(parse_fault("commands:stuck@1s"))
    assert stream.sent(b"1fly", schedule, 0.5) == ((0.5, b"1fly"),)
    assert stream.sent(b"2stop", schedule, 1.5) == ((1.5, b"2fly"),)
    assert stream.sent(b"3stop", schedule, 2.5) == ((2.5, b"3fly"),)


def test_garbage_is_noise_of_the_same_length_and_the_same_again() -> None:
    first, again = arrivals("commands:garbage#4"), arrivals("commands:garbage#4")
    assert first == again != arrivals("commands:garbage#5")
    assert {len(packet) for _, _, packet in first} == {4}
    assert len({packet for _, _, packet in first}) > 190


@given(st.integers(1, 10**6), st.floats(0.0, 1.0))
def test_the_same_seed_loses_the_same_packets(seed: int, share: float) -> None:
    fault = f"commands:intermittent={share}#{seed}"
    assert arrivals(fault, packets=60) == arrivals(fault, packets=60)
