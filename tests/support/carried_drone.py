"""A drone carried through the steps of the frame check, as tracking with a fault sees it."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import cos, pi, sin
from random import Random

from housefly.config.tracking import TrackingConfig
from housefly.geometry import Vec3, quaternion_from_euler
from housefly.lab.frames.guide import Answer, CarryGuide
from housefly.lab.frames.plan import STEPS, CarryPlan, CarryStep
from housefly.lab.frames.samples import CarryTrack, OnboardPoint, TrackedPoint
from housefly.messages import Pose, Sighting
from housefly.numeric import wrapped
from housefly.tracking.map_frame import MapFrame

RATE_HZ, ONBOARD_HZ = 20.0, 15.0
STANDING = 0.05


@dataclass(frozen=True)
class Lies:
    """What is wrong with tracking: the faults of the matrix, applied to true poses."""

    mirror_places: float | None = None
    mirror_headings: bool = False
    rotation: float = 0.0
    body_yaw: float = 0.0
    shift: Vec3 = (0.0, 0.0, 0.0)
    scale: float = 1.0
    lag: float = 0.0
    up: str = "z"
    frozen: bool = False
    no_heading: bool = False
    other_name: str = ""

    def seen(self, position: Vec3, yaw: float, pad: Vec3) -> tuple[Vec3, float]:
        """Return place and heading as tracking has them; mirrored and turned about the pad."""
        x, y, z = (a - b for a, b in zip(position, (*pad[:2], 0.0), strict=True))
        if self.mirror_places is not None:
            c, s = cos(2 * self.mirror_places), sin(2 * self.mirror_places)
            x, y = c * x + s * y, s * x - c * y
        if self.mirror_headings:
            yaw = 2 * (self.mirror_places or 0.0) - yaw
        c, s = cos(self.rotation), sin(self.rotation)
        x, y = c * x - s * y, s * x + c * y
        yaw = 0.3 if self.no_heading else yaw + self.rotation + self.body_yaw
        x, y, z = x + pad[0] + self.shift[0], y + pad[1] + self.shift[1], z + self.shift[2]
        x, y, z = self.scale * x, self.scale * y, self.scale * z
        turned = {"z": (x, y, z), "y": (x, z, -y), "-y": (x, -z, y), "down": (x, -y, -z)}[self.up]
        return turned, wrapped(yaw)


@dataclass
class Carrier:
    """A person who does what is asked, about; the drone has a path in time."""

    plan: CarryPlan
    tracking: TrackingConfig = field(default_factory=TrackingConfig)
    lies: Lies = Lies()
    seed: int = 0
    clumsiness: float = 0.0
    onboard: bool = True
    noise: float = 0.002
    now: float = 100.0
    place: Vec3 = (0.0, 0.0, STANDING)
    yaw: float = 0.0
    path: list[tuple[float, Vec3, float]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.random = Random(self.seed)
        self.guide = CarryGuide(self.plan, self.tracking)
        self.pad = (*self.plan.home, STANDING)
        self.place, self.yaw = self.pad, self.plan.heading
        self.frame = MapFrame(self.tracking)
        self.psi0 = self.random.uniform(-3.0, 3.0)

    def carry(self, to: Vec3, turn: float = 0.0, seconds: float = 2.0) -> CarryTrack:
        """Carry it somewhere, wait, and return what was seen meanwhile."""
        began, start, yaw = self.now, self.place, self.yaw
        end = began + seconds + 2.2

        def at(time: float) -> tuple[Vec3, float]:
            share = min(1.0, max(0.0, (time - began - 0.4) / seconds))
            share = share * share * (3.0 - 2.0 * share)
            x, y, z = (a + share * (b - a) for a, b in zip(start, to, strict=True))
            return (x, y, z), yaw + share * turn

        points = []
        for n in range(int((end - began) * RATE_HZ)):
            time = began + n / RATE_HZ
            position, heading = at(time - self.lies.lag)
            if self.lies.frozen:
                position, heading = self.pad, self.plan.heading
            seen, seen_yaw = self.lies.seen(position, heading, self.pad)
            noisy = tuple(value + self.random.gauss(0.0, self.noise) for value in seen)
            pose = Pose(noisy, quaternion_from_euler(0.0, 0.0, seen_yaw))  # type: ignore[arg-type]
            mapped = self.frame.on_map(Sighting(self.tracking.body, pose, time, time)).pose
            points.append(TrackedPoint(time, mapped.position, mapped.yaw))
        own = []
        for n in range(int((end - began) * ONBOARD_HZ) if self.onboard else 0):
            time = began + n / ONBOARD_HZ
            position, heading = at(time)
            height = max(0.0, position[2] - STANDING)
            own.append(OnboardPoint(time, wrapped(heading + self.psi0), height))
        self.place, self.yaw, self.now = to, yaw + turn, end
        name = self.lies.other_name or self.tracking.body
        return CarryTrack({name: tuple(points)}, tuple(own), end)

    def asked(self, step: CarryStep) -> tuple[Vec3, float]:
        """Return where a person puts it, about, and how far they turn it."""
        err, sway = self.clumsiness, self.random.uniform
        if step in (CarryStep.PAD, CarryStep.BACK):
            to = tuple(v + sway(-0.05, 0.05) * err for v in self.pad[:2])
            turn = self.plan.heading - self.yaw + sway(-0.08, 0.08) * err
            return (*to, STANDING), turn  # type: ignore[return-value]
        dx, dy, dz = self.plan.displacement(step)
        length = 1.0 + sway(-0.12, 0.12) * err
        bend = sway(-0.1, 0.1) * err
        c, s = length * cos(bend), length * sin(bend)
        x, y, z = self.place
        moved = (x + c * dx - s * dy, y + s * dx + c * dy, z + length * dz)
        if step is CarryStep.TURN:
            moved = (x, y, STANDING)
        turn = wrapped(self.plan.nose(step) - self.plan.heading) if step is CarryStep.TURN else 0.0
        return moved, turn + sway(-0.1, 0.1) * err

    def do(self, step: CarryStep) -> Answer:
        """Do a step and press Enter, again where it is doubted."""
        to, turn = self.asked(step)
        answer = self.guide.offer(self.carry(to, turn), self.now)
        for _ in range(3):
            if not answer.accepted:
                answer = self.guide.offer(self.carry(self.place), self.now)
        return answer

    def do_all(self) -> CarryGuide:
        """Do all steps."""
        for step in STEPS:
            answer = self.do(step)
            assert answer.accepted, (step, answer.words)
        return self.guide


PAD_PLAN = CarryPlan((3.0, 2.0), pi / 2)
