"""Leads the mission on when something happened, and says what people should know."""

from __future__ import annotations

from housefly.config.limits import LimitsConfig
from housefly.geometry import distance
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Phase, Severity
from housefly.messages.sensing import DroneStatus
from housefly.messages.words import Words, figure, said
from housefly.pilot.behavior.collision_monitor import CollisionMonitor
from housefly.pilot.behavior.commander import Commander
from housefly.pilot.behavior.landing_monitor import ON_GOAL, LandingMonitor
from housefly.pilot.behavior.mission import MissionState, Refused, VehicleStatus
from housefly.pilot.behavior.mission_signals import SignalTimers, is_near, signals
from housefly.pilot.behavior.mission_tables import Signal
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.standing import STANDS_HIGH, raised

CUT_TIMEOUT = 15.0
"""A motor cut that is not acknowledged is given up after this [s]."""
RESET_TIMEOUT = 3.0
"""A reset likewise [s]."""
LANDS_WITHOUT_WAY = frozenset({Signal.RETURN_WANTED, Signal.OVERDUE})
"""Signals after which a drone that has no way home lands where it is."""

SIGNAL_EVENTS: dict[Signal, tuple[EventCode, Severity, Words]] = {
    Signal.AIRBORNE: (EventCode.AIRBORNE, Severity.INFO, Words("in the air")),
    Signal.FLIES_AFTER_CUT: (
        EventCode.FLIES_AFTER_CUT,
        Severity.WARNING,
        Words("the drone flies although its motors were cut: landing"),
    ),
    Signal.SINKING: (EventCode.SINKING, Severity.WARNING, Words("the drone lands by itself")),
    Signal.GROUNDED: (EventCode.GROUNDED, Severity.INFO, Words("on the ground")),
    Signal.EMERGENCY: (
        EventCode.EMERGENCY,
        Severity.FAULT,
        Words("the drone is in its emergency state: motors off"),
    ),
    Signal.ARRIVED_TO_STAY: (EventCode.ARRIVED_TO_STAY, Severity.INFO, Words("arrived")),
    Signal.ARRIVED_TO_LOOK: (EventCode.ARRIVED_TO_LOOK, Severity.INFO, Words("arrived, looking")),
    Signal.ARRIVED_HOME: (EventCode.ARRIVED_HOME, Severity.INFO, Words("above the pad, landing")),
    Signal.LOOKED: (EventCode.LOOKED, Severity.INFO, Words("looked long enough, coming home")),
    Signal.OVERDUE: (EventCode.OVERDUE, Severity.WARNING, Words("took too long")),
    Signal.BLOCKED: (EventCode.BLOCKED, Severity.WARNING, Words("the way stays blocked")),
    Signal.RETURN_WANTED: (
        EventCode.RETURN_WANTED,
        Severity.WARNING,
        Words("coming home for safety"),
    ),
    Signal.FORCED_DOWN: (EventCode.FORCED_DOWN, Severity.WARNING, Words("landing for safety")),
}
"""How a change of phase is told."""


