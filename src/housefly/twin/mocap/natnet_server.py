"""The simulated tracking system as OptiTrack's Motive: a NatNet server, unicast or multicast.

Clients ask on the command port who serves and what is tracked. Unicast frames go to each client
that was heard recently; multicast frames go to the group. Facts: docs/wires.md, section 6. A body
that the cameras do not see stays in its frame with the tracking bit cleared.
"""

from __future__ import annotations

import asyncio
import socket
import time
from collections.abc import Callable
from dataclasses import dataclass

from housefly.errors import LinkError, WireError
from housefly.messages import Pose
from housefly.twin.address import PeerAddress
from housefly.twin.contracts import MocapFrame
from housefly.wires.axes import y_up_orientation, y_up_position
from housefly.wires.natnet import (
    CommandRequest,
    CommandResponse,
    Connect,
    Disconnect,
    Discovery,
    EchoRequest,
    EchoResponse,
    KeepAlive,
    ModelDef,
    NatNetFrame,
    NatNetMessage,
    NatNetVersion,
    RequestModelDef,
    RigidBody,
    RigidBodyDescription,
    ServerInfo,
    Unrecognized,
    decode_natnet,
    encode_natnet,
)

_CLOCK_HZ = 10_000_000
_VERSIONS: tuple[NatNetVersion, ...] = ((3, 0), (3, 1), (4, 0), (4, 1))
_CLIENT_TIMEOUT = 10.0
"""A unicast client that is silent for this long [s] gets no more frames."""
_MAX_CLIENTS = 32
_APPLICATION = "Housefly twin"


@dataclass(slots=True)
class _Client:
    version: NatNetVersion
    heard_at: float


