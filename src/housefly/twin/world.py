"""The simulated room with one drone in it: everything on one clock.

World time starts at 0 and moves only by ``advance``. Everything random comes from the site's seed,
and no observer can change the course of a flight: the same seed and the same commands give the same
flight bit for bit.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

import numpy as np

from housefly.config.site import Site
from housefly.errors import WireError
from housefly.geometry import GRAVITY, Vec2, Vec3, quaternion_from_euler, yaw_of
from housefly.messages import AnySetpoint, DepthImage, Pose
from housefly.room.model import Room
from housefly.room.tracked import untracked
from housefly.twin.ardrone.battery import Battery, BatteryGauge
from housefly.twin.ardrone.body import DRONE_MASS, STANDING_HEIGHT
from housefly.twin.ardrone.firmware import WATCHDOG_AFTER
from housefly.twin.ardrone.leds import Leds
from housefly.twin.ardrone.motors import motor_duties
from housefly.twin.ardrone.onboard_sensors import OnboardSensors
from housefly.twin.clearance import UNBOUNDED, Clearance
from housefly.twin.command_delay import simulated_command_delay
from housefly.twin.contact_log import Contact
from housefly.twin.contracts import (
    FlightState,
    GroundTruth,
    MocapFrame,
    OnboardLimits,
    OnboardState,
)
from housefly.twin.disturbance import Disturbances, SensorCondition
from housefly.twin.disturbed_drone import DisturbedDrone
from housefly.twin.encounters import Encounters
from housefly.twin.hands import Carry, CarryOrder
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
from housefly.twin.setpoint_firmware import firmware_of
from housefly.twin.simulated_body import CONTROL_PERIOD, MOTORS_OFF, Wrench
from housefly.twin.sonar_beam import SonarBeam
from housefly.wires.ardrone.conversions import Stick

_WEIGHT = DRONE_MASS * GRAVITY


class SimulatedWorld:
    """Implements ``twin.contracts.TwinWorld``.

    Args:
        site: drone, tracking, scanners, depth cameras, noise, seed.
        room: what stands where.
        scene: the people in it; its time is the world's.
        movables: things that no map shows; out of the building until ``put``. Furniture that the
            site's tracking system sees can be moved too, by the names of its bodies.
        people: people without a scene, away until ``put_person``; their steps are not played.
    """

    def __init__(
        self,
        site: Site,
        room: Room,
        scene: Scene | None = None,
        movables: tuple[Movable, ...] = (),
        people: tuple[PersonScript, ...] = (),
    ) -> None:
        sensing, tracking = (
            np.random.default_rng(seed) for seed in np.random.SeedSequence(site.twin.seed).spawn(2)
        )
        self._room = room
        self._delay = simulated_command_delay(site)
        movables = (*movables, *movable_furniture(site, room))
        self._physics = Physics(
            site,
            untracked(room, site),
            (*(scene.script.people if scene else ()), *people),
            movables,
        )
        self._sensors = OnboardSensors(sensing, SonarBeam(self._physics).height)
        self._firmware, self._leds = firmware_of(site.drone), Leds()
        self._battery = Battery(site.twin.battery)
        self._gauge = BatteryGauge(self._battery)
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
        self._disturbed = DisturbedDrone(site, self._physics, self._battery)
        self._delayed: deque[tuple[float, Callable[[], None]]] = deque()
        self._now = 0.0
        self._ticks = 0
        self._heard_at = 0.0
        self._carry: Carry | None = None
        self._wrench: Wrench = MOTORS_OFF
        self._body = self._physics.state()
        self._measured = self._sensors.read(self._body)
        self._onboard: OnboardState | None = None
        self.set_visitor(site.twin.visitor_present)
        self._stage = ScenePlayer(scene, people, self._physics, self._visitor)
        self._marked = MarkedBodies(
            site, self._physics, cameras, self._visitor, movables, self._stage
        )
        self._encounters = Encounters(site, room, self._physics, self._stage.motion)

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._now

    def advance(self, seconds: float) -> None:
        """Run everything for this long; less than a control period waits for the next call."""
        self._now += seconds
        while (self._ticks + 1) * CONTROL_PERIOD <= self._now + _ROUNDING:
            self._tick()

    def set_stick(self, stick: Stick) -> None:
        """Pass on a movement command; it takes effect after the command delay."""
        self._delay_call(lambda: self._firmware.set_stick(stick))

    def steer(self, asked: AnySetpoint) -> None:
        """Pass on a setpoint to a drone that takes no sticks; late as ``set_stick``."""
        self._delay_call(lambda: self._firmware.steer(asked))

    def tell_pose(self, pose: Pose, captured_at: float) -> None:
        """Tell the drone where it was at a time [s]; late as ``set_stick``."""
        self._delay_call(lambda: self._firmware.tell_pose(pose, self._now - captured_at))

    def keep_alive(self) -> None:
        """Any command arrived: feed the firmware's communication watchdogs."""
        self._heard_at = self._now

    def request_take_off(self) -> None:
        """REF bit 9 set."""
        self._delay_call(self._firmware.request_take_off)

    def request_land(self) -> None:
        """REF bit 9 clear."""
        self._delay_call(self._firmware.request_land)

    def toggle_emergency(self) -> None:
        """REF bit 8: cut the motors, or leave the emergency state."""
        self._delay_call(self._firmware.toggle_emergency)

    def flat_trim(self) -> None:
        """Zero the attitude offsets; counts only when landed."""
        self._delay_call(self._trim)

    def set_limits(self, limits: OnboardLimits) -> None:
        """Configuration changed the maxima."""
        self._firmware.limits = limits

    def play_leds(self, animation: int, frequency_hz: float, seconds: float) -> None:
        """Play an animation on the lights for some time [s]; 0 is for ever."""
        self._leds.play(animation, frequency_hz, seconds, self._now)

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
        return self._disturbed.by

    def disturb(self, disturbances: Disturbances) -> None:
        """Replace all disturbances, from the next control period on."""
        self._disturbed.by = disturbances
        self._onboard = None

    @property
    def contact_log(self) -> tuple[Contact, ...]:
        """What the drone touched so far, other than the floor, in order of time."""
        return self._encounters.contacts

    def clearance(self, within: Clearance = UNBOUNDED) -> Clearance:
        """Return how far the hull is now from solids and people [m]; at most ``within``."""
        return self._encounters.clearance(self._ticks, within)

    def in_picture(self) -> dict[str, float]:
        """Return the share of the front camera's picture that each thing and person takes, 0 to 1.

        By name; true, cast by rays: for scores and tests.
        """
        return self._encounters.in_picture()

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
        """Return the true state now."""
        body = self._body
        return GroundTruth(
            self._ticks * CONTROL_PERIOD,
            Pose(body.position, body.orientation),
            body.velocity,
            self._physics.contacts(),
            self._leds.animation(self._now),
        )

    def onboard(self) -> OnboardState:
        """Return what the firmware believes now; it is put together once per control period."""
        is_silent = self._now - self._heard_at > WATCHDOG_AFTER
        known = self._onboard
        if known is None or known.com_watchdog is not is_silent:
            known = self._onboard = self._put_together(is_silent)
        return known

    def _put_together(self, is_silent: bool) -> OnboardState:
        """Return what the firmware believes, with or without its watchdog bit for silence."""
        firmware, measured = self._firmware, self._measured
        return OnboardState(
            at=self._ticks * CONTROL_PERIOD,
            flight=firmware.flight,
            battery=self._gauge.charge,
            battery_voltage=self._gauge.voltage,
            phi=measured.phi,
            theta=measured.theta,
            psi=measured.psi,
            height=measured.height,
            velocity=(measured.forward, measured.left, measured.climb),
            acceleration=measured.acceleration,
            angular_rate=measured.rate,
            motors=motor_duties(self._wrench),
            low_battery=firmware.low_battery,
            com_watchdog=is_silent,
            com_lost=firmware.com_lost,
            angles_out_of_range=firmware.tilted,
            motors_problem=not firmware.powered,
            ultrasound_deaf=self.disturbances.sensors.sonar is SensorCondition.OFF,
        )

    def put_drone(self, position: Vec3 | None = None, yaw: float | None = None) -> None:
        """Put the drone somewhere, at rest; by default on its pad."""
        home = (*self._room.home, STANDING_HEIGHT)
        heading = self._room.home_yaw if yaw is None else yaw
        self._physics.place(position or home, quaternion_from_euler(0.0, 0.0, heading))
        self._body = self._physics.state()

    def hover_drone(self, position: Vec3, yaw: float) -> None:
        """Put the drone into the air, hovering [m], [rad]; commands under way are lost."""
        self._delayed.clear()
        self.put_drone(position, yaw)
        self._firmware.begin_hovering(position[2])
        self._onboard = None

    def carry_drone(self, order: CarryOrder) -> None:
        """Have somebody take the drone up and carry it; held in the air it stays in their hands.

        Raises:
            WireError: its motors turn.
        """
        if self._wrench.thrust > 0.0:
            raise WireError("nobody takes hold of a drone whose propellers turn")
        self._carry = Carry(order, self._body.position, yaw_of(self._body.orientation), self._now)

    @property
    def is_carried(self) -> bool:
        """Whether the drone is on its way in somebody's hands."""
        return self._carry is not None and not self._carry.is_over(self._now)

    def _delay_call(self, call: Callable[[], None]) -> None:
        self._delayed.append((self._now + self._delay, call))

    def _trim(self) -> None:
        if self._firmware.flight is FlightState.LANDED:
            self._sensors.flat_trim()

    def _tick(self) -> None:
        """Run one control period: commands, sensors, firmware, physics, battery, tracking."""
        began = self._ticks * CONTROL_PERIOD
        while self._delayed and self._delayed[0][0] <= began + _ROUNDING:
            self._delayed.popleft()[1]()
        before = self._body
        self._measured = self._disturbed.sense(
            self._sensors.read(before), self._wrench.thrust > 0.0
        )
        self._wrench = self._firmware.step(
            self._measured, self._gauge.voltage, began - self._heard_at
        )
        self._stage.play(self._ticks, began)
        self._disturbed.advance(self._wrench, before)
        if self._carry is not None:
            self._follow_hands(self._carry, began + CONTROL_PERIOD)
        self._battery.drain(CONTROL_PERIOD, self._wrench.thrust / _WEIGHT)
        self._gauge.read(self._disturbed.by)
        self._onboard = None
        self._body = self._physics.state()
        self._ticks += 1
        self._encounters.look(self._ticks, before, self._wrench.thrust > 0.0)
        if self._frames.is_due(self._ticks * CONTROL_PERIOD):
            self._frames.expose(self._ticks * CONTROL_PERIOD, self._marked.seen(self._body))

    def _follow_hands(self, carry: Carry, now: float) -> None:
        """Move the drone with the hands that carry it; laid down, or started, it is let go."""
        position, yaw, velocity, turn_rate = carry.at(now)
        self._physics.place(
            position, quaternion_from_euler(0.0, 0.0, yaw), velocity, (0.0, 0.0, turn_rate)
        )
        is_laid = carry.is_over(now) and position[2] <= STANDING_HEIGHT + _LAID
        if is_laid or self._wrench.thrust > 0.0:
            self._carry = None


_LAID = 0.02
"""A drone that is let go so near to the floor is laid down [m]."""
_ROUNDING = 1e-9
