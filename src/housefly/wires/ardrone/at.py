"""AT commands: ASCII lines to UDP port 5556.

A line is ``AT*NAME=<sequence>[,argument...]`` and a carriage return; several lines may share a
datagram. Arguments are signed decimal integers, quoted strings, and floats written as the integer
that has the same 32 bits. ``_LAYOUTS`` is the one table of names and argument kinds. Facts: Parrot
ARDroneLib SDK 2.0.1, at_msgs.h.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Iterable
from math import isfinite
from typing import Any, NamedTuple

from housefly.errors import WireError
from housefly.wires.ardrone.at_commands import (
    Animation,
    AtCommand,
    Calibrate,
    ComWatchdog,
    Config,
    ConfigIds,
    Control,
    ControlMode,
    FlatTrim,
    Led,
    Misc,
    Other,
    Pcmd,
    PcmdFlag,
    PcmdMag,
    Pmode,
    Ref,
    RefBits,
)

__all__ = [
    "COMMAND_PORT",
    "KNOWN_BY_NAME",
    "Animation",
    "AtCommand",
    "Calibrate",
    "ComWatchdog",
    "Config",
    "ConfigIds",
    "Control",
    "ControlMode",
    "FlatTrim",
    "Led",
    "Misc",
    "NumberedCommand",
    "Other",
    "ParsedDatagram",
    "Pcmd",
    "PcmdFlag",
    "PcmdMag",
    "Pmode",
    "Ref",
    "RefBits",
    "bits_to_float",
    "encode_command",
    "encode_datagram",
    "float_to_bits",
    "parse_datagram",
]

COMMAND_PORT = 5556
_MAX_LINE = 1024
"""Longest line a drone reads, carriage return included [characters]."""
_MAX_SEQUENCE = 2**31 - 1
_REF_BASE = 0x11540000
"""Bits 18, 20, 22, 24, 28 of REF, always set by Parrot's own client."""

_SHOWN = 80
_LINE = re.compile(r"AT\*([A-Z_]+)=(\d{1,10})(?:,(.*))?", re.ASCII | re.DOTALL)
_ARGUMENT = re.compile(r'\s*(?:"([^"]*)"|([^",]*))\s*(?:,|$)', re.ASCII)
_INTEGER = re.compile(r"[+-]?\d{1,10}", re.ASCII)


class NumberedCommand(NamedTuple):
    """A command with the sequence number that it came with."""

    sequence: int
    command: AtCommand


class ParsedDatagram(NamedTuple):
    """The commands of a datagram in order, and a shortened text for each bad one."""

    commands: tuple[NumberedCommand, ...]
    rejects: tuple[str, ...] = ()


def float_to_bits(value: float) -> int:
    """Return the signed 32-bit integer with the bits of a single.

    Raises:
        WireError: beyond a single's range.
    """
    try:
        return int(struct.unpack("<i", struct.pack("<f", value))[0])
    except (OverflowError, struct.error) as error:
        raise WireError(f"{value!r} does not fit a 32-bit float") from error


def bits_to_float(bits: int) -> float:
    """Return the single whose bits are a 32-bit integer, signed or not.

    Raises:
        WireError: more than 32 bits.
    """
    if not -(2**31) <= bits < 2**32:
        raise WireError(f"{bits} has more than 32 bits")
    return float(struct.unpack("<f", struct.pack("<I", bits & 0xFFFFFFFF))[0])


def _read_integer(text: str) -> int:
    if not _INTEGER.fullmatch(text):
        raise WireError(f"{text!r} is not an integer")
    value = int(text)
    if not -(2**31) <= value < 2**32:
        raise WireError(f"{text} has more than 32 bits")
    return value


def _read_float(text: str) -> float:
    value = bits_to_float(_read_integer(text))
    if not isfinite(value):
        raise WireError(f"{text} are the bits of a number that is not finite")
    return value


def _write_string(text: str) -> str:
    if not text.isascii() or not text.isprintable() or '"' in text:
        raise WireError(f"{text!r} cannot stand in a command: printable ASCII without quotes only")
    return f'"{text}"'


class _Kind(NamedTuple):
    write: Callable[[Any], str]
    read: Callable[[str], Any]


_INT = _Kind(str, _read_integer)
_FLOAT = _Kind(lambda value: str(float_to_bits(value)), _read_float)
_STRING = _Kind(_write_string, str)
_REF = _Kind(lambda bits: str(_REF_BASE | bits), lambda text: RefBits(_read_integer(text) & 0x300))
_FLAGS = _Kind(lambda flags: str(int(flags)), lambda text: PcmdFlag(_read_integer(text) & 7))
_MOVE = (_FLAGS, _FLOAT, _FLOAT, _FLOAT, _FLOAT)


class _Layout(NamedTuple):
    build: Callable[..., AtCommand]
    kinds: tuple[_Kind, ...]
    required: int


