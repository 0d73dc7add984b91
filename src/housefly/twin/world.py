"""The simulated room with its drones in it: everything on one clock.

World time starts at 0 and moves only by ``advance``. Everything random comes from the site's seed,
and no observer can change the course of a flight: the same seed and the same commands give the same
flight bit for bit. What drones blow down at each other is left out.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from housefly.config.site import Site
from housefly.errors import WireError
from housefly.geometry import Vec2, Vec3
from housefly.messages import AnySetpoint, DepthImage, Pose
from housefly.messages.stick import Stick
from housefly.room.model import Room
from housefly.room.tracked import untracked
from housefly.twin.clearance import UNBOUNDED, Clearance
from housefly.twin.contact_log import Contact
from housefly.twin.contracts import GroundTruth, MocapFrame, OnboardLimits, OnboardState
from housefly.twin.disturbance import Disturbances
from housefly.twin.drone_body import DroneBody
from housefly.twin.drone_stands import drone_stands
from housefly.twin.encounters import Encounters
from housefly.twin.hands import CarryOrder
from housefly.twin.marked_bodies import MarkedBodies
from housefly.twin.mocap.cameras import MocapCameras
from housefly.twin.mocap.frames import FrameMaker
from housefly.twin.movable import Movable, movable_furniture
from housefly.twin.people import Scene
from housefly.twin.people.scene_player import ScenePlayer
from housefly.twin.people.script import PersonScript
from housefly.twin.people.state import PersonState, Posture
from housefly.twin.people.visitor import Visitor
from housefly.twin.physics import Physics
from housefly.twin.sensors.depth_camera import DepthCamera
from housefly.twin.sensors.scanner import Scanner
from housefly.twin.simulated_body import CONTROL_PERIOD
from housefly.twin.simulated_drone import WORLD_ROUNDING, SimulatedDrone

_SENSING_KEY = 5077
"""Keeps the sensors of the second and further drones apart from all other noise of a seed."""


class SimulatedWorld:
    """Implements ``twin.contracts.TwinWorld``; by itself it speaks of its first drone.

    Args:
        site: drones, tracking, scanners, depth cameras, noise, seed.
        room: what stands where.
        scene: the people in it; its time is the world's.
        movables: things that no map shows; out of the building until ``put``. Furniture that the
            site's tracking system sees can be moved too, by the names of its bodies.
        people: people without a scene, away until ``put_person``; their steps are not played.

    Attributes:
        drones: by name, in the order of the site.
        first: the first of them.
    """

    def __init__(
        self,
        site: Site,
        room: Room,
        scene: Scene | None = None,
        movables: tuple[Movable, ...] = (),
        people: tuple[PersonScript, ...] = (),
    ) -> None:
        first_sensing, tracking = (
            np.random.default_rng(seed) for seed in np.random.SeedSequence(site.twin.seed).spawn(2)
        )
        self._room = room
        movables = (*movables, *movable_furniture(site, room))
        self._physics = Physics(
            site,
            untracked(room, site),
            (*(scene.script.people if scene else ()), *people),
            movables,
        )
        self._now = 0.0
        self._ticks = 0
        self.drones = self._make_drones(site, first_sensing)
        self.first = next(iter(self.drones.values()))
        cameras = MocapCameras(room.cameras, self._physics.model, self._physics.data)
        self._frames = FrameMaker(site, tracking)
        self._visitor = Visitor(self._physics, cameras)
        self._scanners = {
            laser.name: Scanner(laser, site.twin, n, self._physics)
            for n, laser in enumerate(site.lasers)
        }
        seed = site.twin.seed
        self._depth = {
            camera.name: DepthCamera(camera, seed, n, self._physics)
            for n, camera in enumerate(site.depth_cameras)
        }
        self.set_visitor(site.twin.visitor_present)
        self._stage = ScenePlayer(scene, people, self._physics, self._visitor)
        self._marked = MarkedBodies(
            site,
            self._tracked_drones(site),
            self._physics,
            cameras,
            self._visitor,
            movables,
            self._stage,
        )
        bodies = dict(zip(self.drones, self._physics.drones, strict=True))
        for name, drone in self.drones.items():
            others = {other: body for other, body in bodies.items() if other != name}
            drone.encounters = Encounters(site, room, bodies[name], self._stage.motion, others)

    def _make_drones(
        self, site: Site, first_sensing: np.random.Generator
    ) -> dict[str, SimulatedDrone]:
        stands = drone_stands(site, self._room)
        sensing = (
            first_sensing,
            *(
                np.random.default_rng(
                    np.random.SeedSequence(site.twin.seed, spawn_key=(_SENSING_KEY, number))
                )
                for number in range(1, len(stands))
            ),
        )
        return {
            stand.name: SimulatedDrone(stand, body, noise, lambda: self._now)
            for stand, body, noise in zip(stands, self._physics.drones, sensing, strict=True)
        }

    def _tracked_drones(self, site: Site) -> dict[str, DroneBody]:
        """Return the bodies of the drones that fly, by their names in tracking."""
        bodies = zip(drone_stands(site, self._room), self._physics.drones, strict=True)
        return {stand.site.tracking.body: body for stand, body in bodies if stand.config.enabled}

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._now

    def advance(self, seconds: float) -> None:
        """Run everything for this long; less than a control period waits for the next call."""
        self._now += seconds
        while (self._ticks + 1) * CONTROL_PERIOD <= self._now + WORLD_ROUNDING:
            self._tick()

    @property
    def firmware(self) -> object:
        """Its own computer."""
        return self.first.firmware

    def later(self, call: Callable[[], None]) -> None:
        """Let a command take effect after the command delay."""
        self.first.later(call)

    def set_stick(self, stick: Stick) -> None:
        """Pass on a movement command; it takes effect after the command delay."""
        self.first.set_stick(stick)

    def steer(self, asked: AnySetpoint) -> None:
        """Pass on a setpoint to a drone that takes no sticks; late as ``set_stick``."""
        self.first.steer(asked)

    def tell_pose(self, pose: Pose, captured_at: float) -> None:
        """Tell the drone where it was at a time [s]; late as ``set_stick``."""
        self.first.tell_pose(pose, captured_at)

    def keep_alive(self) -> None:
        """Any command arrived: feed the firmware's communication watchdogs."""
        self.first.keep_alive()

    def request_take_off(self) -> None:
        """REF bit 9 set."""
        self.first.request_take_off()

    def request_land(self) -> None:
        """REF bit 9 clear."""
        self.first.request_land()

    def toggle_emergency(self) -> None:
        """REF bit 8: cut the motors, or leave the emergency state."""
        self.first.toggle_emergency()

    def flat_trim(self) -> None:
        """Zero the attitude offsets; counts only when landed."""
        self.first.flat_trim()

    def set_limits(self, limits: OnboardLimits) -> None:
        """Configuration changed the maxima."""
        self.first.set_limits(limits)

    def play_leds(self, animation: int, frequency_hz: float, seconds: float) -> None:
        """Play an animation on the lights for some time [s]; 0 is for ever."""
        self.first.play_leds(animation, frequency_hz, seconds)

    def set_visitor(self, present: bool) -> None:
        """A visitor comes to the door or leaves."""
        self._visitor.set_present(present)

    @property
    def room(self) -> Room:
        """What stands where."""
        return self._room

    @property
    def visitor_present(self) -> bool:
        """Whether the visitor is at the door."""
        return self._visitor.present

    def people(self) -> tuple[Pose, ...]:
        """Return the poses of the bodies of the scene's people, in its order."""
        return self._stage.poses

    def put_person(
        self,
        name: str,
        place: Vec2 | None,
        yaw: float = 0.0,
        posture: Posture = Posture.STANDING,
        support: float = 0.0,
    ) -> None:
        """Put somebody somewhere; from now on they no longer follow their scene.

        Args:
            name: of somebody of the scene or of ``people``.
            place: feet of who stands, seat of who sits, middle of who lies [m]; None for away.
            yaw: where they face; from feet to head of who lies [rad].
            posture: how they are there.
            support: height of what carries them: 0 on the floor, the seat, the mattress [m].

        Raises:
            ConfigError: nobody has this name.
        """
        where, how = ((0.0, 0.0), Posture.AWAY) if place is None else (place, posture)
        self._stage.put(PersonState(name, where, yaw, support, how), self._now)

    def put(self, name: str, place: Vec2 | None, yaw: float = 0.0) -> None:
        """Stand a movable thing on the floor [m], turned by yaw [rad]; None removes it."""
        self._physics.put(name, place, yaw)

    @property
    def disturbances(self) -> Disturbances:
        """What disturbs the drone now."""
        return self.first.disturbances

    def disturb(self, disturbances: Disturbances) -> None:
        """Replace all disturbances, from the next control period on."""
        self.first.disturb(disturbances)

    @property
    def contact_log(self) -> tuple[Contact, ...]:
        """What the drone touched so far, other than the floor, in order of time."""
        return self.first.contact_log

    def clearance(self, within: Clearance = UNBOUNDED) -> Clearance:
        """Return how far the hull is now from what it can touch [m]; at most ``within``."""
        return self.first.clearance(within)

    def in_picture(self) -> dict[str, float]:
        """Return the share of the front camera's picture that each thing and person takes, 0 to 1.

        By name; true, cast by rays: for scores and tests.
        """
        return self.first.in_picture()

    def scan(self, laser: str) -> tuple[int, ...]:
        """Return what a scanner of the site measures now, one distance a beam [mm]."""
        return self._scanners[laser].scan()

    def depth_image(self, camera: str, captured_at: float) -> DepthImage:
        """Return what a depth camera of the site sees now, stamped with a time [s]."""
        return self._depth[camera].image(captured_at)

    def mocap_frames(self) -> tuple[MocapFrame, ...]:
        """Return the frames that have become due since the last call, oldest first."""
        return self._frames.due_frames(self._now)

    def truth(self) -> GroundTruth:
        """Return the true state of the drone now."""
        return self.first.truth()

    def onboard(self) -> OnboardState:
        """Return what the firmware believes now; it is put together once per control period."""
        return self.first.onboard()

    def put_drone(self, position: Vec3 | None = None, yaw: float | None = None) -> None:
        """Put the drone somewhere, at rest; by default on its pad."""
        self.first.put(position, yaw)

    def hover_drone(self, position: Vec3, yaw: float) -> None:
        """Put the drone into the air, hovering [m], [rad]; commands under way are lost."""
        self.first.hover(position, yaw)

    def carry_drone(self, order: CarryOrder) -> None:
        """Have somebody take the drone up that an order names, and carry it.

        Raises:
            WireError: its motors turn, or there is none of that name.
        """
        if order.drone and order.drone not in self.drones:
            raise WireError(
                f"there is no drone called {order.drone!r} (there is: {', '.join(self.drones)})"
            )
        (self.drones[order.drone] if order.drone else self.first).carry(order)

    @property
    def is_carried(self) -> bool:
        """Whether the drone is on its way in somebody's hands."""
        return self.first.is_carried

    def _push_again(self) -> None:
        for drone in self.drones.values():
            drone.push_again()

    def _tick(self) -> None:
        """Run one control period: commands, sensors, firmware, physics, battery, tracking."""
        began, drones = self._ticks * CONTROL_PERIOD, self.drones.values()
        for drone in drones:
            drone.decide(began)
        self._stage.play(self._ticks, began)
        for drone in drones:
            drone.push()
        is_fine = any(drone.is_boarded for drone in drones)
        self._physics.advance(self._push_again if is_fine else None)
        self._ticks += 1
        at = self._ticks * CONTROL_PERIOD
        for drone in drones:
            drone.arrive(at)
        for drone in drones:
            drone.look()
        if self._frames.is_due(at):
            self._frames.expose(at, self._marked.seen())