class NatNetServer:
    """Serves frames to any number of clients; a slow client loses datagrams for itself alone.

    All calls belong to one asyncio loop.

    Args:
        address: where to listen; multicast leaves through this address too.
        port: UDP port of commands.
        data_port: UDP port that multicast frames are sent to.
        version: of the protocol; from 4.0 on a unicast client may choose another.
        group: multicast group; "" serves unicast.
        y_up: whether to stream with y up, as Motive does unless told otherwise.

    Attributes:
        lost: frames not sent because the network's buffers were full.
        malformed: datagrams that are not the protocol.
    """

    def __init__(
        self,
        address: str = "127.0.0.1",
        port: int = 1510,
        data_port: int = 1511,
        version: NatNetVersion = (3, 1),
        group: str = "",
        y_up: bool = True,
    ) -> None:
        self.lost = 0
        self.malformed = 0
        self._where = (address, port)
        self._target = (group, data_port)
        self._version = version
        self._y_up = y_up
        self._ticks = 0
        self._numbers: dict[str, int] = {}
        self._clients: dict[PeerAddress, _Client] = {}
        self._socket: socket.socket | None = None
        self._transport: asyncio.DatagramTransport | None = None

    @property
    def clients(self) -> int:
        """How many unicast clients were heard recently."""
        return len(self._clients)

    async def start(self) -> None:
        """Listen; raises LinkError when the address cannot be used."""
        try:
            self._socket = _socket_at(self._where)
        except OSError as error:
            raise LinkError(
                f"cannot serve NatNet at {self._where[0]}:{self._where[1]}:"
                f" {error.strerror or error}"
            ) from error
        loop = asyncio.get_running_loop()
        self._transport, _ = await loop.create_datagram_endpoint(
            lambda: _Receiver(self.receive), sock=self._socket
        )

    async def stop(self) -> None:
        """Close the port."""
        if self._transport is not None:
            self._transport.abort()
        self._transport = self._socket = None
        self._clients.clear()
        await asyncio.sleep(0)

    def publish(self, frame: MocapFrame) -> None:
        """Send a frame to the group or to every client; returns at once."""
        fresh = [name for name, _ in frame.bodies if name not in self._numbers]
        for name in fresh:
            self._numbers[name] = len(self._numbers) + 1
        item = natnet_frame(frame, self._numbers, self._y_up, changed=bool(fresh))
        self._ticks = item.sent
        if self._target[0]:
            self._send(encode_natnet(item, self._version), self._target)
            return
        self._drop_the_silent()
        packets: dict[NatNetVersion, bytes] = {}
        for address, client in self._clients.items():
            if client.version not in packets:
                packets[client.version] = encode_natnet(item, client.version)
            self._send(packets[client.version], address)

    def receive(self, datagram: bytes, sender: PeerAddress) -> None:
        """Answer one datagram of a client."""
        client = self._clients.get(sender)
        version = client.version if client is not None else self._version
        try:
            item = decode_natnet(datagram, version)
        except WireError:
            self.malformed += 1
            return
        if client is not None:
            client.heard_at = time.monotonic()
        answer = self._answer(item, sender)
        if answer is not None:
            self._send(encode_natnet(answer, version), sender)

    def _answer(self, item: NatNetMessage, sender: PeerAddress) -> NatNetMessage | None:
        match item:
            case Connect(wish):
                return self._info(self._admit(sender, wish))
            case Discovery():
                return self._info(self._version)
            case EchoRequest(client_time):
                return EchoResponse(client_time, self._ticks)
            case RequestModelDef():
                return ModelDef(
                    tuple(
                        RigidBodyDescription(number, name) for name, number in self._numbers.items()
                    )
                )
            case CommandRequest(command):
                return self._obey(command, sender)
            case Disconnect():
                self._clients.pop(sender, None)
                return None
            case KeepAlive():
                return None
            case _:
                return Unrecognized()

    def _admit(self, sender: PeerAddress, wish: NatNetVersion | None) -> NatNetVersion:
        """Register a unicast client and return the version that it gets."""
        if self._target[0] or (sender not in self._clients and len(self._clients) >= _MAX_CLIENTS):
            return self._version
        version = wish if wish in _VERSIONS and self._version >= (4, 0) else self._version
        self._clients[sender] = _Client(version, time.monotonic())
        return version

    def _obey(self, command: str, sender: PeerAddress) -> NatNetMessage:
        """Carry out a command in words; the only one is the choice of a version."""
        name, _, value = command.partition(",")
        if name.lower() != "bitstream":
            return Unrecognized()
        wish = next(
            (version for version in _VERSIONS if value.startswith(f"{version[0]}.{version[1]}")),
            None,
        )
        client = self._clients.get(sender)
        if wish is None or client is None or self._version < (4, 0):
            return CommandResponse(1)
        client.version = wish
        return CommandResponse(0)

    def _info(self, version: NatNetVersion) -> ServerInfo:
        group, data_port = self._target
        where = group or "0.0.0.0"
        return ServerInfo(
            _APPLICATION,
            (1, 0, 0, 0),
            (*version, 0, 0),
            _CLOCK_HZ,
            data_port,
            bool(group),
            where,
        )

    def _drop_the_silent(self) -> None:
        oldest = time.monotonic() - _CLIENT_TIMEOUT
        for address in [
            address for address, client in self._clients.items() if client.heard_at < oldest
        ]:
            del self._clients[address]

    def _send(self, datagram: bytes, target: PeerAddress) -> None:
        if self._socket is None:
            return
        try:
            self._socket.sendto(datagram, target)
        except OSError:
            self.lost += 1  # the network's buffers are full, or it is not there


class _Receiver(asyncio.DatagramProtocol):
    def __init__(self, on_datagram: Callable[[bytes, PeerAddress], None]) -> None:
        self._on_datagram = on_datagram

    def datagram_received(self, data: bytes, addr: PeerAddress) -> None:
        self._on_datagram(data, addr)


def _socket_at(where: PeerAddress) -> socket.socket:
    """Return a socket bound to an address; multicast leaves there with a hop limit of 1."""
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        made.setblocking(False)
        made.bind(where)
        made.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 1)
        made.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(where[0]))
    except OSError:
        made.close()
        raise
    return made


def natnet_frame(
    frame: MocapFrame, numbers: dict[str, int], y_up: bool, changed: bool = False
) -> NatNetFrame:
    """Return a frame in NatNet's form; ``numbers`` gives each body's number."""
    bodies = tuple(_body(numbers[name], pose, y_up) for name, pose in frame.bodies)
    exposed, sent = (max(0, round(at * _CLOCK_HZ)) for at in (frame.captured_at, frame.due_at))
    return NatNetFrame(
        frame.number & 0x7FFFFFFF,
        bodies,
        frame.captured_at,
        exposed,
        exposed,
        sent,
        changed=changed,
    )


def _body(number: int, pose: Pose | None, y_up: bool) -> RigidBody:
    if pose is None:
        return RigidBody(number, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0), tracked=False)
    if y_up:
        return RigidBody(number, y_up_position(pose.position), y_up_orientation(pose.orientation))
    return RigidBody(number, pose.position, pose.orientation)
