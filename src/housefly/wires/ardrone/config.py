"""The drone's configuration: value formats, the dump over TCP port 5559, multiconfig ids.

The dump is lines ``section:key = value`` and ends with a NUL byte. Facts: Parrot ARDroneLib SDK
2.0.1. The keys are in ``config_keys``.
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Iterable, Mapping
from enum import IntEnum
from math import isfinite
from typing import NamedTuple

from housefly.errors import WireError
from housefly.wires.ardrone.config_keys import CONFIG_KEYS, ConfigKey, KeyType

CONTROL_PORT = 5559
DUMP_END = b"\x00"
MAX_DUMP = 65_536
"""Longest dump that we read [bytes]; a real one has about 5000."""
COM_WATCHDOG_TIME = 1
"""What Housefly sets ``general:com_watchdog`` to [s]: the drone lands after so long without a
command, its last stick held until then; 2 as it comes, and whole seconds only.
"""
DEFAULT_ID = "00000000"
"""Id of the default session, user and application."""

KEYS_BY_NAME: dict[str, ConfigKey] = {key.name: key for key in CONFIG_KEYS}
"""The keys by their ``section:name``."""

ConfigValue = bool | int | float | str | tuple[float, ...]

_COUNTS = {KeyType.PAIR: 2, KeyType.VECTOR: 3, KeyType.MATRIX: 9}
_BOOLS = {"TRUE": True, "FALSE": False}
_INTEGER = re.compile(r"[+-]?\d{1,10}", re.ASCII)
_NUMBER = re.compile(r"[+-]?(\d{1,20}(\.\d{0,20})?|\.\d{1,20})([eE][+-]?\d{1,3})?", re.ASCII)
_NAME = re.compile(r"[a-z0-9_]{1,40}:[a-z0-9_]{1,60}", re.ASCII)
_ID = re.compile(r"[0-9a-f]{8}", re.ASCII)
_SECTIONS = ("applis", "profiles", "sessions")


class VideoCodec(IntEnum):
    """Values of ``video:video_codec``."""

    MP4_360P = 0x80
    H264_360P = 0x81
    MP4_360P_H264_720P = 0x82
    H264_720P = 0x83
    MP4_360P_H264_360P = 0x88


class VideoChannel(IntEnum):
    """Values of ``video:video_channel`` on an AR.Drone 2.0."""

    FRONT = 0
    BOTTOM = 1


def key_named(name: str) -> ConfigKey:
    """Return a known key; raises WireError for an unknown one."""
    try:
        return KEYS_BY_NAME[name]
    except KeyError:
        raise WireError(f"the drone has no configuration key {name[:80]!r}") from None


def format_value(key: ConfigKey, value: ConfigValue) -> str:
    """Return a value as the drone writes it; raises WireError when it is not of the key's type."""
    match key.type, value:
        case KeyType.BOOL, bool():
            return "TRUE" if value else "FALSE"
        case KeyType.INT, int() if not isinstance(value, bool):
            return str(int(value))
        case ((KeyType.FLOAT | KeyType.DOUBLE), (int() | float())) if not isinstance(
            value, bool
        ) and isfinite(value):
            return _float_text(value)
        case KeyType.TEXT, str() if value.isascii() and (value.isprintable() or not value):
            return value
        case ((KeyType.PAIR | KeyType.VECTOR | KeyType.MATRIX), tuple()) if len(value) == _COUNTS[
            key.type
        ] and all(map(isfinite, value)):
            return f"{{ {' '.join(map(_float_text, value))} }}"
    raise WireError(f"{key.name} takes a {key.type.value}, got {value!r}")


