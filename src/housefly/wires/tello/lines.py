"""The lines of text that a Tello takes on UDP 8889, one a datagram.

Facts: the maker's guides to SDK 1.3, 2.0 and 3.0. Lengths in cm, angles in degrees, as on the wire.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.errors import WireError

COMMAND_PORT, STATE_PORT, VIDEO_PORT = 8889, 8890, 11111
"""Of the drone, of the client that hears its state, of the client that sees its pictures."""
STICK_MAX = 100
LINE_BYTES_MAX = 256
"""No line of any SDK is longer."""


class Word(Enum):
    """Commands without arguments."""

    COMMAND = "command"
    TAKE_OFF = "takeoff"
    LAND = "land"
    STOP = "stop"
    EMERGENCY = "emergency"
    STREAM_ON = "streamon"
    STREAM_OFF = "streamoff"
    MOTOR_ON = "motoron"
    MOTOR_OFF = "motoroff"
    KEEP_ALIVE = "keepalive"


class Question(Enum):
    """What it can be asked."""

    BATTERY = "battery?"
    SPEED = "speed?"
    TIME = "time?"
    WIFI = "wifi?"
    SDK = "sdk?"
    SERIAL = "sn?"
    HEIGHT = "height?"
    TEMPERATURE = "temp?"
    ATTITUDE = "attitude?"
    BAROMETER = "baro?"
    DISTANCE = "tof?"
    ACCELERATION = "acceleration?"


class Direction(Enum):
    """Where a step goes; the last two turn."""

    UP = "up"
    DOWN = "down"
    LEFT = "left"
    RIGHT = "right"
    FORWARD = "forward"
    BACK = "back"
    CLOCKWISE = "cw"
    COUNTER_CLOCKWISE = "ccw"

    @property
    def turns(self) -> bool:
        """Whether the amount is an angle."""
        return self in (Direction.CLOCKWISE, Direction.COUNTER_CLOCKWISE)


@dataclass(frozen=True, slots=True)
class Sticks:
    """``rc``: the four sticks, -100 to 100; the last ones hold until others come."""

    right: int = 0
    ahead: int = 0
    up: int = 0
    clockwise: int = 0


@dataclass(frozen=True, slots=True)
class Step:
    """One step of 20 to 500 cm, or a turn of 1 to 360 degrees."""

    direction: Direction
    amount: int


@dataclass(frozen=True, slots=True)
class Go:
    """``go``: forward, left, up [cm], at a speed [cm/s]."""

    x: int
    y: int
    z: int
    speed: int


@dataclass(frozen=True, slots=True)
class SetSpeed:
    """``speed``: of steps [cm/s], 10 to 100."""

    speed: int


Line = Word | Question | Sticks | Step | Go | SetSpeed

_WORDS: dict[str, Word | Question] = {one.value: one for kind in (Word, Question) for one in kind}
_DIRECTIONS = {one.value: one for one in Direction}
_STICK, _DISTANCE, _SPEED = (-STICK_MAX, STICK_MAX), (20, 500), (10, 100)
_TURN, _OFFSET = (1, 360), (-500, 500)
_OFFSET_MIN = 20
"""Of ``go`` at least one offset is as large [cm]."""


def encode_line(line: Line) -> bytes:
    """Return the datagram of a line; raises WireError for a number that it must not hold."""
    match line:
        case Word() | Question():
            text = str(line.value)
        case Sticks(right, ahead, up, clockwise):
            text = _told("rc", (right, ahead, up, clockwise), (_STICK,) * 4)
        case Step(direction, amount):
            text = _told(direction.value, (amount,), (_range_of(direction),))
        case Go(x, y, z, speed):
            _check_offsets(x, y, z)
            text = _told("go", (x, y, z, speed), (*(_OFFSET,) * 3, _SPEED))
        case SetSpeed(speed):
            text = _told("speed", (speed,), (_SPEED,))
    return text.encode()


def decode_line(datagram: bytes) -> Line:
    """Read a line; raises WireError for one that a Tello does not know, or with a bad number."""
    if len(datagram) > LINE_BYTES_MAX:
        raise WireError(f"a line of {len(datagram)} bytes; allowed: {LINE_BYTES_MAX}")
    try:
        name, *words = datagram.decode("ascii").split() or [""]
    except UnicodeDecodeError as error:
        raise WireError(f"not text: {datagram[:40]!r}") from error
    if name in _WORDS and not words:
        return _WORDS[name]
    if name == "rc":
        return Sticks(*_numbers(name, words, (_STICK,) * 4))
    if name in _DIRECTIONS:
        direction = _DIRECTIONS[name]
        return Step(direction, *_numbers(name, words, (_range_of(direction),)))
    if name == "go":
        x, y, z, speed = _numbers(name, words, (*(_OFFSET,) * 3, _SPEED))
        _check_offsets(x, y, z)
        return Go(x, y, z, speed)
    if name == "speed":
        return SetSpeed(*_numbers(name, words, (_SPEED,)))
    raise WireError(f"no command of a Tello: {datagram[:40]!r}")


def _range_of(direction: Direction) -> tuple[int, int]:
    return _TURN if direction.turns else _DISTANCE


def _check_offsets(x: int, y: int, z: int) -> None:
    if max(abs(x), abs(y), abs(z)) < _OFFSET_MIN:
        raise WireError(f"go {x} {y} {z}: allowed: one of them {_OFFSET_MIN} cm or more")


def _told(name: str, numbers: tuple[int, ...], ranges: tuple[tuple[int, int], ...]) -> str:
    for number, (low, high) in zip(numbers, ranges, strict=True):
        _check(name, number, low, high)
    return " ".join((name, *map(str, numbers)))


def _numbers(name: str, words: list[str], ranges: tuple[tuple[int, int], ...]) -> tuple[int, ...]:
    if len(words) != len(ranges):
        raise WireError(f"{name} with {len(words)} numbers; allowed: {len(ranges)}")
    numbers = tuple(_integer(name, word) for word in words)
    for number, (low, high) in zip(numbers, ranges, strict=True):
        _check(name, number, low, high)
    return numbers


def _integer(name: str, word: str) -> int:
    digits = word.removeprefix("-").removeprefix("+")
    if not (digits.isdecimal() and len(digits) <= 6 and len(word) - len(digits) <= 1):
        raise WireError(f"{name}: {word[:20]!r} is no whole number")
    return int(word)


def _check(name: str, number: int, low: int, high: int) -> None:
    if not low <= number <= high:
        raise WireError(f"{name}: {number}; allowed: {low} to {high}")
