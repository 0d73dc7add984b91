"""The mission of one drone: what it was asked, how far it has come, and what it tracks now."""

from __future__ import annotations

from collections.abc import Callable

from housefly.config.airframe import Airframe
from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec2
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Order, OrderAnswer, Severity
from housefly.messages.preflight import FRAMES_NOT_NEEDED, FramesKnown, PreflightCheck
from housefly.messages.words import Words
from housefly.pilot.behavior.blind_landing import BlindLanding
from housefly.pilot.behavior.collision_monitor import CollisionMonitor
from housefly.pilot.behavior.commander import Commander
from housefly.pilot.behavior.faster_way import FasterWayMonitor
from housefly.pilot.behavior.landing_monitor import LandingMonitor
from housefly.pilot.behavior.mission import MissionState, TrackingTask, VehicleStatus
from housefly.pilot.behavior.mission_monitor import MissionMonitor
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.nudging import NudgeMonitor
from housefly.pilot.behavior.off_course import OffCourseMonitor
from housefly.pilot.behavior.passing_monitor import PassingMonitor
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.priorities import PRIORITIES, Situation, Watch
from housefly.pilot.behavior.proposal import NOTHING, Look, Monitor
from housefly.pilot.behavior.separation_monitor import SeparationMonitor
from housefly.pilot.behavior.steered_landing import BlindPlan


class LostDronesMonitor:
    """Tells what a navigator finds out about the other drones."""

    def __init__(self, navigator: Navigator) -> None:
        self._navigator = navigator
        self._told: tuple[str, ...] = ()

    def step(self, now: float) -> list[Event]:
        """Return what is new at a time [s]."""
        lost, told = self._navigator.lost_drones, self._told
        self._told = lost
        gone = [
            Event(
                now,
                Severity.WARNING,
                EventCode.DRONE_LOST,
                Words(
                    "{who} flew and is not seen any more: its last place is kept clear", who=name
                ),
            )
            for name in lost
            if name not in told
        ]
        back = [
            Event(
                now,
                Severity.INFO,
                EventCode.DRONE_SEEN,
                Words("the last place of {who} is no longer kept clear", who=name),
            )
            for name in told
            if name not in lost
        ]
        return [*gone, *back]


class MissionManager:
    """Orders first, then what happened, then what the monitors propose, by ``PRIORITIES``."""

    def __init__(
        self,
        limits: LimitsConfig,
        navigator: Navigator,
        airframe: Airframe,
        tolerance: float,
        paper: bool,
        frames: FramesKnown = FRAMES_NOT_NEEDED,
    ) -> None:
        self._commander = Commander(limits, navigator, airframe, frames)
        self._collisions = CollisionMonitor(self._commander, navigator, airframe.braking)
        self._passing = PassingMonitor(self._commander, navigator)
        self._separation = SeparationMonitor(self._commander, navigator, airframe, paper)
        self._lost_drones = LostDronesMonitor(navigator)
        self._nudges = NudgeMonitor(self._commander, navigator, limits)
        self._landings = LandingMonitor(self._commander, navigator, paper, limits)
        self._blind = BlindLanding(self._commander, navigator, paper, limits)
        self._monitor = MissionMonitor(
            self._commander, self._collisions, self._landings, limits, tolerance, paper
        )
        monitors: dict[Watch, Monitor] = {
            Watch.LANDING: self._landings,
            Watch.BLIND_LANDING: self._blind,
            Watch.COLLISION: self._collisions,
            Watch.OFF_COURSE: OffCourseMonitor(self._commander, limits, paper),
            Watch.PASSING: self._passing,
            Watch.FASTER_WAY: FasterWayMonitor(self._commander, navigator),
            Watch.SEPARATION: self._separation,
            Watch.NUDGE: self._nudges,
        }
        holds: dict[Situation, Callable[[], bool]] = {
            Situation.MAKING_WAY: lambda: self._separation.is_yielding,
            Situation.AWAITING_PASSAGE: lambda: self._passing.is_waiting,
        }
        self._rows = tuple(
            (monitors[row.watch], tuple(holds[situation] for situation in row.silenced_by))
            for row in PRIORITIES
        )

    @property
    def state(self) -> MissionState:
        """How far the mission has come."""
        return self._commander.state

    @property
    def task(self) -> TrackingTask:
        """What the drone tracks."""
        return self._commander.task

    @property
    def speed_factor(self) -> float:
        """Share of the cruise speed to fly at near people, 0 to 1; 1 while it is moved by hand."""
        if self._nudges.is_moving:
            return 1.0
        return min(self._separation.speed_factor, self._passing.rate)

    @property
    def origin_confirmed(self) -> bool:
        """Whether tracking has shown the drone on its pad, or was found to agree with the map."""
        return self._commander.origin.confirmed

    @property
    def origin_revoked(self) -> bool:
        """Whether tracking was found lying, and has not shown the drone on its pad since."""
        return self._commander.origin.revoked

    @property
    def is_yielding(self) -> bool:
        """Whether the drone makes way for somebody."""
        return self._separation.is_yielding

    def found_below(self, vehicle: VehicleStatus) -> tuple[Vec2, ...]:
        """Return where the drone's own sensor found something below [m], if it shows some now."""
        commander, place = self._commander, vehicle.place
        return tuple(commander.found) if place and commander.fault_below(place, vehicle) else ()

    @property
    def blind_landing(self) -> BlindPlan:
        """Why not to land without tracking where the drone is, and what to fly instead."""
        return self._blind.plan

    @property
    def answers(self) -> tuple[OrderAnswer, ...]:
        """What became of the orders of the last step that have an id."""
        return self._commander.answers

    def preflight(self, vehicle: VehicleStatus) -> tuple[PreflightCheck, ...]:
        """Return what the pre-flight checks find now."""
        return self._commander.preflight(vehicle)

    def update(
        self,
        orders: tuple[Order, ...],
        vehicle: VehicleStatus,
        target: TrajectorySetpoint | None,
        facing: bool,
    ) -> list[Event]:
        """Bring the mission up to now and return what people should know.

        Args:
            orders: since the last step.
            vehicle: status and place of the drone.
            target: what was tracked in the last step, None while nothing was.
            facing: whether the heading is the wanted one.
        """
        events: list[Event] = []
        self._commander.answers = ()
        self._commander.origin.step(vehicle)
        self._commander.look_below(vehicle)
        for order in orders:
            answer = self._commander.obey(order, vehicle)
            events.extend(self._nudges.heard(order, answer, vehicle.now))
        events.extend(self._monitor.step(vehicle, target, facing))
        for monitor, silencers in self._rows:
            silent = False
            for holds in silencers:
                silent = silent or holds()
            rate, share = self._passing.rate, self._separation.speed_factor
            proposal = monitor.propose(Look(vehicle, target, silent, rate, share))
            if proposal is not NOTHING:
                self._commander.carry_out(proposal)
                events.extend(proposal.events)
        events.extend(self._lost_drones.step(vehicle.now))
        return events
