"""What pilot and driver tell each other over their socket: bytes and back.

A command carries the time at which the pilot gave it: what comes late counts for nothing
(``failsafe``).
"""

from __future__ import annotations

import json
import struct
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from math import isfinite

from housefly.bus.private_socket import FrameCutter, framed
from housefly.config.capabilities import Capabilities
from housefly.errors import WireError
from housefly.messages import (
    Action,
    AnySetpoint,
    Command,
    DroneFault,
    DroneStatus,
    KnownMotion,
    Pose,
    PositionSetpoint,
    Setpoint,
    Sighting,
    Telemetry,
    VelocitySetpoint,
    VideoFrame,
)
from housefly.messages.steering import commanded, numbers_of
from housefly.messages.words import UNSAID, Words, from_tree, tree

_MAGIC = b"HFd1"
_COMMAND = struct.Struct("<BBd4d???4d")
_TELEMETRY = struct.Struct("<Bdd4d3d???3d?d")
_LINK = struct.Struct("<??d")
_LIGHT = struct.Struct("<?")
_POSE = struct.Struct("<9d")
_VIDEO = struct.Struct("<?HHIdd")
_BODY_MAX = 1_100_000
"""Longest body accepted [bytes]: a picture of the largest size (``pave.MAX_PAYLOAD``)."""
_ACTIONS, _STATES = tuple(Action), tuple(DroneStatus)
_FORMS: tuple[type[AnySetpoint], ...] = (Setpoint, VelocitySetpoint, PositionSetpoint)


@dataclass(frozen=True, slots=True)
class TimedCommand:
    """A command of the pilot.

    Attributes:
        command: what the drone is to do.
        issued_at: when that was said [s, monotonic clock of this machine].
        motion: how the drone moved then; None says nothing new.
    """

    command: Command
    issued_at: float
    motion: KnownMotion | None = None


@dataclass(frozen=True, slots=True)
class LightOrder:
    """Whether the drone's lights should say that its camera is recorded."""

    records: bool


@dataclass(frozen=True, slots=True)
class DriverStatus:
    """Health of the driver's wires.

    Attributes:
        connected, video_connected: whether reports arrive, and pictures.
        telemetry_rate_hz: reports per second.
        problem: what is wrong; UNSAID for nothing.
        capabilities: what the drone can do; None before that is known.
    """

    connected: bool = False
    video_connected: bool = False
    telemetry_rate_hz: float = 0.0
    problem: Words = UNSAID
    capabilities: Capabilities | None = None


@dataclass(frozen=True, slots=True)
class PoseNews:
    """Where tracking saw the drone, for one that wants to know."""

    seen: Sighting


DriverMessage = TimedCommand | Telemetry | DriverStatus | VideoFrame | LightOrder | PoseNews


def encode_driver_message(message: DriverMessage) -> bytes:
    """Return a message with its header."""
    kind = _KINDS.index(type(message))
    body = _ENCODE[kind](message)
    return framed(_MAGIC, kind, body)


class MessageReader:
    """Cuts a stream into messages."""

    def __init__(self) -> None:
        self._frames = FrameCutter(_MAGIC, len(_KINDS), _BODY_MAX)

    def feed(self, data: bytes) -> list[DriverMessage]:
        """Append the next bytes and return the messages now complete, oldest first.

        Raises:
            WireError: no message of ours; the connection is of no use any more.
        """
        return [_decoded(kind, body) for kind, body in self._frames.feed(data)]


def _decoded(kind: int, body: bytes) -> DriverMessage:
    try:
        return _DECODE[kind](body)
    except (struct.error, IndexError, ValueError, TypeError, RecursionError) as error:
        raise WireError(f"a {_KINDS[kind].__name__} that cannot be read: {error}") from error


def _command_bytes(timed: TimedCommand) -> bytes:
    command, motion = timed.command, timed.motion or KnownMotion()
    is_tracked = motion.forward is not None and motion.left is not None
    return _COMMAND.pack(
        *(_ACTIONS.index(command.action), _FORMS.index(type(command.asked))),
        timed.issued_at,
        *numbers_of(command.asked),
        *(timed.motion is not None, is_tracked, motion.hovers),
        *(motion.forward or 0.0, motion.left or 0.0, motion.theta, motion.phi),
    )


def _command(body: bytes) -> TimedCommand:
    action, form, issued_at, *numbers = _COMMAND.unpack(body)
    first, second, third, yaw_rate, has_motion, is_tracked, hovers, *motion_numbers = numbers
    if not isfinite(issued_at):
        raise ValueError("the time is not finite")
    asked = _FORMS[form](first, second, third, yaw_rate)
    forward, left, against_theta, against_phi = motion_numbers
    if not is_tracked:
        forward = left = None
    motion = KnownMotion(forward, left, against_theta, against_phi, hovers) if has_motion else None
    return TimedCommand(commanded(_ACTIONS[action], asked), issued_at, motion)


