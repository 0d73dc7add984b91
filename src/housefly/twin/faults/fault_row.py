"""A row of the fault matrix, and the ways to inject it."""

from __future__ import annotations

from dataclasses import dataclass, field

from housefly.errors import ConfigError
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.vocabulary import Injection


@dataclass(frozen=True, slots=True)
class FaultVariant:
    """One way to inject a row.

    Attributes:
        name: behind the slash of ``F13/5cm``.
        faults: as seen from the moment at which the row begins, which is 0 s.
        from_start: it makes sense only from before take-off on, like a wrong map.
        wires_only: it cannot be made in lock step.
        cannot_hover: nothing keeps the drone in the air any more, so that it falls is not judged;
            that its motors stop, and what it strikes, is.
        is_extreme: stronger than the drone is made for, so that campaigns leave it out.
        unscanned: it is flown in a room without scanners, where only the sonar shows who is below.
    """

    name: str
    faults: tuple[Fault, ...]
    from_start: bool = False
    wires_only: bool = False
    cannot_hover: bool = False
    is_extreme: bool = False
    unscanned: bool = False


@dataclass(frozen=True, slots=True)
class FaultRow:
    """One row of the fault matrix.

    Attributes:
        number: F01 to F51.
        title: what happens.
        safe_outcome: how it must end, in words.
        where: where it can be made; without LOCKSTEP and WIRES it is no fault of the twin.
        variants: ways to inject it, the first being meant when none is named.
        harmful: whether the same flight without its guards is expected to do harm.
        covered_by: the test or command that shows it where no variant does.
        crossed: it is flown with each of a person's orders, too.
    """

    number: str
    title: str
    safe_outcome: str
    where: frozenset[Injection]
    variants: tuple[FaultVariant, ...] = ()
    harmful: bool = False
    covered_by: str = field(default="", kw_only=True)
    crossed: bool = field(default=False, kw_only=True)

    def faults_of(self, variant: str = "") -> tuple[Fault, ...]:
        """Return the faults of a variant, the first without a name; raises ConfigError."""
        if not self.variants:
            raise ConfigError(
                "fault",
                f"{self.number} ({self.title}) is no fault of the simulated room; it is covered"
                f" by: {self.covered_by}",
            )
        for known in self.variants:
            if variant in ("", known.name):
                return known.faults
        names = ", ".join(f"{self.number}/{known.name}" for known in self.variants)
        raise ConfigError("fault", f"{self.number} has no variant {variant!r}; it has {names}")
