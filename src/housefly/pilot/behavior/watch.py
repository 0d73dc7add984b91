"""Leads the errand on when something happened, and tells people what they should know."""

from __future__ import annotations

from dataclasses import replace

from housefly.config.site import LimitsConfig
from housefly.messages import DroneStatus, Event, Phase, Severity
from housefly.pilot.behavior.captain import Captain, Course
from housefly.pilot.behavior.errand import STAY, Errand, Signal
from housefly.pilot.behavior.lookout import Lookout
from housefly.pilot.behavior.progress import Clocks, is_near, signals
from housefly.pilot.behavior.scene import Scene
from housefly.pilot.behavior.tracking import Track

CUT_PATIENCE = 15.0
"""A motor cut that is not acknowledged is given up after this [s]."""
RESET_PATIENCE = 3.0
"""A reset likewise [s]."""

WORDS: dict[Signal, tuple[Severity, str]] = {
    Signal.AIRBORNE: (Severity.INFO, "in the air"),
    Signal.SINKING: (Severity.WARNING, "the drone lands by itself"),
    Signal.GROUNDED: (Severity.INFO, "on the ground"),
    Signal.EMERGENCY: (Severity.FAULT, "the drone is in its emergency state: motors off"),
    Signal.ARRIVED_TO_STAY: (Severity.INFO, "arrived"),
    Signal.ARRIVED_TO_LOOK: (Severity.INFO, "arrived, looking"),
    Signal.ARRIVED_HOME: (Severity.INFO, "above the pad, landing"),
    Signal.LOOKED: (Severity.INFO, "looked long enough, coming home"),
    Signal.OVERDUE: (Severity.WARNING, "took too long"),
    Signal.BLOCKED: (Severity.WARNING, "the way stays blocked"),
    Signal.FORCED_DOWN: (Severity.WARNING, "landing for safety"),
}
"""How a change of phase is told."""


class Watch:
    """Follows one captain's errand."""

    def __init__(
        self,
        captain: Captain,
        limits: LimitsConfig,
        tolerance: float,
        paper: bool,
        lookout: Lookout,
    ) -> None:
        self._captain = captain
        self._limits = limits
        self._tolerance = tolerance
        self._paper = paper
        self._course = captain.course
        self._clocks = Clocks()
        self._late_since = -1.0
        self._lookout = lookout

    def step(self, scene: Scene, track: Track | None, facing: bool) -> list[Event]:
        """Lead the errand on.

        Args:
            scene: what is known.
            track: what was tracked in the last step, None while nothing was.
            facing: whether the heading is the wanted one.
        """
        captain = self._captain
        if captain.course is not self._course:
            self._course, self._clocks, track = captain.course, Clocks(), None
        near = track is not None and is_near(
            scene, track, self._tolerance, captain.errand, self._clocks, self._paper
        )
        self._clocks = self._clocks.after(
            scene.now, near, track is not None and track.finished, near and facing
        )
        events = self._acknowledge(scene)
        for signal in signals(
            captain.errand, captain.course, self._clocks, scene, self._limits, facing or self._paper
        ):
            before = captain.errand
            captain.errand = before.after(signal, scene.now)
            if captain.errand is not before:
                events.extend(self._entered(signal, before, scene))
        events.extend(self._late_landing(scene))
        return events

    def _entered(self, signal: Signal, before: Errand, scene: Scene) -> list[Event]:
        self._clocks = Clocks()
        severity, words = WORDS[signal]
        if before.phase is Phase.LANDING and signal is Signal.GROUNDED:
            words = "landed"
        elif signal is Signal.BLOCKED:
            words += (
                ": landing here" if self._captain.errand.phase is Phase.LANDING else ": coming home"
            )
        elif signal is Signal.OVERDUE:
            words = f"{before.phase.value} took too long"
        elif before.phase is Phase.IDLE and signal is Signal.AIRBORNE:
            severity, words = Severity.WARNING, "the drone is in the air without an order: holding"
        event = Event(scene.now, severity, signal.name.lower(), words)
        problem = self._follow_up(signal, before, scene)
        if not problem:
            return [event]
        if self._lookout.waits_instead(problem, scene):
            return [
                event,
                Event(scene.now, Severity.WARNING, "way_blocked", f"waiting here: {problem}"),
            ]
        self._captain.stay(scene)
        return [event, Event(scene.now, Severity.WARNING, "no_way", f"holding here: {problem}")]

    def _follow_up(self, signal: Signal, before: Errand, scene: Scene) -> str:
        """Give the new phase its course; return "" or why there is none."""
        captain, phase = self._captain, self._captain.errand.phase
        if phase is Phase.RETURNING:
            return captain.come_home(scene)
        if before.phase is Phase.TAKING_OFF and phase is Phase.HOLDING:
            return captain.depart(captain.errand.mission, scene)
        if phase in (Phase.IDLE, Phase.LANDING):
            captain.course = Course()
            captain.errand = replace(captain.errand, mission=STAY)
        elif phase is Phase.HOLDING and (
            captain.course.follower is None or signal is Signal.OVERDUE
        ):
            captain.stay(scene)
        return ""

    def _acknowledge(self, scene: Scene) -> list[Event]:
        errand, cut = self._captain.errand, scene.status is DroneStatus.EMERGENCY
        if not (errand.cutting or errand.resetting):
            return []
        if cut is errand.cutting:
            self._captain.errand = errand.released()
            return [
                Event(
                    scene.now,
                    Severity.INFO,
                    "acknowledged",
                    "motors are cut" if cut else "emergency left",
                )
            ]
        if scene.now - errand.pressed_at > (CUT_PATIENCE if errand.cutting else RESET_PATIENCE):
            self._captain.errand = errand.released()
            what = "motor cut" if errand.cutting else "reset"
            return [
                Event(
                    scene.now,
                    Severity.FAULT,
                    "not_acknowledged",
                    f"the drone did not acknowledge the {what}",
                )
            ]
        return []

    def _late_landing(self, scene: Scene) -> list[Event]:
        errand = self._captain.errand
        late = (
            errand.phase is Phase.LANDING
            and scene.now - errand.since > self._limits.landing_timeout
        )
        if not late or self._late_since == errand.since:
            return []
        self._late_since = errand.since
        text = (
            f"landing is not acknowledged after {self._limits.landing_timeout:.0f} s: still asking"
        )
        return [Event(scene.now, Severity.FAULT, "landing_late", text)]
