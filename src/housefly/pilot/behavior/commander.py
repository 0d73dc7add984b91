"""Obeys orders and owns the mission: the only place where its state and its task change."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from housefly.config.airframe import Airframe
from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec2
from housefly.messages.event_code import EventCode
from housefly.messages.flight import (
    Event,
    Order,
    OrderAnswer,
    OrderKind,
    OrderOutcome,
    OrderSource,
    Phase,
    Severity,
)
from housefly.messages.order_fault import shown_name
from housefly.messages.order_words import asked_words, refused_words
from housefly.messages.preflight import FRAMES_NOT_NEEDED, FramesKnown, PreflightCheck
from housefly.messages.sensing import DroneStatus
from housefly.messages.steering import PlanAnswer
from housefly.messages.words import UNSAID, Words, said
from housefly.pilot.behavior.braking import coasted
from housefly.pilot.behavior.charge import charge_refusal
from housefly.pilot.behavior.found_below import FoundBelow
from housefly.pilot.behavior.height_gap import SonarMonitor
from housefly.pilot.behavior.mission import (
    LANDING_PLACE,
    STAY,
    Mission,
    MissionState,
    Refused,
    TrackingTask,
    VehicleStatus,
)
from housefly.pilot.behavior.mission_tables import ORDERS, SIGNALS, Response, Signal
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.order_checks import OrderContext, refusal
from housefly.pilot.behavior.origin import OriginMonitor
from housefly.pilot.behavior.preflight import PreflightInputs, preflight, preflight_refusal
from housefly.pilot.behavior.proposal import AIRBORNE_PHASES, Proposal
from housefly.pilot.behavior.way_planner import NOWHERE_TO_GO, planned_task, refusal_of


class Commander:
    """Owns the mission state and the tracking task.

    Attributes:
        origin: whether tracking and map agree on where the pad is.
        airframe: of the drone.
        sonar: whether something stands below that only the drone's own sensor shows.
        found: where that was so when a landing was tried.
        insists: somebody has ordered a landing that waits to go on.
        answers: to the orders of this step that have an id.
    """

    def __init__(
        self,
        limits: LimitsConfig,
        navigator: Navigator,
        airframe: Airframe,
        frames: FramesKnown = FRAMES_NOT_NEEDED,
    ) -> None:
        self._limits = limits
        self._frames = frames
        self._navigator = navigator
        home = navigator.home()
        self.origin = OriginMonitor(home.goal or (0.0, 0.0), home.yaw or 0.0)
        self.airframe = airframe
        self.sonar = SonarMonitor(airframe.sonar)
        self.found = FoundBelow()
        self.insists = False
        self.answers: tuple[OrderAnswer, ...] = ()
        self._state = MissionState()
        self._task = TrackingTask()
        self._handlers: dict[Response, Callable[[Order, VehicleStatus], Refused | None]] = {
            Response.START: self._start,
            Response.LATER: self._start,
            Response.DEPART: self._set_off,
            Response.HOLD: self._hold,
            Response.LAND: self._land,
            Response.STOP: self._stop,
            Response.RESUME: self._resume,
            Response.CUT: self._cut,
            Response.RESET: self._reset,
            Response.NUDGE: self._nudge,
        }

    @property
    def state(self) -> MissionState:
        """How far the mission has come."""
        return self._state

    @property
    def task(self) -> TrackingTask:
        """What the drone tracks."""
        return self._task

    def obey(self, order: Order, vehicle: VehicleStatus) -> Event:
        """Carry out an order or refuse it, and say so."""
        response = ORDERS[order.kind][self._state.phase]
        context = OrderContext(
            age=vehicle.now - order.issued_at,
            response=response,
            stopped=self._state.stopped,
            landing_forced=vehicle.landing_forced,
            status=vehicle.status,
            battery=vehicle.battery,
            telemetry_age=vehicle.telemetry_age,
            pose_age=vehicle.pose_age,
            vehicle=vehicle,
        )
        refused = refusal(order, context, self._limits)
        refused = refused or self._handlers[response](order, vehicle)
        if order.id:
            self.answers += (_answer(order, refused),)
        asked = asked_words(order)
        if refused:
            text = refused_words(asked, refused.reason)
            return Event(vehicle.now, Severity.WARNING, EventCode.ORDER_REFUSED, text)
        who, what = shown_name(order.sender), said(response)
        text = Words("{asked}: {what}", asked=asked, what=what)
        if who:
            text = Words("{asked} by {who}: {what}", asked=asked, who=who, what=what)
        return Event(vehicle.now, Severity.INFO, EventCode.ORDER_ACCEPTED, text)

    def preflight(self, vehicle: VehicleStatus) -> tuple[PreflightCheck, ...]:
        """Return what the pre-flight checks find now."""
        navigator, place = self._navigator, vehicle.place
        fault = navigator.people.take_off_fault(place, vehicle.now) if place is not None else UNSAID
        return preflight(
            PreflightInputs(
                vehicle=vehicle,
                limits=self._limits,
                off_pad=self.origin.distance(vehicle),
                turned=self.origin.turn(vehicle),
                origin_confirmed=self.origin.confirmed,
                origin_distance_max=self.origin.distance_max,
                stopped=self._state.stopped,
                take_off_fault=fault,
                sees_people=navigator.sees_people,
                frames=self._frames,
                lacks=self.airframe.lacks,
            )
        )

    def apply(self, signal: Signal, now: float) -> bool:
        """Enter the phase that a signal leads to; return whether it is another one."""
        phase = SIGNALS[signal][self._state.phase]
        if phase is self._state.phase:
            return False
        self._state = self._state.entering(phase, now)
        return True

    def depart(self, mission: Mission, vehicle: VehicleStatus) -> Refused | None:
        """Set off on a mission from where the drone is."""
        task = self.way(mission, vehicle)
        if isinstance(task, Refused):
            return task
        if task is None:
            self.stay(vehicle)
            return None
        self._task = task
        self._state = self._state.entering(mission.flying_phase, vehicle.now, mission)
        return None

    def come_home(self, vehicle: VehicleStatus) -> Refused | None:
        """Set off for home."""
        return self.depart(self._navigator.home(), vehicle)

    def stay(self, vehicle: VehicleStatus) -> None:
        """Hold the place where the drone comes to rest."""
        self._task = self.halted(vehicle)
        self._state = self._state.entering(Phase.HOLDING, vehicle.now, STAY)

    def rest(self) -> None:
        """Track nothing and want nothing, in the phase that was entered."""
        self._task = TrackingTask()
        self._state = replace(self._state, mission=STAY)

    def release(self) -> None:
        """Ask no longer for a motor cut or a reset."""
        self._state = self._state.released()

    def carry_out(self, proposal: Proposal) -> None:
        """Change the mission as a monitor proposes."""
        if proposal.task is not None:
            self._task = proposal.task
        if proposal.state is not None:
            self._state = proposal.state

    def way(self, mission: Mission, vehicle: VehicleStatus) -> TrackingTask | Refused | None:
        """Return the task of flying to the goal of a mission; None when it has none."""
        coast_time = self.airframe.braking.coast_time
        return planned_task(self._navigator, mission, self._task, vehicle, coast_time)

    def other_way(self, vehicle: VehicleStatus) -> TrackingTask | Refused:
        """Return a new task for the mission under way, from where the drone is."""
        task = self.way(self._state.mission, vehicle)
        if task is None:
            return Refused(OrderOutcome.NO_WAY, NOWHERE_TO_GO)
        if isinstance(task, Refused):
            return task
        return replace(task, duration=max(task.duration, self._task.duration))

    def land_here(self, vehicle: VehicleStatus) -> None:
        """Land where the drone is."""
        self._state = self._state.entering(Phase.LANDING, vehicle.now, STAY)
        self._task = TrackingTask()

    def _route(self, mission: Mission, vehicle: VehicleStatus) -> PlanAnswer | Refused | None:
        """Return the way; None when the mission needs none."""
        if mission.goal is None:
            return None
        if vehicle.place is None:
            return Refused(OrderOutcome.UNTRACKED, Words("tracking has not seen the drone yet"))
        answer = self._navigator.route(vehicle.place, mission.goal)
        return answer if answer.path is not None else refusal_of(answer)

    def halted(self, vehicle: VehicleStatus) -> TrackingTask:
        """Return the task of coming to rest: on a trajectory in space along its own curve."""
        task = self._task
        if vehicle.reference is None or task.profile is None:
            return self.held_here(vehicle)
        return TrackingTask(
            task.profile, task.path, halted=True, comfort=task.comfort, arrival=task.arrival
        )

    def held_here(self, vehicle: VehicleStatus) -> TrackingTask:
        """Return the task of holding the place where the drone comes to rest."""
        if vehicle.estimate is None:
            return TrackingTask()
        place, velocity = vehicle.estimate.position[:2], vehicle.estimate.velocity[:2]
        return TrackingTask(
            hold=coasted(place, velocity, self.airframe.braking.coast_time),
            hold_yaw=vehicle.estimate.yaw,
            height=self.kept_height(vehicle),
        )

    def kept_height(self, vehicle: VehicleStatus) -> float | None:
        """Return the height to keep where a trajectory in space ends early [m]; else None."""
        if not self._navigator.in_space:
            return None
        return vehicle.reference.target.z if vehicle.reference else self._task.height

    def _start(self, order: Order, vehicle: VehicleStatus) -> Refused | None:
        mission = self._navigator.mission(order)
        if isinstance(mission, Refused):
            return mission
        if self._state.phase is Phase.IDLE:
            refused = preflight_refusal(self.preflight(vehicle))
            if refused:
                return refused
        answer = self._route(mission, vehicle)
        if isinstance(answer, Refused):
            return answer
        refused = charge_refusal(mission, vehicle, self._navigator, self._limits)
        if refused:
            return refused
        self._task = TrackingTask(path=answer.path if answer else None)
        is_rising = self._state.phase is Phase.TAKING_OFF
        since = self._state.since if is_rising else vehicle.now
        fresh = replace(self._state, was_cut=False)
        self._state = fresh.entering(Phase.TAKING_OFF, since, mission)
        return None

    def _set_off(self, order: Order, vehicle: VehicleStatus) -> Refused | None:
        mission = self._navigator.mission(order)
        if isinstance(mission, Refused):
            return mission
        refused = charge_refusal(mission, vehicle, self._navigator, self._limits)
        return refused or self.depart(mission, vehicle)

    def _hold(self, order: Order, vehicle: VehicleStatus) -> None:
        if self._state.phase is Phase.TAKING_OFF:
            self.rest()
        else:
            self.stay(vehicle)

    def _land(self, order: Order, vehicle: VehicleStatus) -> None:
        if self._must_wait_to_land(order, vehicle):
            here = Mission(OrderKind.HOME, LANDING_PLACE, vehicle.place)
            self._task = self.held_here(vehicle)
            self._state = self._state.entering(Phase.RETURNING, vehicle.now, here)
        elif self._state.phase is not Phase.LANDING:
            self.land_here(vehicle)
        elif vehicle.landing_waits and order.source is OrderSource.PERSON:
            self.insists = True

    def look_below(self, vehicle: VehicleStatus) -> None:
        """Take in what the drone's own sensor shows below it."""
        self.sonar.step(vehicle)
        if self.sonar.is_wrong:
            self.found.forget()
        if vehicle.status is not DroneStatus.FLYING:
            self.found.forget()
            self.insists = False
        elif vehicle.position is not None and not self.sonar.found:
            self.found.look(vehicle.position, vehicle.now)

    def fault_below(self, place: Vec2, vehicle: VehicleStatus) -> Words:
        """Return what the drone's own sensor shows below a landing at a place [m], or UNSAID.

        What it shows is remembered, because a landing is tried; but for what the map shows.
        """
        if vehicle.position is not None and self.sonar.is_sure(vehicle.now):
            beam = self.airframe.sonar.beam_radius if self.airframe.sonar else 0.0
            if not self._navigator.people.is_above_furniture(place, beam):
                self.found.show(vehicle.position, vehicle.now)
            return self.sonar.words
        return Words("something was found below here") if self.found.is_near(place) else UNSAID

    def _must_wait_to_land(self, order: Order, vehicle: VehicleStatus) -> bool:
        """Return whether somebody or something is below; a second order lands all the same.

        Only a person can see who is below: no task insists.
        """
        is_second = order.source is OrderSource.PERSON and self._state.mission.name == LANDING_PLACE
        if self._state.phase not in AIRBORNE_PHASES or self._state.stopped or is_second:
            return False
        if vehicle.place is None:
            return False
        people, rest = self._navigator.people, self.held_here(vehicle).hold
        return bool(
            people.landing_fault(vehicle.place, vehicle.now)
            or people.ground_fault(vehicle.place)
            or (rest is not None and people.ground_fault(rest))
            or self.sonar.found
            or self.found.is_near(vehicle.place)
        )

    def _stop(self, order: Order, vehicle: VehicleStatus) -> None:
        self._state = self._state.stopping(vehicle.now, vehicle.status is DroneStatus.LANDED)
        is_holding = self._state.phase is Phase.HOLDING
        self._task = self.held_here(vehicle) if is_holding else TrackingTask()

    def _resume(self, order: Order, vehicle: VehicleStatus) -> None:
        if self._state.stopped:
            self._state = replace(self._state, stopped=False)
            is_holding = self._state.phase is Phase.HOLDING
            self._task = self.held_here(vehicle) if is_holding else self._task

    def _nudge(self, order: Order, vehicle: VehicleStatus) -> Refused | None:
        """Say whether the drone may be moved by hand; ``nudging`` moves it."""
        if self._limits.nudge_speed <= 0.0:
            words = Words("moving by hand is switched off here (limits.nudge_speed)")
            return Refused(OrderOutcome.UNAVAILABLE, words)
        if not self._navigator.in_space:
            words = Words('moving by hand needs map.planner = "space", and mode default')
            return Refused(OrderOutcome.UNAVAILABLE, words)
        if vehicle.maneuvering:
            return Refused(OrderOutcome.WAITING, Words("a maneuver flies the drone"))
        waiting = self._task.waiting
        return Refused(OrderOutcome.WAITING, waiting) if waiting else None

    def _cut(self, order: Order, vehicle: VehicleStatus) -> None:
        self._state = self._state.pressing(vehicle.now, cut=True)
        if self._state.phase not in (Phase.IDLE, Phase.LANDING):
            self.land_here(vehicle)

    def _reset(self, order: Order, vehicle: VehicleStatus) -> None:
        self._state = self._state.pressing(vehicle.now, cut=False)


def _answer(order: Order, refused: Refused | None) -> OrderAnswer:
    if refused is None:
        return OrderAnswer(order.id)
    return OrderAnswer(order.id, refused.outcome, refused.reason)