class MissionMonitor:
    """Watches the mission of one commander."""

    def __init__(
        self,
        commander: Commander,
        collision_monitor: CollisionMonitor,
        landing_monitor: LandingMonitor,
        limits: LimitsConfig,
        tolerance: float,
        paper: bool,
    ) -> None:
        self._commander = commander
        self._collision_monitor = collision_monitor
        self._landing_monitor = landing_monitor
        self._limits = limits
        self._tolerance = tolerance
        self._paper = paper
        self._task = commander.task
        self._timers = SignalTimers()
        self._late_since = self._waited_until = -1.0

    def step(
        self, vehicle: VehicleStatus, target: TrajectorySetpoint | None, facing: bool
    ) -> list[Event]:
        """Lead the mission on.

        Args:
            vehicle: status and place of the drone.
            target: what was tracked in the last step, None while nothing was.
            facing: whether the heading is the wanted one.
        """
        commander = self._commander
        if commander.task is not self._task:
            self._task, self._timers, target = commander.task, SignalTimers(), None
        self._time(vehicle, target, facing)
        events = self._acknowledge(vehicle)
        facing = facing or self._paper
        found = signals(
            commander.state, commander.task, self._timers, vehicle, self._limits, facing
        )
        allowed, sinking = self._landing_monitor.allowed(found, vehicle)
        commander.carry_out(sinking)
        for signal in allowed:
            before = commander.state
            if commander.apply(signal, vehicle.now):
                events.extend(self._entered(signal, before, vehicle))
        events.extend(self._late_landing(vehicle))
        return events

    def _time(
        self, vehicle: VehicleStatus, target: TrajectorySetpoint | None, facing: bool
    ) -> None:
        state, timers = self._commander.state, self._timers
        near = target is not None and is_near(
            vehicle, target, self._tolerance, state, timers, self._paper
        )
        ended = target is not None and target.finished
        self._timers = timers.updated(vehicle.now, near, ended, near and facing)

    def _entered(self, signal: Signal, before: MissionState, vehicle: VehicleStatus) -> list[Event]:
        self._timers = SignalTimers()
        event = self._event(signal, before, vehicle)
        refused = self._follow_up(signal, before, vehicle)
        if refused is None:
            return [event]
        waiting = self._collision_monitor.waiting_instead(refused.reason, vehicle)
        if waiting.task is not None:
            self._commander.carry_out(waiting)
            text, code = Words("waiting here: {why}", why=refused.reason), EventCode.WAY_BLOCKED
        elif signal in LANDS_WITHOUT_WAY:
            self._commander.land_here(vehicle)
            code = EventCode.NO_WAY
            text = Words("no way home, landing here: {why}", why=refused.reason)
        else:
            self._commander.stay(vehicle)
            text, code = Words("holding here: {why}", why=refused.reason), EventCode.NO_WAY
        return [event, Event(vehicle.now, Severity.WARNING, code, text)]

    def _event(self, signal: Signal, before: MissionState, vehicle: VehicleStatus) -> Event:
        code, severity, text = SIGNAL_EVENTS[signal]
        height = raised(vehicle)
        if signal is Signal.GROUNDED and height > STANDS_HIGH:
            severity, text = (
                Severity.WARNING,
                Words("stands {d} m above the floor: on something", d=figure(height, ".2f")),
            )
        elif before.phase is Phase.LANDING and signal is Signal.GROUNDED:
            text = Words("landed")
        elif signal is Signal.BLOCKED:
            is_landing = self._commander.state.phase is Phase.LANDING
            text = (
                Words("{why}: landing here", why=text)
                if is_landing
                else Words("{why}: coming home", why=text)
            )
        elif signal is Signal.ARRIVED_HOME and not self._is_at_goal(before, vehicle):
            text = Words("landing here")
        elif signal is Signal.OVERDUE and before.phase is Phase.HOLDING:
            text = Words(
                "no order for {n} s: coming home", n=figure(self._limits.hold_timeout, ".0f")
            )
        elif signal is Signal.OVERDUE:
            text = Words("{what} took too long", what=said(before.phase))
        elif before.phase is Phase.IDLE and signal is Signal.AIRBORNE:
            severity = Severity.WARNING
            text = Words("the drone is in the air without an order: holding")
        return Event(vehicle.now, severity, code, text)

    @staticmethod
    def _is_at_goal(state: MissionState, vehicle: VehicleStatus) -> bool:
        """Return whether a landing is where it was meant to be."""
        goal, place = state.mission.goal, vehicle.place
        return goal is None or place is None or distance(goal, place) < ON_GOAL

    def _follow_up(
        self, signal: Signal, before: MissionState, vehicle: VehicleStatus
    ) -> Refused | None:
        """Give the new phase something to track."""
        commander, phase = self._commander, self._commander.state.phase
        if phase is Phase.RETURNING:
            return commander.come_home(vehicle)
        if before.phase is Phase.TAKING_OFF and phase is Phase.HOLDING:
            return commander.depart(commander.state.mission, vehicle)
        if phase in (Phase.IDLE, Phase.LANDING):
            commander.rest()
        elif phase is Phase.HOLDING and (
            commander.task.profile is None or signal is Signal.OVERDUE
        ):
            commander.stay(vehicle)
        return None

    def _acknowledge(self, vehicle: VehicleStatus) -> list[Event]:
        state, cut = self._commander.state, vehicle.status is DroneStatus.EMERGENCY
        if not (state.cutting or state.resetting):
            return []
        if cut is state.cutting:
            self._commander.release()
            text = Words("motors are cut") if cut else Words("emergency left")
            return [Event(vehicle.now, Severity.INFO, EventCode.ACKNOWLEDGED, text)]
        if vehicle.now - state.pressed_at > (CUT_TIMEOUT if state.cutting else RESET_TIMEOUT):
            self._commander.release()
            what = Words("motor cut") if state.cutting else Words("reset")
            text = Words("the drone did not acknowledge the {what}", what=what)
            return [Event(vehicle.now, Severity.FAULT, EventCode.NOT_ACKNOWLEDGED, text)]
        return []

    def _late_landing(self, vehicle: VehicleStatus) -> list[Event]:
        state, timeout = self._commander.state, self._limits.landing_timeout
        if vehicle.landing_waits:
            self._waited_until = vehicle.now
        since = max(state.since, self._waited_until)
        late = state.phase is Phase.LANDING and vehicle.now - since > timeout
        if not late or self._late_since == state.since:
            return []
        self._late_since = state.since
        text = Words(
            "landing is not acknowledged after {n} s: still asking", n=figure(timeout, ".0f")
        )
        return [Event(vehicle.now, Severity.FAULT, EventCode.LANDING_LATE, text)]
