"""The simulated tracking system as a VRPN server: each body is a tracker with one sensor.

A client connects by TCP, or asks by datagram to be called back. Both sides send a cookie; then the
server sends descriptions of its names, and poses. Facts: docs/wires.md, section 7. A body that the
cameras do not see is left out.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.errors import LinkError, WireError
from housefly.twin.address import PeerAddress
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.stream_client import StreamClient
from housefly.wires.axes import y_up_orientation, y_up_position
from housefly.wires.vrpn import (
    COOKIE_SIZE,
    MAJOR_VERSION,
    PING_TYPE,
    PONG_TYPE,
    POSE_TYPE,
    SENDER_DESCRIPTION,
    TYPE_DESCRIPTION,
    TrackerPose,
    VrpnMessage,
    VrpnNames,
    VrpnStream,
    decode_cookie,
    decode_lob,
    description_message,
    encode_cookie,
    encode_message,
    encode_pose,
)

_MESSAGE_TYPES = (POSE_TYPE, PING_TYPE, PONG_TYPE)
"""Message types of this server; the index is the number."""
_MAX_CLIENTS = 32
_CONNECT_TIMEOUT = 2.0
"""How long [s] a connection back to a client, and a cookie, may take."""
_CHUNK = 64 * 1024


class VrpnServer:
    """Serves poses to any number of clients; a slow client never delays the others.

    All calls belong to one asyncio loop.

    Args:
        address: where to listen.
        port: TCP and UDP port.
        y_up: whether to serve with y up.

    Attributes:
        lost: frames not sent, summed over clients that were too slow.
        malformed: connections closed, and datagrams dropped, because they are not the protocol.
    """

    def __init__(self, address: str = "127.0.0.1", port: int = 3883, y_up: bool = False) -> None:
        self.lost = 0
        self.malformed = 0
        self._where = (address, port)
        self._y_up = y_up
        self._numbers: dict[str, int] = {}
        self._links: set[StreamClient] = set()
        self._clients: set[StreamClient] = set()
        self._calls: dict[PeerAddress, asyncio.Task[None]] = {}
        self._server: asyncio.Server | None = None
        self._receiver: asyncio.DatagramTransport | None = None

    @property
    def clients(self) -> int:
        """How many clients are connected and have shown their cookie."""
        return len(self._clients)

    async def start(self) -> None:
        """Listen; raises LinkError when the address cannot be used."""
        loop = asyncio.get_running_loop()
        try:
            self._server = await asyncio.start_server(self._serve, *self._where)
            self._receiver, _ = await loop.create_datagram_endpoint(
                lambda: _Receiver(self._call_back), local_addr=self._where
            )
        except OSError as error:
            await self.stop()
            raise LinkError(
                f"cannot serve VRPN at {self._where[0]}:{self._where[1]}: {error.strerror or error}"
            ) from error

    async def stop(self) -> None:
        """Close the ports and every connection."""
        if self._receiver is not None:
            self._receiver.abort()
        if self._server is not None:
            self._server.close()
        for call in tuple(self._calls.values()):
            call.cancel()
        for client in tuple(self._links):
            client.close()
        while self._links or self._calls:
            # Each connection's task ends by itself; a loop that closes first would complain.
            await asyncio.sleep(0)
        if self._server is not None:
            await self._server.wait_closed()
        self._server = self._receiver = None

    def publish(self, frame: MocapFrame) -> None:
        """Hand a frame to every client; returns at once."""
        for name, _ in frame.bodies:
            if name not in self._numbers:
                self._numbers[name] = len(self._numbers)
                self._broadcast(
                    encode_message(
                        description_message(SENDER_DESCRIPTION, self._numbers[name], name)
                    )
                )
        packet = b"".join(
            encode_message(message) for message in _frame_messages(frame, self._numbers, self._y_up)
        )
        if packet:
            self._broadcast(packet)

    def _broadcast(self, packet: bytes) -> None:
        for client in self._clients:
            self.lost += not client.offer(packet)

    def _call_back(self, datagram: bytes, sender: PeerAddress) -> None:
        """Connect to a client that asked for it, always at the address that it asked from."""
        try:
            _, port = decode_lob(datagram)
        except WireError:
            self.malformed += 1
            return
        target = sender[0], port
        if (
            target not in self._calls
            and len(self._links) < _MAX_CLIENTS
            and len(self._calls) < _MAX_CLIENTS
        ):
            self._calls[target] = asyncio.create_task(self._call(target))

    async def _call(self, target: PeerAddress) -> None:
        try:
            async with asyncio.timeout(_CONNECT_TIMEOUT):
                reader, writer = await asyncio.open_connection(*target)
            await self._serve(reader, writer)
        except OSError:
            pass  # a client that is gone again
        finally:
            self._calls.pop(target, None)

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        client = StreamClient(writer)
        if len(self._links) >= _MAX_CLIENTS:
            client.close()
            return
        self._links.add(client)
        try:
            client.offer(encode_cookie())
            async with asyncio.timeout(_CONNECT_TIMEOUT):
                _check(await reader.readexactly(COOKIE_SIZE))
            self._introduce(client)
            self._clients.add(client)
            await self._answer(client, reader)
        except WireError:
            self.malformed += 1
        except (asyncio.IncompleteReadError, OSError):
            pass
        finally:
            self._links.discard(client)
            self._clients.discard(client)
            client.close()

    def _introduce(self, client: StreamClient) -> None:
        for number, name in enumerate(_MESSAGE_TYPES):
            client.offer(encode_message(description_message(TYPE_DESCRIPTION, number, name)))
        for name, number in self._numbers.items():
            client.offer(encode_message(description_message(SENDER_DESCRIPTION, number, name)))

    async def _answer(self, client: StreamClient, reader: asyncio.StreamReader) -> None:
        """Answer pings until the client leaves; all else that clients say is of no concern."""
        stream, names = VrpnStream(), VrpnNames()
        while piece := await reader.read(_CHUNK):
            for message in stream.feed(piece):
                if (
                    not names.learn(message)
                    and names.kind(message) == PING_TYPE
                    and names.sender(message) in self._numbers
                ):
                    number = self._numbers[names.sender(message)]
                    client.offer(
                        encode_message(
                            VrpnMessage(_MESSAGE_TYPES.index(PONG_TYPE), number, message.stamp, b"")
                        )
                    )


class _Receiver(asyncio.DatagramProtocol):
    def __init__(self, on_datagram: Callable[[bytes, PeerAddress], None]) -> None:
        self._on_datagram = on_datagram

    def datagram_received(self, data: bytes, addr: PeerAddress) -> None:
        self._on_datagram(data, addr)


def _check(cookie: bytes) -> None:
    version = decode_cookie(cookie)
    if not version.startswith(MAJOR_VERSION):
        raise WireError(f"VRPN cookie: version {version}; allowed: {MAJOR_VERSION}")


def _frame_messages(frame: MocapFrame, numbers: dict[str, int], y_up: bool) -> list[VrpnMessage]:
    """Return the pose messages of a frame's seen bodies, stamped with the time of exposure."""
    stamp = max(0, round(frame.captured_at * 1e6))
    kind = _MESSAGE_TYPES.index(POSE_TYPE)
    messages = []
    for name, pose in frame.bodies:
        if pose is not None:
            position = y_up_position(pose.position) if y_up else pose.position
            orientation = y_up_orientation(pose.orientation) if y_up else pose.orientation
            messages.append(
                VrpnMessage(
                    kind, numbers[name], stamp, encode_pose(TrackerPose(0, position, orientation))
                )
            )
    return messages