_LAYOUTS: dict[str, _Layout] = {
    "REF": _Layout(Ref, (_REF,), 1),
    "PCMD": _Layout(Pcmd, _MOVE, 5),
    "PCMD_MAG": _Layout(PcmdMag, (*_MOVE, _FLOAT, _FLOAT), 7),
    "FTRIM": _Layout(FlatTrim, (), 0),
    "CALIB": _Layout(Calibrate, (_INT,), 1),
    "CONFIG": _Layout(Config, (_STRING, _STRING), 2),
    "CONFIG_IDS": _Layout(ConfigIds, (_STRING, _STRING, _STRING), 3),
    "CTRL": _Layout(Control, (_INT, _INT), 1),
    "COMWDG": _Layout(ComWatchdog, (), 0),
    "LED": _Layout(Led, (_INT, _FLOAT, _INT), 3),
    "ANIM": _Layout(Animation, (_INT, _INT), 2),
    "PMODE": _Layout(Pmode, (_INT,), 1),
    "MISC": _Layout(Misc, (_INT, _INT, _INT, _INT), 4),
}
"""Name, value class, argument kinds and how many arguments must be there."""

KNOWN_BY_NAME = frozenset({"GAIN", "ZAP", "CAD", "MTRIM", "PWM", "AFLIGHT", "VICON"})
"""Commands of Parrot's header that we pass through without reading their arguments."""

_NAMES: dict[object, str] = {layout.build: name for name, layout in _LAYOUTS.items()}


def encode_command(sequence: int, command: AtCommand) -> bytes:
    """Return one command as its line, carriage return included.

    Raises:
        WireError: when a number or text does not fit the wire, or the line is longer than
            ``_MAX_LINE``.
    """
    if isinstance(command, Other):
        name, arguments = command.name, command.arguments
    else:
        name = _NAMES[type(command)]
        values = (getattr(command, field) for field in command.__match_args__)
        arguments = tuple(
            kind.write(value) for kind, value in zip(_LAYOUTS[name].kinds, values, strict=True)
        )
    line = f"AT*{name}={','.join((str(sequence), *arguments))}\r"
    if len(line) > _MAX_LINE:
        raise WireError(
            f"AT*{name} would be {len(line)} characters long; at most {_MAX_LINE} are allowed"
        )
    return line.encode("ascii")


def encode_datagram(first_sequence: int, commands: Iterable[AtCommand]) -> bytes:
    """Return several commands as one datagram, numbered upwards from ``first_sequence``."""
    return b"".join(
        encode_command(first_sequence + offset, command) for offset, command in enumerate(commands)
    )


def parse_datagram(datagram: bytes) -> ParsedDatagram:
    """Read all commands of a datagram; never raises.

    Accepts what clients in the field send: line feeds, lone carriage returns, NUL padding, a
    trailing comma without arguments, REF without its constant bits.
    """
    commands: list[NumberedCommand] = []
    rejects: list[str] = []
    for line in re.split(rb"[\r\n\0]+", datagram):
        if not line:
            continue
        try:
            commands.append(_parse_line(line))
        except WireError as error:
            rejects.append(f"{line[:_SHOWN]!r}: {error}")
    return ParsedDatagram(tuple(commands), tuple(rejects))


def _parse_line(line: bytes) -> NumberedCommand:
    """Read one line without its end; raises WireError saying what is wrong with it."""
    if len(line) >= _MAX_LINE:
        raise WireError(f"line of {len(line)} characters; at most {_MAX_LINE} are allowed")
    try:
        text = line.decode("ascii")
    except UnicodeDecodeError as error:
        raise WireError("not ASCII") from error
    found = _LINE.fullmatch(text)
    if found is None:
        raise WireError("not of the form AT*NAME=sequence,arguments")
    name, number, rest = found.groups()
    sequence = int(number)
    if sequence > _MAX_SEQUENCE:
        raise WireError(f"sequence number {sequence} is above {_MAX_SEQUENCE}")
    arguments = _split(rest or "")
    if name in KNOWN_BY_NAME:
        return NumberedCommand(sequence, Other(name, arguments))
    return NumberedCommand(sequence, _build(name, arguments))


def _build(name: str, arguments: tuple[str, ...]) -> AtCommand:
    layout = _LAYOUTS.get(name)
    if layout is None:
        raise WireError(f"unknown command {name}")
    if not layout.required <= len(arguments) <= len(layout.kinds):
        raise WireError(f"{name} takes {len(layout.kinds)} arguments, got {len(arguments)}")
    return layout.build(
        *(kind.read(argument) for kind, argument in zip(layout.kinds, arguments, strict=False))
    )


def _split(text: str) -> tuple[str, ...]:
    arguments: list[str] = []
    at = 0
    while at < len(text):
        found = _ARGUMENT.match(text, at)
        if found is None:
            raise WireError("unbalanced quotes in the arguments")
        quoted, plain = found.groups()
        arguments.append(plain.strip() if quoted is None else quoted)
        at = found.end()
    return tuple(arguments)