def _telemetry_bytes(report: Telemetry) -> bytes:
    acceleration = report.acceleration or (0.0, 0.0, 0.0)
    numbers = _TELEMETRY.pack(
        _STATES.index(report.status),
        *(report.received_at, report.battery),
        *(report.phi, report.theta, report.psi, report.height),
        *report.velocity,
        *(report.configured, report.hears_us, report.acceleration is not None),
        *acceleration,
        *(report.drone_time is not None, report.drone_time or 0.0),
    )
    return numbers + _words_bytes(report.faults, report.notes)


def _telemetry(body: bytes) -> Telemetry:
    status, received_at, battery, phi, theta, psi, height, *rest = _TELEMETRY.unpack_from(body)
    forward, left, up, configured, hears_us, accelerates, x, y, z, has_time, drone_time = rest
    faults, notes = _words(body[_TELEMETRY.size :])
    return Telemetry(
        received_at=received_at,
        status=_STATES[status],
        battery=battery,
        phi=phi,
        theta=theta,
        psi=psi,
        height=height,
        velocity=(forward, left, up),
        faults=faults,
        acceleration=(x, y, z) if accelerates else None,
        configured=configured,
        notes=notes,
        drone_time=drone_time if has_time else None,
        hears_us=hears_us,
    )


@lru_cache(maxsize=16)
def _words_bytes(faults: tuple[DroneFault, ...], notes: tuple[Words, ...]) -> bytes:
    """Return the words of a report, which are the same in most."""
    return json.dumps([[fault.value for fault in faults], [*map(tree, notes)]]).encode()


@lru_cache(maxsize=16)
def _words(data: bytes) -> tuple[tuple[DroneFault, ...], tuple[Words, ...]]:
    faults, notes = json.loads(data)
    return tuple(map(DroneFault, faults)), tuple(map(from_tree, notes))


def _status_bytes(status: DriverStatus) -> bytes:
    link = _LINK.pack(status.connected, status.video_connected, status.telemetry_rate_hz)
    return link + _health_bytes(status.problem, status.capabilities)


def _status(body: bytes) -> DriverStatus:
    connected, video_connected, rate_hz = _LINK.unpack_from(body)
    return DriverStatus(connected, video_connected, rate_hz, *_health(body[_LINK.size :]))


@lru_cache(maxsize=16)
def _health_bytes(problem: Words, capabilities: Capabilities | None) -> bytes:
    """Return what seldom changes of a driver's health."""
    able = None if capabilities is None else capabilities.model_dump(mode="json")
    return json.dumps([tree(problem), able]).encode()


@lru_cache(maxsize=16)
def _health(data: bytes) -> tuple[Words, Capabilities | None]:
    problem, able = json.loads(data)
    return from_tree(problem), None if able is None else Capabilities.model_validate(able)


def _video_bytes(frame: VideoFrame) -> bytes:
    return (
        _VIDEO.pack(
            *(frame.keyframe, frame.width, frame.height),
            *(frame.sequence, frame.received_at, frame.drone_time),
        )
        + frame.data
    )


def _video(body: bytes) -> VideoFrame:
    return VideoFrame(body[_VIDEO.size :], *_VIDEO.unpack_from(body))


def _light_bytes(order: LightOrder) -> bytes:
    return _LIGHT.pack(order.records)


def _light(body: bytes) -> LightOrder:
    return LightOrder(*_LIGHT.unpack(body))


def _pose_bytes(news: PoseNews) -> bytes:
    seen = news.seen
    numbers = seen.captured_at, seen.received_at, *seen.pose.position, *seen.pose.orientation
    return _POSE.pack(*numbers) + seen.body.encode()


def _pose(body: bytes) -> PoseNews:
    captured_at, received_at, x, y, z, *orientation = numbers = _POSE.unpack_from(body)
    if not all(map(isfinite, numbers)):
        raise ValueError("a number is not finite")
    qw, qx, qy, qz = orientation
    pose = Pose((x, y, z), (qw, qx, qy, qz))
    return PoseNews(Sighting(body[_POSE.size :].decode(), pose, captured_at, received_at))


_KINDS: tuple[type[DriverMessage], ...] = (
    TimedCommand,
    Telemetry,
    DriverStatus,
    VideoFrame,
    LightOrder,
    PoseNews,
)
_ENCODE: tuple[Callable[..., bytes], ...] = (
    _command_bytes,
    _telemetry_bytes,
    _status_bytes,
    _video_bytes,
    _light_bytes,
    _pose_bytes,
)
_DECODE: tuple[Callable[[bytes], DriverMessage], ...] = (
    _command,
    _telemetry,
    _status,
    _video,
    _light,
    _pose,
)