def parse_value(key: ConfigKey, text: str) -> ConfigValue:
    """Read a value of this key; raises WireError when the text is not of the key's type."""
    text = text.strip()
    if key.type is KeyType.TEXT:
        return text
    if key.type is KeyType.BOOL and text in _BOOLS:
        return _BOOLS[text]
    if key.type is KeyType.INT and _INTEGER.fullmatch(text):
        return int(text)
    if key.type in (KeyType.FLOAT, KeyType.DOUBLE) and (number := _number(text)) is not None:
        return number
    if key.type in _COUNTS:
        numbers = tuple(map(_number, text.removeprefix("{").removesuffix("}").split()))
        found = tuple(number for number in numbers if number is not None)
        if len(found) == len(numbers) == _COUNTS[key.type]:
            return found
    raise WireError(f"{key.name} takes a {key.type.value}, got {text[:80]!r}")


def default_values() -> dict[str, ConfigValue]:
    """Return all keys with their defaults."""
    return {key.name: parse_value(key, key.default) for key in CONFIG_KEYS}


def encode_dump(values: Mapping[str, ConfigValue]) -> bytes:
    """Return the dump of these values, NUL included.

    Raises:
        WireError: an unknown key, or a value of another type.
    """
    lines = (f"{name} = {format_value(key_named(name), value)}\n" for name, value in values.items())
    return "".join(lines).encode("ascii", errors="replace") + DUMP_END


class Dump(NamedTuple):
    """A dump that was read.

    Attributes:
        texts: by key.
        values: typed values of the known keys.
        rejects: lines that could not be read.
    """

    texts: dict[str, str]
    values: dict[str, ConfigValue]
    rejects: tuple[str, ...]


def parse_dump(data: bytes) -> Dump:
    """Read a dump; bad lines are collected, unknown keys are kept as text.

    Raises:
        WireError: longer than ``MAX_DUMP`` or without its NUL.
    """
    if len(data) > MAX_DUMP:
        raise WireError(f"configuration of {len(data)} bytes; at most {MAX_DUMP} are read")
    body, end, _ = data.partition(DUMP_END)
    if not end:
        raise WireError("configuration does not end with a NUL byte")
    dump = Dump({}, {}, ())
    rejects: list[str] = []
    for line in body.decode("ascii", errors="replace").splitlines():
        if line.strip() and not _read_line(line, dump):
            rejects.append(line[:80])
    return dump._replace(rejects=tuple(rejects))


def _read_line(line: str, dump: Dump) -> bool:
    name, equals, text = (part.strip() for part in line.partition("="))
    if not equals or not _NAME.fullmatch(name):
        return False
    dump.texts[name] = text
    key = KEYS_BY_NAME.get(name)
    if key is None:
        return True
    try:
        dump.values[name] = parse_value(key, text)
    except WireError:
        return False
    return True


class MulticonfigIds(NamedTuple):
    """The three multiconfig ids, each eight hex digits."""

    session: str = DEFAULT_ID
    user: str = DEFAULT_ID
    application: str = DEFAULT_ID


def config_id(name: str) -> str:
    """Return the customary id of a name: its CRC-32 in eight hex digits."""
    return f"{zlib.crc32(name.encode('utf-8')):08x}"


def is_config_id(text: str) -> bool:
    """Return whether a text is a multiconfig id."""
    return _ID.fullmatch(text) is not None


def encode_custom_list(
    applications: Iterable[tuple[str, str]],
    profiles: Iterable[tuple[str, str]],
    sessions: Iterable[tuple[str, str]],
) -> bytes:
    """Return the answer to CTRL mode 6: the known ids with their descriptions, NUL included."""
    parts = []
    for section, entries in zip(_SECTIONS, (applications, profiles, sessions), strict=True):
        parts.append(
            f"[{section}]\r"
            + "".join(f"{identity},{description}\r" for identity, description in entries)
        )
    return "".join(parts).encode("ascii", errors="replace") + DUMP_END


def _float_text(value: float) -> str:
    return f"{value:.7e}"


def _number(text: str) -> float | None:
    if not _NUMBER.fullmatch(text):
        return None
    value = float(text)
    return value if isfinite(value) else None
