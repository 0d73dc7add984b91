"""The drone's UDP links with faults on them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.twin.contracts import EncodedPicture
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.packet_stream import PacketCodec, PacketStream, noise_bytes
from housefly.twin.faults.vocabulary import FaultComponent
from housefly.twin.link_filters import Deliver, LinkFilters
from housefly.wires.ardrone.at import encode_datagram, parse_datagram

_COMMANDS = PacketCodec(noise_bytes, lambda old, new: _renumbered(old, new))
_REPORTS: PacketCodec[bytes] = PacketCodec(noise_bytes, lambda old, new: new)
"""Reports that stand still are written anew, with old content."""


def faulty_links(faults: FaultInjector, now: Callable[[], float]) -> LinkFilters:
    """Return what stands between client and drone; use it within one asyncio loop.

    Args:
        faults: of commands and telemetry.
        now: world time [s].
    """
    uplink = PacketStream(FaultComponent.COMMANDS, _COMMANDS)
    downlink = PacketStream(FaultComponent.TELEMETRY, _REPORTS)
    return LinkFilters(
        uplink=lambda deliver: _sender(uplink, faults, now, deliver),
        downlink=lambda deliver: _sender(downlink, faults, now, deliver),
        reported=faults.reported,
    )


def faulty_pictures(
    faults: FaultInjector, now: Callable[[], float], publish: Callable[[EncodedPicture], None]
) -> Callable[[EncodedPicture], None]:
    """Return what takes the drone's pictures in place of what publishes them."""

    def pass_on(picture: EncodedPicture) -> None:
        for sent in faults.pictures(picture, now()):
            publish(sent)

    return pass_on


def _sender(
    stream: PacketStream[bytes],
    faults: FaultInjector,
    now: Callable[[], float],
    deliver: Deliver,
) -> Deliver:
    def send(datagram: bytes) -> None:
        moment = now()
        for due, packet in stream.sent(datagram, faults.schedule, moment):
            if due <= moment:
                deliver(packet)
            else:
                asyncio.get_running_loop().call_later(due - moment, deliver, packet)

    return send


def _renumbered(old: bytes, new: bytes) -> bytes:
    """Return the commands of an old datagram with the numbers of a new one.

    A wire whose drone asks for no new numbers has its old datagram again, as it was.
    """
    commands = [command for _, command in parse_datagram(old).commands]
    numbers = [sequence for sequence, _ in parse_datagram(new).commands]
    return encode_datagram(numbers[0], commands) if numbers else old
