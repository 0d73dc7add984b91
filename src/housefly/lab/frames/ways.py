"""The ways that a drone was carried: as seen, as they were, and whether their lengths agree."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, degrees, hypot, pi, radians

from housefly.geometry import Vec3
from housefly.lab.frames.corrections import scale_mend
from housefly.lab.frames.findings import FrameFault, FrameFinding
from housefly.lab.frames.plan import CarryPlan, CarryStep
from housefly.lab.frames.samples import FrameSample
from housefly.numeric import wrapped

SCALE_RANGE = (0.8, 1.25)
"""Seen over true length that a tape and a person come to."""
EVEN_RANGE = (0.7, 1.43)
"""Ratio of the two seen ways that a tape and a person come to."""


@dataclass(frozen=True, slots=True)
class CarriedWays:
    """The ways as seen, and as they were [m]."""

    ahead: Vec3
    side: Vec3
    lift: Vec3
    asked: tuple[float, float]
    """Headings of the two ways over the floor on the map [rad]."""
    true: tuple[float, float]
    """Their lengths [m]."""

    @property
    def scales(self) -> tuple[float, float]:
        """Seen over true lengths of the two ways."""
        return hypot(*self.ahead) / self.true[0], hypot(*self.side) / self.true[1]

    @property
    def seen(self) -> tuple[float, float]:
        """Headings of the two ways as seen [rad]."""
        return atan2(self.ahead[1], self.ahead[0]), atan2(self.side[1], self.side[0])

    @property
    def is_mirrored(self) -> bool:
        """Whether the second way goes to the other side of the first."""
        turned, asked = (wrapped(b - a) for a, b in (self.seen, self.asked))
        return turned * asked < 0.0


def carried_ways(plan: CarryPlan, by_step: dict[CarryStep, FrameSample]) -> CarriedWays:
    """Return the ways that were asked for, and as the samples show them."""
    place = {step: sample.position or (0.0, 0.0, 0.0) for step, sample in by_step.items()}
    ahead, side = (plan.displacement(step) for step in (CarryStep.AHEAD, CarryStep.SIDE))
    return CarriedWays(
        ahead=_from_to(place[CarryStep.PAD], place[CarryStep.AHEAD]),
        side=_from_to(place[CarryStep.AHEAD], place[CarryStep.SIDE]),
        lift=_from_to(place[CarryStep.SIDE], place[CarryStep.LIFT]),
        asked=(atan2(ahead[1], ahead[0]), atan2(side[1], side[0])),
        true=(hypot(*ahead), hypot(*side)),
    )


def length_findings(ways: CarriedWays, scale: float) -> list[FrameFinding]:
    """Return what is wrong with the lengths and the right angle of the ways."""
    first, second = ways.scales
    if not EVEN_RANGE[0] <= first / second <= EVEN_RANGE[1]:
        return [
            FrameFinding(
                FrameFault.UNEVEN,
                f"One way is seen {first:.2f} times as long as it was, the other {second:.2f}"
                " times",
                "measure with a tape and check again; if it comes again, calibrate the cameras",
            )
        ]
    angle = abs(wrapped(ways.seen[1] - ways.seen[0]))
    if abs(angle - pi / 2) > radians(35.0):
        return [
            FrameFinding(
                FrameFault.UNEVEN,
                f"Two ways at a right angle are seen {degrees(angle):.0f} deg apart",
                "check again; if it comes again, calibrate the cameras",
            )
        ]
    if SCALE_RANGE[0] <= scale <= SCALE_RANGE[1]:
        return []
    words = f"Ways are seen {scale:.4g} times as long as they are"
    return [FrameFinding(FrameFault.SCALE, words, scale_mend(scale))]


def _from_to(a: Vec3, b: Vec3) -> Vec3:
    return b[0] - a[0], b[1] - a[1], b[2] - a[2]
