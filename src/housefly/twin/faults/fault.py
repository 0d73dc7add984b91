"""One fault with its time and size, and a schedule of them: pure, seeded, replayable."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
from math import cos, inf, isfinite, isnan, pi, sin

from housefly.errors import ConfigError
from housefly.geometry import Vec2
from housefly.twin.faults.fault_types import fault_type
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind, FaultType

START_MAX = 86_400.0
"""Latest start, and longest finite duration, of a fault [s]."""
OF_THE_ROOM = frozenset({FaultComponent.LASER, FaultComponent.DEPTH, FaultComponent.DEVICES})
"""What fails for all drones alike."""


@dataclass(frozen=True, slots=True)
class Fault:
    """One fault of the simulated room.

    Attributes:
        component, kind: what fails and how.
        aspect: which side of it, "" for the first that has this kind.
        start: world time at which it begins [s].
        duration: how long it lasts [s]; infinite for good.
        magnitude: its size in the unit of its type; None for the type's default.
        seed: of what is random about it.
        drone: whom it befalls, "" for the first drone of the site.

    Raises:
        ConfigError: there is no such fault, or a value is out of its range.
    """

    component: FaultComponent
    kind: FaultKind
    aspect: str = ""
    start: float = 0.0
    duration: float = inf
    magnitude: float | None = None
    seed: int = 1
    drone: str = ""

    def __post_init__(self) -> None:
        known = self.type
        object.__setattr__(self, "aspect", known.aspect)
        if not 0.0 <= self.start <= START_MAX:
            raise ConfigError("fault", f"start is {self.start:g}; allowed: 0 to {START_MAX:g} s")
        if not (0.0 < self.duration <= START_MAX or self.duration == inf):
            raise ConfigError(
                "fault",
                f"duration is {self.duration:g}; allowed: above 0 to {START_MAX:g} s, or for good",
            )
        if not 0 <= self.seed < 2**31:
            raise ConfigError("fault", f"seed is {self.seed}; allowed: 0 to {2**31 - 1}")
        if self.drone and self.component in OF_THE_ROOM:
            raise ConfigError(
                "fault", f"{self.component.value} is the room's, not {self.drone}'s: leave it out"
            )
        _check_magnitude(known, self.magnitude)

    @property
    def type(self) -> FaultType:
        """Return what is known about this kind of fault."""
        return fault_type(self.component, self.kind, self.aspect)

    @property
    def size(self) -> float:
        """Return the magnitude, in the unit of its type."""
        return self.type.default if self.magnitude is None else self.magnitude

    @property
    def end(self) -> float:
        """Return the world time at which it is over [s]; infinite for one that stays."""
        return self.start + self.duration

    def is_active(self, now: float) -> bool:
        """Return whether it is there at a world time [s]; its end belongs to it no more."""
        return self.start <= now < self.end

    def shifted(self, seconds: float) -> Fault:
        """Return the same fault, later by this long [s]."""
        return replace(self, start=self.start + seconds)

    def direction(self) -> Vec2:
        """Return a level unit vector that only the seed decides."""
        angle = 2.0 * pi * seeded_uniform(self.seed, -1)
        return cos(angle), sin(angle)

    def strikes(self, number: int) -> bool:
        """Return whether it takes the frame or packet of this number: size is the share."""
        return seeded_uniform(self.seed, number) < self.size

    def __str__(self) -> str:
        """Return how it is written on the command line."""
        size = "" if self.magnitude is None else "=" + repr(self.magnitude).removesuffix(".0")
        lasts = f"+{self.duration:.12g}s" if isfinite(self.duration) else ""
        seed = "" if self.seed == 1 else f"#{self.seed}"
        drone = f"{self.drone}: " if self.drone else ""
        return f"{drone}{self.type.name}@{self.start:.12g}s{lasts}{size}{seed}"


@dataclass(frozen=True, slots=True)
class FaultSchedule:
    """Faults in the order in which they act on the same thing."""

    faults: tuple[Fault, ...] = ()

    def active(self, now: float, component: FaultComponent | None = None) -> tuple[Fault, ...]:
        """Return the faults that are there at a world time [s], of one component or of all."""
        return tuple(
            fault
            for fault in self.faults
            if fault.is_active(now) and component in (None, fault.component)
        )

    def with_faults(self, faults: Iterable[Fault]) -> FaultSchedule:
        """Return the schedule with more faults; ``ok`` ends those of its component that began."""
        kept = self.faults
        for fault in faults:
            kept = _ended(kept, fault) if fault.kind is FaultKind.OK else (*kept, fault)
        return FaultSchedule(kept)

    def without(self, faults: Collection[Fault], now: float) -> FaultSchedule:
        """Return the schedule with some of its faults over at a time [s]."""
        return FaultSchedule(
            tuple(
                replace(fault, duration=now - fault.start) if fault in faults else fault
                for fault in self.faults
                if fault not in faults or fault.start < now
            )
        )

    @property
    def components(self) -> frozenset[FaultComponent]:
        """Return what can fail by this schedule."""
        return frozenset(fault.component for fault in self.faults)


def seeded_uniform(seed: int, number: int) -> float:
    """Return a number in [0, 1) that seed and number decide (splitmix64)."""
    mixed = (seed * 0x9E3779B97F4A7C15 + number * 0xD1B54A32D192ED03 + _STEP) & _MASK
    mixed = ((mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
    mixed = ((mixed ^ (mixed >> 27)) * 0x94D049BB133111EB) & _MASK
    return ((mixed ^ (mixed >> 31)) >> 11) / 2.0**53


_MASK = 2**64 - 1
_STEP = 0x9E3779B97F4A7C15


def _ended(faults: tuple[Fault, ...], ok: Fault) -> tuple[Fault, ...]:
    return tuple(
        replace(fault, duration=ok.start - fault.start)
        if fault.component is ok.component and fault.start < ok.start < fault.end
        else fault
        for fault in faults
    )


def _check_magnitude(known: FaultType, magnitude: float | None) -> None:
    if magnitude is None:
        return
    if not known.unit:
        raise ConfigError("fault", f"{known.name} has no magnitude; leave ={magnitude:g} out")
    if isnan(magnitude) or not known.low <= magnitude <= known.high:
        unit = "" if known.unit == "1" else f" {known.unit}"
        raise ConfigError(
            "fault",
            f"{known.name} is {magnitude:g}; allowed: {known.low:.4g} to {known.high:.4g}{unit}",
        )
