"""Obeys orders: looks the response up, asks permission and the way, and changes the errand. Every
refusal is told in words.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from housefly.config.site import LimitsConfig
from housefly.geometry import Vec2
from housefly.messages import (
    DroneStatus,
    Event,
    Order,
    OrderKind,
    Path,
    Phase,
    PlanAnswer,
    Severity,
)
from housefly.pilot.behavior.errand import ORDERS, STAY, Errand, Mission, Response
from housefly.pilot.behavior.navigator import Follower, Navigator
from housefly.pilot.behavior.permission import Circumstances, refusal
from housefly.pilot.behavior.scene import Scene

COAST = 0.4
"""A drone told to stay is held where it comes to rest: this much time ahead at its present speed
[s].
"""


@dataclass(frozen=True, slots=True)
class Course:
    """What the drone tracks.

    Attributes:
        follower: of the path in use, None while holding a place.
        path: the path in use or in prospect, for people.
        duration: expected flight time on it [s].
        hold: place to stay at [m], None to stay where the drone is.
        hold_yaw: heading to keep there [rad].
        waiting: why it waits for the way to become free, in words; "" when it does not.
        since: since when it waits [s].
    """

    follower: Follower | None = None
    path: Path | None = None
    duration: float = 0.0
    hold: Vec2 | None = None
    hold_yaw: float = 0.0
    waiting: str = ""
    since: float = 0.0


class Captain:
    """Owns the errand and the course."""

    def __init__(self, limits: LimitsConfig, navigator: Navigator) -> None:
        self._limits = limits
        self._navigator = navigator
        self.errand = Errand()
        self.course = Course()
        self._handlers: dict[Response, Callable[[Order, Scene], str]] = {
            Response.START: self._start,
            Response.LATER: self._start,
            Response.DEPART: self._set_off,
            Response.HOLD: self._hold,
            Response.LAND: self._land,
            Response.STOP: self._stop,
            Response.RESUME: self._resume,
            Response.CUT: self._cut,
            Response.RESET: self._reset,
        }

    def obey(self, order: Order, scene: Scene) -> Event:
        """Carry out an order or refuse it, and say so."""
        response = ORDERS[order.kind][self.errand.phase]
        circumstances = Circumstances(
            age=scene.now - order.issued_at,
            response=response,
            stopped=self.errand.stopped,
            landing_forced=scene.landing_forced,
            status=scene.status,
            battery=scene.battery,
            telemetry_age=scene.telemetry_age,
            pose_age=scene.pose_age,
        )
        reason = refusal(order, circumstances, self._limits) or self._handlers[response](
            order, scene
        )
        asked = " ".join(filter(None, (order.kind.value.replace("_", " "), order.place)))
        if reason:
            return Event(scene.now, Severity.WARNING, "order_refused", f"{asked} refused: {reason}")
        by = f" by {order.sender}" if order.sender else ""
        return Event(scene.now, Severity.INFO, "order_accepted", f"{asked}{by}: {response.value}")

    def depart(self, mission: Mission, scene: Scene) -> str:
        """Set off on a mission from where the drone is; return "" or why there is no way."""
        answer = self._route(mission, scene)
        if isinstance(answer, str):
            return answer
        yaw = scene.estimate.yaw if scene.estimate else 0.0
        if answer is None or answer.path is None:
            self.stay(scene)
            return ""
        self.course = Course(
            self._navigator.follower(answer.path, yaw), answer.path, answer.duration
        )
        phase = Phase.RETURNING if mission.kind is OrderKind.HOME else Phase.OUTBOUND
        self.errand = self.errand.entering(phase, scene.now, mission)
        return ""

    def come_home(self, scene: Scene) -> str:
        """Set off for home; return "" or why there is no way."""
        return self.depart(self._navigator.home(), scene)

    def stay(self, scene: Scene) -> None:
        """Hold the place where the drone comes to rest."""
        self.course = self._here(scene)
        self.errand = self.errand.entering(Phase.HOLDING, scene.now, STAY)

    def wait(self, why: str, scene: Scene, mission: Mission | None = None) -> None:
        """Hold the place where the drone comes to rest until the way is free; the errand stays what
        it is, or turns to a mission.

        Args:
            why: in words, for people.
            scene: where the drone is.
            mission: what to wait for, when it is another than that under way.
        """
        self.course = replace(
            self._here(scene), waiting=why, since=scene.now, duration=self.course.duration
        )
        if mission is not None:
            phase = Phase.RETURNING if mission.kind is OrderKind.HOME else Phase.OUTBOUND
            self.errand = self.errand.entering(phase, scene.now, mission)

    def go_around(self, scene: Scene) -> str:
        """Plan again from where the drone is, in the phase that it is in; return "" or why there is
        no way.
        """
        answer = self._route(self.errand.mission, scene)
        if isinstance(answer, str):
            return answer
        if answer is None or answer.path is None or scene.estimate is None:
            return "there is nowhere to go"
        follower = self._navigator.follower(answer.path, scene.estimate.yaw)
        self.course = Course(follower, answer.path, max(answer.duration, self.course.duration))
        return ""

    def _here(self, scene: Scene) -> Course:
        if scene.estimate is None:
            return Course()
        (x, y, _), (vx, vy, _) = scene.estimate.position, scene.estimate.velocity
        return Course(hold=(x + COAST * vx, y + COAST * vy), hold_yaw=scene.estimate.yaw)

    def _route(self, mission: Mission, scene: Scene) -> PlanAnswer | str | None:
        """Return the way, None when the mission needs none, or in words why there is none."""
        if mission.goal is None:
            return None
        if scene.place is None:
            return "tracking has not seen the drone yet"
        answer = self._navigator.route(scene.place, mission.goal)
        if answer.path is not None:
            return answer
        near = (
            f"; nearest free place: ({answer.suggestion[0]:.2f}, {answer.suggestion[1]:.2f}) m"
            if answer.suggestion
            else ""
        )
        return answer.reason + near

    def _start(self, order: Order, scene: Scene) -> str:
        mission = self._navigator.mission(order)
        if isinstance(mission, str):
            return mission
        answer = self._route(mission, scene)
        if isinstance(answer, str):
            return answer
        self.course = Course(path=answer.path if answer else None)
        since = self.errand.since if self.errand.phase is Phase.TAKING_OFF else scene.now
        self.errand = self.errand.entering(Phase.TAKING_OFF, since, mission)
        return ""

    def _set_off(self, order: Order, scene: Scene) -> str:
        mission = self._navigator.mission(order)
        return mission if isinstance(mission, str) else self.depart(mission, scene)

    def _hold(self, order: Order, scene: Scene) -> str:
        if self.errand.phase is Phase.TAKING_OFF:
            self.errand, self.course = replace(self.errand, mission=STAY), Course()
        else:
            self.stay(scene)
        return ""

    def _land(self, order: Order, scene: Scene) -> str:
        if self.errand.phase is not Phase.LANDING:
            self.errand, self.course = (
                self.errand.entering(Phase.LANDING, scene.now, STAY),
                Course(),
            )
        return ""

    def _stop(self, order: Order, scene: Scene) -> str:
        self.errand = self.errand.stopping(scene.now, scene.status is DroneStatus.LANDED)
        self.course = self._here(scene) if self.errand.phase is Phase.HOLDING else Course()
        return ""

    def _resume(self, order: Order, scene: Scene) -> str:
        if self.errand.stopped:
            self.errand = replace(self.errand, stopped=False)
            self.course = self._here(scene) if self.errand.phase is Phase.HOLDING else self.course
        return ""

    def _cut(self, order: Order, scene: Scene) -> str:
        self.errand = self.errand.pressing(scene.now, cut=True)
        return ""

    def _reset(self, order: Order, scene: Scene) -> str:
        self.errand = self.errand.pressing(scene.now, cut=False)
        return ""
