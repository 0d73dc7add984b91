"""The parameters of a range finder (PP), and the two models that the twin serves."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from housefly.errors import WireError
from housefly.wires.scip.characters import checksum, strip_checksum
from housefly.wires.scip.replies import STATUS_DONE, ScipReply

_NUMBERS = ("DMIN", "DMAX", "ARES", "AMIN", "AMAX", "AFRT", "SCAN")
_MAX_STEPS = 10_000


@dataclass(frozen=True, slots=True)
class ScannerParameters:
    """The reply to PP.

    Attributes:
        model: name.
        shortest, longest: distances that it can measure [mm].
        resolution: steps of a whole turn.
        first, last: steps that it measures.
        front: step that looks forward.
        rpm: turns of its mirror a minute.
    """

    model: str
    shortest: int
    longest: int
    resolution: int
    first: int
    last: int
    front: int
    rpm: int

    @property
    def step(self) -> float:
        """Angle between two steps [rad]."""
        return 2.0 * pi / self.resolution

    @property
    def first_angle(self) -> float:
        """Angle of the first step [rad], counter-clockwise from the front."""
        return (self.first - self.front) * self.step

    @property
    def beams(self) -> int:
        """Number of steps that it measures."""
        return self.last - self.first + 1

    @property
    def period(self) -> float:
        """Time of one scan [s]."""
        return 60.0 / self.rpm

    def reply(self) -> ScipReply:
        """Return the reply to PP."""
        numbers = (
            self.shortest, self.longest, self.resolution,
            self.first, self.last, self.front, self.rpm,
        )  # fmt: skip
        return named_values_reply(
            "PP",
            [
                ("MODL", self.model),
                *((name, str(value)) for name, value in zip(_NUMBERS, numbers, strict=True)),
            ],
        )

    @staticmethod
    def of(reply: ScipReply) -> ScannerParameters:
        """Return the parameters in a reply to PP; raises WireError if incomplete or impossible."""
        values = named_values(reply)
        try:
            numbers = [int(values[name]) for name in _NUMBERS]
            found = ScannerParameters(values["MODL"], *numbers)
        except (KeyError, ValueError) as error:
            raise WireError(f"the sensor does not tell its parameters: {error}") from error
        if not (
            0 <= found.first <= found.last < _MAX_STEPS
            and 0 < found.resolution < _MAX_STEPS
            and 0 < found.rpm < 100_000
        ):
            raise WireError(f"the parameters of {found.model[:40]!r} make no sense")
        if not (0 <= found.shortest < found.longest < 1 << 18 and 0 <= found.front < _MAX_STEPS):
            raise WireError(f"the parameters of {found.model[:40]!r} make no sense")
        return found


URG_04LX = ScannerParameters(
    "URG-04LX(Hokuyo Automatic Co.,Ltd.)", 20, 5600, 1024, 44, 725, 384, 600
)
UST_10LX = ScannerParameters("UST-10LX", 20, 30000, 1440, 0, 1080, 540, 2400)
MODELS = {"urg-04lx": URG_04LX, "ust-10lx": UST_10LX}
NO_ECHO = {"urg-04lx": 0, "ust-10lx": 65533}
"""Distance that each model reports where nothing comes back [mm]."""


def named_values_reply(code: str, pairs: list[tuple[str, str]]) -> ScipReply:
    """Return a reply of named values, "NAME:value;" and a checksum each."""
    return ScipReply(
        code,
        STATUS_DONE,
        tuple(f"{name}:{value};{checksum(f'{name}:{value}')}" for name, value in pairs),
    )


def named_values(reply: ScipReply) -> dict[str, str]:
    """Return the named values of a reply to VV, PP or II; raises WireError for a wrong checksum."""
    values = {}
    for line in reply.lines:
        text, semicolon, check = line.rpartition(";")
        if not semicolon or strip_checksum(text + check) != text:
            raise WireError(f"{line[:40]!r} is no named value")
        name, _, value = text.partition(":")
        values[name] = value.strip()
    return values
