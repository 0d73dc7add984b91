"""The simulated tracking system on its real wire: a Vicon DataStream server.

The server speaks first (the kinds it offers), clients answer with the kinds they want and ask for
frames, all of them or the next few. Facts: docs/wires.md, section 5. Positions are in millimetres,
rotations are row-major matrices; a body that the cameras do not see is left out of its frame.
"""

from __future__ import annotations

import asyncio
from collections import Counter

from housefly.errors import LinkError, WireError
from housefly.messages import Pose
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.stream_client import StreamClient
from housefly.wires.vicon import (
    TICKS_PER_SECOND,
    VICON_HEADER_SIZE,
    ApplicationInfo,
    FrameContents,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    ObjectEnums,
    RequestFrame,
    RequestNextFrame,
    Segment,
    SegmentPose,
    StreamInfo,
    SubjectInfo,
    ViconObject,
    ViconPing,
    decode_packet,
    encode_packet,
    matrix_from_quaternion,
    packet_length,
)

_OFFERED_KINDS = frozenset(
    item.KIND
    for item in (
        StreamInfo,
        SubjectInfo,
        FrameInfo,
        GlobalSegments,
        LatencyInfo,
        ApplicationInfo,
        ViconPing,
        FrameContents,
    )
)
_LARGEST_REQUEST = 64 * 1024
_MAX_CLIENTS = 32


class ViconServer:
    """Serves frames to any number of clients; a slow client never delays the others.

    All calls belong to one asyncio loop.

    Attributes:
        lost: frames not sent, summed over clients that were too slow.
        malformed: connections closed because of bytes that are not the protocol.
    """

    def __init__(
        self, address: str = "127.0.0.1", port: int = 8010, rate_hz: float = 100.0
    ) -> None:
        self.lost = 0
        self.malformed = 0
        self._address = address
        self._port = port
        self._period_ticks = round(TICKS_PER_SECOND / rate_hz)
        self._clients: set[_Client] = set()
        self._latest: MocapFrame | None = None
        self._server: asyncio.Server | None = None

    @property
    def clients(self) -> int:
        """How many clients are connected."""
        return len(self._clients)

    async def start(self) -> None:
        """Listen; raises LinkError when the address cannot be used."""
        try:
            self._server = await asyncio.start_server(self._serve, self._address, self._port)
        except OSError as error:
            raise LinkError(
                f"cannot serve Vicon DataStream at {self._address}:{self._port}:"
                f" {error.strerror or error}"
            ) from error

    async def stop(self) -> None:
        """Close the port and every connection."""
        if self._server is None:
            return
        self._server.close()
        for client in tuple(self._clients):
            client.close()
        while self._clients:
            # Each connection's task ends by itself; a loop that closes first would complain.
            await asyncio.sleep(0)
        await self._server.wait_closed()
        self._server = None

    def publish(self, frame: MocapFrame) -> None:
        """Hand a frame to every client that waits for one; returns at once."""
        self._latest = frame
        packets: dict[frozenset[int], bytes] = {}
        for client in self._clients:
            if not client.wants_frame():
                continue
            if client.kinds not in packets:
                packets[client.kinds] = self._encode(frame, client.kinds)
            self.lost += not client.offer(packets[client.kinds])

    def _encode(self, frame: MocapFrame, kinds: frozenset[int]) -> bytes:
        return encode_packet(_frame_items(frame, self._period_ticks, kinds))

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        client = _Client(writer)
        if len(self._clients) >= _MAX_CLIENTS:
            client.close()
            return
        self._clients.add(client)
        try:
            client.offer(encode_packet([ObjectEnums(_OFFERED_KINDS)]))
            while True:
                length = packet_length(
                    await reader.readexactly(VICON_HEADER_SIZE), _LARGEST_REQUEST
                )
                for item in decode_packet(await reader.readexactly(length)):
                    self._answer(client, item)
        except WireError:
            self.malformed += 1
        except (asyncio.IncompleteReadError, OSError):
            pass
        finally:
            self._clients.discard(client)
            client.close()

    def _answer(self, client: _Client, item: ViconObject) -> None:
        match item:
            case ObjectEnums(kinds):
                client.kinds = kinds & _OFFERED_KINDS
            case ViconPing():
                client.offer(encode_packet([item]))
            case RequestNextFrame(number):
                client.expected = number
            case RequestFrame(streaming):
                client.streaming = streaming
                if not streaming and self._latest is not None:
                    client.offer(self._encode(self._latest, client.kinds))


class _Client(StreamClient):
    """One connection and what it asked for."""

    def __init__(self, writer: asyncio.StreamWriter) -> None:
        super().__init__(writer)
        self.kinds = _OFFERED_KINDS
        self.streaming = False
        self.expected = 0

    def wants_frame(self) -> bool:
        """Return whether the next frame is for this client, and count it off."""
        if self.streaming:
            return True
        self.expected, wanted = max(0, self.expected - 1), self.expected > 0
        return wanted


def _frame_items(frame: MocapFrame, period_ticks: int, kinds: frozenset[int]) -> list[ViconObject]:
    """Return one frame's objects of the wanted kinds in a server's order, contents first."""
    named = list(enumerate(frame.bodies, start=1))
    objects: list[ViconObject] = [StreamInfo(period_ticks), ApplicationInfo()]
    objects += [SubjectInfo(number, name, (Segment(1, name),)) for number, (name, _) in named]
    objects += [FrameInfo(frame.number & 0xFFFFFFFF)]
    objects += [LatencyInfo((("Exposure to sending", max(0.0, frame.due_at - frame.captured_at)),))]
    objects += [
        GlobalSegments(number, (_segment(pose),)) for number, (_, pose) in named if pose is not None
    ]
    wanted = [item for item in objects if item.KIND in kinds]
    if FrameContents.KIND in kinds:
        wanted.insert(
            0, FrameContents(tuple(sorted(Counter(item.KIND for item in wanted).items())))
        )
    return wanted


def _segment(pose: Pose) -> SegmentPose:
    x, y, z = pose.position
    return SegmentPose(
        1, (1000.0 * x, 1000.0 * y, 1000.0 * z), matrix_from_quaternion(pose.orientation)
    )
