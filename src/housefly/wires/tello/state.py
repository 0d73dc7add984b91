"""The state that a Tello sends ten times a second to UDP 8890 of whoever said ``command``.

One line, ``pitch:0;roll:-1;...;agz:-998.00;`` and its end. Tello EDU and Talent put what they see
of mission pads before it. Numbers are the drone's own: degrees, centimetres, per cent; its
velocities are coarse, in a frame that the guides do not name, and are not read (DJITelloPy, issue
96).
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from math import isfinite

from housefly.errors import WireError

STATE_BYTES_MAX = 512
STATE_RATE_HZ = 10.0
TOF_MAX = 1000
"""Distances above are none: nothing came back [cm]."""


@dataclass(frozen=True, slots=True)
class TelloState:
    """One state, in the drone's own signs and units.

    Attributes:
        pitch, roll, yaw: nose up, right side down, clockwise since it was switched on [deg].
        tof: distance of what is below [cm]; at least 10.
        h: height over the place of the take-off [cm], in tens.
        bat: charge [%].
        time: how long its motors have turned [s], whole seconds.
        templ, temph: temperatures inside [degC].
        baro: pressure height [m].
        vgx, vgy, vgz: speeds [dm/s], whole numbers.
        agx, agy, agz: accelerations [0.001 g].
    """

    pitch: int
    roll: int
    yaw: int
    tof: int
    h: int
    bat: int
    time: int
    templ: int = 0
    temph: int = 0
    baro: float = 0.0
    vgx: int = 0
    vgy: int = 0
    vgz: int = 0
    agx: float = 0.0
    agy: float = 0.0
    agz: float = -1000.0


_ORDER = (
    "pitch", "roll", "yaw", "vgx", "vgy", "vgz", "templ", "temph", "tof", "h", "bat", "baro",
    "time", "agx", "agy", "agz",
)  # fmt: skip
_RANGES: dict[str, tuple[float, float]] = {
    "pitch": (-180, 180), "roll": (-180, 180), "yaw": (-360, 360),
    "tof": (0, 10_000), "h": (-10_000, 10_000), "bat": (0, 100), "time": (0, 1_000_000),
    "templ": (-100, 200), "temph": (-100, 200), "baro": (-10_000, 100_000),
    "vgx": (-1000, 1000), "vgy": (-1000, 1000), "vgz": (-1000, 1000),
    "agx": (-1e5, 1e5), "agy": (-1e5, 1e5), "agz": (-1e5, 1e5),
}  # fmt: skip
_WHOLE = frozenset(_RANGES) - {"baro", "agx", "agy", "agz"}
_NEEDED = frozenset({"pitch", "roll", "yaw", "tof", "h", "bat", "time"})
assert set(_ORDER) == {field.name for field in fields(TelloState)} == set(_RANGES)


def encode_state(state: TelloState) -> bytes:
    """Return the datagram of a state, as an ordinary Tello sends it."""
    told = (
        f"{name}:{getattr(state, name)}" if name in _WHOLE else f"{name}:{getattr(state, name):.2f}"
        for name in _ORDER
    )
    return (";".join(told) + ";\r\n").encode()


def decode_state(datagram: bytes) -> TelloState:
    """Read a state; keys that we do not know are left out.

    Raises:
        WireError: no line of text, a key that is missing or stands twice, or a value with what is
            allowed.
    """
    if len(datagram) > STATE_BYTES_MAX:
        raise WireError(f"a state of {len(datagram)} bytes; allowed: {STATE_BYTES_MAX}")
    try:
        text = datagram.decode("ascii")
    except UnicodeDecodeError as error:
        raise WireError(f"a state that is not text: {datagram[:40]!r}") from error
    values: dict[str, float] = {}
    for part in text.strip("\r\n\0 ").split(";"):
        key, colon, word = part.partition(":")
        if not colon or key not in _RANGES:
            continue
        if key in values:
            raise WireError(f"a state that says {key} twice")
        values[key] = _number(key, word)
    if missing := sorted(_NEEDED - values.keys()):
        raise WireError(f"a state without {', '.join(missing)}: {text[:60]!r}")
    whole = {key: int(number) for key, number in values.items() if key in _WHOLE}
    return TelloState(**(values | whole))  # type: ignore[arg-type]


def _number(key: str, word: str) -> float:
    try:
        number = float(word)
    except ValueError as error:
        raise WireError(f"{key}: {word[:20]!r} is no number") from error
    low, high = _RANGES[key]
    if not (isfinite(number) and low <= number <= high):
        raise WireError(f"{key}: {word[:20]}; allowed: {low:g} to {high:g}")
    if key in _WHOLE and number != int(number):
        raise WireError(f"{key}: {word[:20]}; allowed: a whole number")
    return number
