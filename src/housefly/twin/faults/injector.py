"""All faults of one drone and its room: hands every stream to what befalls it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from typing import Protocol

from housefly.config.site import Site
from housefly.config.text import did_you_mean
from housefly.errors import ConfigError
from housefly.messages import DepthImage, Pose
from housefly.twin.contracts import EncodedPicture, MocapFrame, OnboardState
from housefly.twin.disturbance import Disturbances
from housefly.twin.faults.camera_aim import CameraAim
from housefly.twin.faults.fault import Fault, FaultSchedule
from housefly.twin.faults.intruders import (
    MOVABLE_INTRUDERS,
    PEOPLE_INTRUDERS,
    IntruderFaults,
    IntruderWorld,
    puts_in_the_way,
)
from housefly.twin.faults.mocap_stream import MocapStream
from housefly.twin.faults.onboard_stream import OnboardStream
from housefly.twin.faults.parse import faults_of
from housefly.twin.faults.physical import PhysicalFaults, TrueDrone
from housefly.twin.faults.sensor_stream import (
    Scan,
    SensorStream,
    changed_image,
    changed_picture,
    changed_scan,
)
from housefly.twin.faults.vocabulary import FaultComponent, Injection
from housefly.twin.movable import Movable
from housefly.twin.people.script import PersonScript


class DisturbableDrone(TrueDrone, Protocol):
    """What physical faults need of a drone."""

    @property
    def now(self) -> float:
        """World time [s]."""
        ...

    def disturb(self, disturbances: Disturbances) -> None:
        """Replace all disturbances."""
        ...


class FaultInjector:
    """The faults of a site that befall one drone, and those that are injected later.

    Args:
        site: as the drone's own chain sees it: its ``[[faults]]``, tracking system, drone's body.
        where: lock step or wires: a fault that cannot be made there is refused.
        intruders: whether people and things may be put in the way by faults injected later; those
            of the site may always be.

    Attributes:
        schedule: what fails when.

    Raises:
        ConfigError: a fault cannot be read, or not be made there.
    """

    def __init__(
        self, site: Site, where: Injection = Injection.LOCKSTEP, *, intruders: bool = False
    ) -> None:
        self._names = site.drone_names or (site.drone.name,)
        self._drone = site.drone.name if site.drone.name in self._names else self._names[0]
        of_site = faults_of(site)
        self._where = where
        self._has_intruders = intruders or any(map(puts_in_the_way, of_site.faults))
        self._mocap = MocapStream(site.tracking.body, site.twin.mocap_rate_hz)
        self._onboard = OnboardStream()
        self._scans: SensorStream[Scan] = SensorStream(FaultComponent.LASER, changed_scan)
        self._images: SensorStream[DepthImage] = SensorStream(FaultComponent.DEPTH, changed_image)
        self._pictures = SensorStream(FaultComponent.VIDEO, changed_picture, thins=False)
        self._aim = CameraAim()
        self._physical, self._intruders = PhysicalFaults(), IntruderFaults()
        self.schedule = FaultSchedule()
        self.inject(*of_site.faults)

    @property
    def movables(self) -> tuple[Movable, ...]:
        """What the world must have, to be put in the way; nothing where no fault does."""
        return MOVABLE_INTRUDERS if self._has_intruders else ()

    @property
    def people(self) -> tuple[PersonScript, ...]:
        """Whom the world must have, to be put in the way; nobody where no fault does."""
        return PEOPLE_INTRUDERS if self._has_intruders else ()

    def inject(self, *faults: Fault) -> None:
        """Add those faults that are this drone's; raises ConfigError for one that cannot be."""
        for fault in faults:
            if fault.drone and fault.drone not in self._names:
                raise ConfigError(
                    "fault",
                    f"{fault}: there is no drone called {fault.drone!r}"
                    f"{did_you_mean(fault.drone, self._names)} (there is:"
                    f" {', '.join(self._names)})",
                )
            if self._where not in fault.type.where:
                possible = " or ".join(sorted(place.value for place in fault.type.where))
                raise ConfigError(
                    "fault",
                    f"{fault} cannot be made in {self._where.value}, only in {possible}",
                )
            if puts_in_the_way(fault) and not self._has_intruders:
                raise ConfigError(
                    "fault",
                    f"{fault} needs somebody to put in the way: name it in the site's [[faults]],"
                    " or make the room with intruders = True",
                )
        self.schedule = self.schedule.with_faults(
            fault for fault in faults if (fault.drone or self._names[0]) == self._drone
        )

    def withdraw(self, faults: Collection[Fault], now: float) -> None:
        """End those faults now [s]; what had not begun will not."""
        self.schedule = self.schedule.without(faults, now)

    def act_on(self, world: IntruderWorld, drone: DisturbableDrone) -> None:
        """Disturb the drone, and move who is in its way, as it is now."""
        self._intruders.note_pad(drone)
        if not self.schedule.faults:
            return
        active = self.schedule.active(drone.now)
        disturbances = self._physical.changed(active, drone)
        if disturbances is not None:
            drone.disturb(disturbances)
        self._intruders.update(active, world, drone, drone.now)

    def frames(self, frames: Iterable[MocapFrame], now: float) -> tuple[MocapFrame, ...]:
        """Return the frames of the tracking system that arrive by now [s]."""
        return self._mocap.passed(frames, self.schedule, now)

    def reported(self, true: OnboardState) -> OnboardState:
        """Return what the drone reports of its state."""
        return self._onboard.reported(true, self.schedule)

    def scan(
        self, name: str, take: Callable[[], Scan], now: float
    ) -> tuple[tuple[float, Scan], ...]:
        """Return the scans that a scanner tells now [s], each with the time at which it was so."""
        return self._scans.read(name, take, self.schedule, now)

    def depth_images(
        self, name: str, take: Callable[[], DepthImage], now: float
    ) -> tuple[DepthImage, ...]:
        """Return the images that a depth camera sends now [s], oldest first."""
        return tuple(image for _, image in self._images.read(name, take, self.schedule, now))

    def pictures(self, picture: EncodedPicture, now: float) -> tuple[EncodedPicture, ...]:
        """Return what the drone's camera sends now [s] of its pictures, oldest first."""
        return tuple(
            sent for _, sent in self._pictures.read("", lambda: picture, self.schedule, now)
        )

    def view(self, pose: Pose, now: float) -> Pose | None:
        """Return the pose of a drone that sees the next picture; None when none is taken."""
        return self._aim.seen_from(pose, self.schedule.active(now, FaultComponent.VIDEO), now)
