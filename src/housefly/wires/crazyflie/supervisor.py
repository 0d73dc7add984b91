"""Whether the drone may fly: supervisor (port 9), platform (13) and link (15), both ways.

The supervisor has a port of its own from protocol version 12 on (firmware 2026.04); before, arming
is the platform's, and the stop that of localization.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum, IntFlag

from housefly.errors import WireError
from housefly.wires.crazyflie.crtp import DATA_MAX, Packet, Port

SUPERVISOR_SINCE = 12
"""Protocol version from which the supervisor has a port of its own."""
SOURCE = b"Bitcraze Crazyflie"
INFO, COMMAND = 0, 1
_RESPONSE = 0x80
_PLATFORM_COMMAND, _PLATFORM_VERSION, _LINK_SOURCE = 0, 1, 1
_ARM_BY_PLATFORM, _RECOVER_BY_PLATFORM = 1, 2


class SupervisorInfo(IntFlag):
    """What the supervisor says of the drone, as in the log variable ``supervisor.info``."""

    CAN_BE_ARMED = 1 << 0
    IS_ARMED = 1 << 1
    ARMS_ITSELF = 1 << 2
    CAN_FLY = 1 << 3
    IS_FLYING = 1 << 4
    IS_TUMBLED = 1 << 5
    IS_LOCKED = 1 << 6
    IS_CRASHED = 1 << 7
    HIGH_LEVEL_ACTIVE = 1 << 8
    TRAJECTORY_FINISHED = 1 << 9
    HIGH_LEVEL_DISABLED = 1 << 10
    DECK_FAULT = 1 << 11


class SupervisorOrder(IntEnum):
    """What the supervisor can be told."""

    ARM = 1
    RECOVER = 2
    EMERGENCY_STOP = 3
    EMERGENCY_WATCHDOG = 4


INFO_BITFIELD = 0x0C
"""The question for all of ``SupervisorInfo``; 1 to 11 ask for one bit each."""


class VersionQuestion(IntEnum):
    """What the platform can be asked."""

    PROTOCOL = 0
    FIRMWARE = 1
    DEVICE = 2


@dataclass(frozen=True, slots=True)
class OrderAnswer:
    """The answer to ``ARM`` or ``RECOVER``.

    Attributes:
        order: which.
        is_done: whether it was obeyed.
        state: whether it is armed now, or no longer crashed.
    """

    order: SupervisorOrder
    is_done: bool
    state: bool


def encode_order(order: SupervisorOrder, on: bool = True) -> Packet:
    """Return an order; ``on`` counts for arming only."""
    data = bytes((order, on)) if order is SupervisorOrder.ARM else bytes((order,))
    return Packet(Port.SUPERVISOR, COMMAND, data)


def encode_arming_by_platform(on: bool) -> Packet:
    """Return the order to arm for firmware without the supervisor's port."""
    return Packet(Port.PLATFORM, _PLATFORM_COMMAND, bytes((_ARM_BY_PLATFORM, on)))


def encode_recovery_by_platform() -> Packet:
    """Return the order to recover for firmware without the supervisor's port."""
    return Packet(Port.PLATFORM, _PLATFORM_COMMAND, bytes((_RECOVER_BY_PLATFORM,)))


def decode_order(packet: Packet) -> tuple[SupervisorOrder, bool]:
    """Return an order, and whether to arm; raises WireError for none."""
    data = packet.data
    try:
        order = SupervisorOrder(data[0])
        return order, bool(data[1]) if order is SupervisorOrder.ARM else True
    except (IndexError, ValueError) as error:
        raise WireError(f"no order to the supervisor: {data.hex()}") from error


def encode_order_answer(answer: OrderAnswer) -> Packet:
    """Return the drone's answer."""
    data = bytes((_RESPONSE | answer.order, answer.is_done, answer.state))
    return Packet(Port.SUPERVISOR, COMMAND, data)


def encode_info(question: int, info: SupervisorInfo) -> Packet:
    """Return the drone's answer to a question for its state; raises WireError for none."""
    if question == INFO_BITFIELD:
        return Packet(
            Port.SUPERVISOR, INFO, bytes((_RESPONSE | question, *info.to_bytes(2, "little")))
        )
    if not 1 <= question < INFO_BITFIELD:
        raise WireError(f"no question to the supervisor: {question}; allowed: 1 to 12")
    is_set = info >> question - 1 & 1
    return Packet(Port.SUPERVISOR, INFO, bytes((_RESPONSE | question, is_set)))


def decode_info(packet: Packet) -> SupervisorInfo | OrderAnswer:
    """Read what the supervisor says; raises WireError for anything else."""
    data = packet.data
    if packet.channel == INFO and len(data) == 3 and data[0] == _RESPONSE | INFO_BITFIELD:
        return SupervisorInfo(int.from_bytes(data[1:], "little") & _KNOWN)
    if packet.channel == COMMAND and len(data) == 3 and data[0] & _RESPONSE:
        try:
            order = SupervisorOrder(data[0] & ~_RESPONSE)
        except ValueError as error:
            raise WireError(f"an answer to no order: {data.hex()}") from error
        return OrderAnswer(order, bool(data[1]), bool(data[2]))
    raise WireError(f"nothing that a supervisor says: channel {packet.channel}, {data.hex()}")


def info_of(number: int) -> SupervisorInfo:
    """Return the bits of ``supervisor.info``; those of later firmware are left out."""
    return SupervisorInfo(number & _KNOWN)


_KNOWN = sum(SupervisorInfo)


def source_question() -> Packet:
    """Return the question who is there."""
    return Packet(Port.LINK, _LINK_SOURCE, b"\x00")


def source_answer() -> Packet:
    """Return the drone's answer to it."""
    return Packet(Port.LINK, _LINK_SOURCE, SOURCE.ljust(DATA_MAX, b"\x00"))


def is_source(packet: Packet) -> bool:
    """Return whether a Crazyflie says so."""
    is_answer = packet.port == Port.LINK and packet.channel == _LINK_SOURCE
    return is_answer and packet.data.startswith(SOURCE)


def version_question(question: VersionQuestion) -> Packet:
    """Return a question for a version."""
    return Packet(Port.PLATFORM, _PLATFORM_VERSION, bytes((question,)))


def version_answer(question: VersionQuestion, version: int | str) -> Packet:
    """Return the drone's answer: a number for the protocol, else words."""
    told = bytes((version,)) if isinstance(version, int) else version.encode("ascii", "replace")
    return Packet(Port.PLATFORM, _PLATFORM_VERSION, bytes((question,)) + told[: DATA_MAX - 2])


def read_version(packet: Packet) -> tuple[VersionQuestion, int | str]:
    """Return which version is told, and what it is; raises WireError for anything else."""
    data = packet.data
    try:
        question = VersionQuestion(data[0])
        is_number = question is VersionQuestion.PROTOCOL
        told = data[1] if is_number else data[1:].split(b"\x00")[0].decode("ascii", "replace")
    except (IndexError, ValueError) as error:
        raise WireError(f"no version: {data.hex()}") from error
    return question, told
