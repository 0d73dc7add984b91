"""The whole chain as one pure step: sightings, telemetry and orders in, one command out.

    see -> look around -> obey -> watch -> look ahead -> track -> accept -> steer -> judge

No clock, no wire, no thread: the same pilot flies hardware, the twin, a recording, and any number
    of simulated flights, and the
same inputs give the same outputs bit for bit.
"""

from __future__ import annotations

from math import inf, nan

from housefly.config.site import Site
from housefly.geometry import Vec2, distance, quaternion_from_euler
from housefly.messages import (
    Action,
    Behavior,
    Command,
    DroneStatus,
    Estimate,
    Event,
    Inputs,
    Obstacle,
    Order,
    OrderKind,
    Outputs,
    Phase,
    PlanAnswer,
    Pose,
    Reference,
    SafetyMode,
    Severity,
    Sighting,
    Telemetry,
)
from housefly.numeric import wrapped
from housefly.pilot.behavior.acceptor import PAPER_EPSILONS, Acceptor, Condition, conditions_of
from housefly.pilot.behavior.captain import Captain
from housefly.pilot.behavior.lookout import Lookout
from housefly.pilot.behavior.maneuver import Maneuver
from housefly.pilot.behavior.nose import YAW_SLEW, Nose, nose_after
from housefly.pilot.behavior.scene import Scene
from housefly.pilot.behavior.tracking import Track
from housefly.pilot.behavior.watch import Watch
from housefly.pilot.control.autopilot import Autopilot
from housefly.pilot.control.laws import acceleration
from housefly.pilot.control.steering import Aim, Where
from housefly.pilot.estimation.contracts import Estimator
from housefly.pilot.estimation.filter import PoseFilter
from housefly.pilot.estimation.paper_filter import PaperFilter
from housefly.pilot.navigator import RoomNavigator
from housefly.pilot.planning.furniture import TrackedFurniture
from housefly.pilot.safety.facts import Facts, Fence
from housefly.pilot.safety.gate import Gate, Verdict
from housefly.pilot.safety.notices import Notices
from housefly.pilot.safety.rules import CEILING_SLACK
from housefly.room.grid import OccupancyGrid, extent_of
from housefly.room.model import Room

LONGEST_TICK = 0.1
"""After a stall the references move on by no more than this [s]."""
MOST_REFUSALS = 100
"""No more refusals of obstacles are told and remembered than this."""
FLYING_PHASES = frozenset({Phase.OUTBOUND, Phase.LOOKING, Phase.HOLDING, Phase.RETURNING})
PHASE_ACTIONS = {
    Phase.IDLE: Action.IDLE,
    Phase.TAKING_OFF: Action.TAKE_OFF,
    Phase.LANDING: Action.LAND,
}
MOVING_BEHAVIORS = frozenset({Behavior.PATH_TRACKING, Behavior.HOVER})


class Pilot:
    """One drone's pilot; all its state is in the parts named in the constructor."""

    def __init__(
        self, site: Site, room: Room, grid: OccupancyGrid, maneuver: Maneuver | None = None
    ) -> None:
        self._site = site
        self._maneuver = maneuver
        self._paper = site.mode == "paper"
        self._navigator = RoomNavigator(site, room, grid)
        self._furniture = TrackedFurniture(site, room)
        self._filter = _estimator(site)
        self._captain = Captain(site.limits, self._navigator)
        tolerance = PAPER_EPSILONS[2] if self._paper else site.control.epsilon_position
        self._lookout = Lookout(self._captain, self._navigator)
        self._watch = Watch(self._captain, site.limits, tolerance, self._paper, self._lookout)
        self._autopilot = Autopilot(site)
        self._gate = Gate(
            site.limits, Fence(extent_of(grid), site.limits.height_max + CEILING_SLACK)
        )
        self._acceptor = Acceptor()
        self._home = room.home
        self._telemetry: Telemetry | None = None
        self._status = DroneStatus.UNKNOWN
        self._now = -inf
        self._nose = Nose()
        self._track: Track | None = None
        self._held_back = False
        self._notices = Notices()
        self._refused: set[str] = set()

    def plan(self, goal: Vec2, start: Vec2 | None = None) -> PlanAnswer:
        """Answer "how do I get there?" from a start [m], else from the drone, else from the pad."""
        estimate = self._filter.estimate(self._now)
        here = estimate.position[:2] if estimate else self._home
        return self._navigator.route(start or here, goal)

    def step(self, now: float, inputs: Inputs) -> Outputs:
        """Take in what happened and return what to do.

        Args:
            now: time [s]; a time before the last one counts as the last one.
            inputs: sightings since the last step, of the drone and tracked furniture, the newest
                telemetry, orders, obstacles.
        """
        now = max(now, self._now)
        dt = min(now - self._now, LONGEST_TICK)
        self._now = now
        self._hear(inputs.telemetry)
        events = self._see(inputs, now)
        events.extend(
            self._look_around(
                (*inputs.obstacles, *self._furniture.step(inputs.sightings, now)), now
            )
        )
        estimate = self._filter.estimate(now)
        scene = self._scene(now, estimate)
        events.extend(self._captain.obey(order, scene) for order in inputs.orders)
        events.extend(self._watch.step(scene, self._track, self._facing(estimate)))
        events.extend(self._lookout.step(scene, self._track))
        self._follow(estimate, dt)
        verdict = self._gate.judge(self._proposal(now, estimate), self._facts(scene))
        events.extend(self._notices.after(verdict, now))
        self._remember(now, verdict, estimate)
        return self._outputs(estimate, verdict, tuple(events))

    def _hear(self, telemetry: Telemetry | None) -> None:
        if telemetry is not None:
            self._telemetry = telemetry
            self._status = (
                self._status if telemetry.status is DroneStatus.UNKNOWN else telemetry.status
            )

    def _see(self, inputs: Inputs, now: float) -> list[Event]:
        """Hand the sightings to the filter; an order on the pad starts it anew.

        What a filter learned from a drone that stands still says nothing about the air, and so a
        flight depends on no more of the past than its own recording holds.
        """
        grounded = self._status is DroneStatus.LANDED
        events = list(self._filter.see(inputs.sightings, now, grounded))
        believed = self._filter.believed
        if (
            inputs.orders
            and grounded
            and self._captain.errand.phase is Phase.IDLE
            and believed is not None
        ):
            self._filter = _estimator(self._site)
            events.extend(self._filter.see((believed,), now, grounded))
        return events

    def _look_around(self, obstacles: tuple[Obstacle, ...], now: float) -> list[Event]:
        """Bring the map up to now; what is not believed is told once for each source and reason."""
        refused = [
            words for words in self._navigator.hear(obstacles, now) if words not in self._refused
        ]
        refused = refused[: MOST_REFUSALS - len(self._refused)]
        self._refused.update(refused)
        return [
            Event(now, Severity.WARNING, "obstacle_refused", f"obstacle refused: {words}")
            for words in refused
        ]

    def _scene(self, now: float, estimate: Estimate | None) -> Scene:
        heard = self._telemetry
        age = now - heard.received_at if heard else inf
        return Scene(
            now, self._status, heard.battery if heard else 0.0, age, estimate, self._gate.landing
        )

    def _facing(self, estimate: Estimate | None) -> bool:
        return (
            estimate is not None
            and abs(wrapped(self._nose.target - estimate.yaw)) < self._site.control.epsilon_yaw
        )

    # --- behavior: what to track, and the acceptor's state ---

    def _follow(self, estimate: Estimate | None, dt: float) -> None:
        """Move the reference on and let the acceptor choose its state."""
        if estimate is None or self._captain.errand.phase not in FLYING_PHASES:
            self._track, self._nose = None, Nose(self._nose.target)
            self._acceptor = self._acceptor.after(Condition.REST, self._now)
            return
        track = self._tracked(estimate, dt)
        self._track = track
        turn_max = inf if self._paper else YAW_SLEW * dt
        self._nose = nose_after(
            self._nose, self._wished_yaw(track, estimate), estimate.yaw, turn_max
        )
        errors = self._errors(track, estimate)
        conditions = conditions_of(self._acceptor, errors, self._site.control, self._paper)
        dwell = 0.0 if self._paper else self._site.control.dwell
        self._acceptor = self._acceptor.after(conditions, self._now, dwell)

    def _tracked(self, estimate: Estimate, dt: float) -> Track:
        course = self._captain.course
        if course.follower is None:
            return Track(course.hold or estimate.position[:2], yaw=course.hold_yaw)
        moving = self._acceptor.state in MOVING_BEHAVIORS and not self._held_back
        return course.follower.step(estimate.position[:2], moving, dt)

    def _wished_yaw(self, track: Track, estimate: Estimate) -> float:
        """Return the heading that the way or the errand wants [rad]; nan keeps the last."""
        wish = track.yaw
        if track.finished and not self._paper and self._captain.course.follower is not None:
            arrival = self._captain.errand.mission.arrival_yaw(estimate.position[:2])
            wish = wish if arrival is None else arrival
        return nan if wish is None else wish

    def _errors(self, track: Track, estimate: Estimate) -> tuple[float, float, float]:
        """Return errors of height [m], yaw [rad] and place [m]; the place is the path's end, in
        mode paper the waypoint.
        """
        x, y, z = estimate.position
        follower = self._captain.course.follower
        place = track.position if self._paper or follower is None else follower.goal
        yaw_error = wrapped(estimate.yaw - self._nose.target)
        return z - self._site.map.flight_height, yaw_error, distance((x, y), place)

    # --- control ---

    def _proposal(self, now: float, estimate: Estimate | None) -> Command:
        errand = self._captain.errand
        if errand.cutting or errand.resetting:
            return Command(Action.CUT if errand.cutting else Action.RESET)
        if errand.phase not in FLYING_PHASES:
            return Command(PHASE_ACTIONS[errand.phase])
        forecast = self._filter.forecast(now)
        if estimate is None or forecast is None or self._track is None:
            return Command(Action.HOVER)
        track = self._track
        aim = Aim(
            track.position,
            track.velocity,
            track.acceleration,
            self._site.map.flight_height,
            self._nose.reference,
        )
        where = Where(
            forecast.position,
            forecast.velocity,
            forecast.disturbance,
            estimate.position[2],
            estimate.yaw,
        )
        command = (
            self._autopilot.paper(self._acceptor.state, aim, where)
            if self._paper
            else self._autopilot.default(aim, where)
        )
        if self._maneuver is None or errand.phase is not Phase.HOLDING or errand.stopped:
            return command
        return self._maneuver.propose(now, estimate, command)

    # --- safety ---

    def _facts(self, scene: Scene) -> Facts:
        errand = self._captain.errand
        position = scene.estimate.position if scene.estimate else None
        return Facts(
            now=scene.now,
            status=scene.status,
            battery=scene.battery,
            pose_age=scene.pose_age,
            telemetry_age=scene.telemetry_age,
            position=position,
            stopped=errand.stopped,
            cutting=errand.cutting,
        )

    # --- memory and answer ---

    def _remember(self, now: float, verdict: Verdict, estimate: Estimate | None) -> None:
        """Tell the filter what was sent (it predicts with what left the gate, not with what was
        wished) and keep the verdict.
        """
        self._held_back = verdict.mode is not SafetyMode.NOMINAL
        command = verdict.command
        flown = command.action is Action.FLY and estimate is not None
        yaw = estimate.yaw if estimate else 0.0
        pushed: Vec2 = acceleration(command.setpoint.theta, command.setpoint.phi, yaw)
        self._filter.sent(now, pushed, flown)

    def _outputs(
        self, estimate: Estimate | None, verdict: Verdict, events: tuple[Event, ...]
    ) -> Outputs:
        track, errand = self._track, self._captain.errand
        return Outputs(
            command=verdict.command,
            estimate=estimate,
            reference=self._reference(track),
            behavior=self._acceptor.state,
            phase=errand.phase,
            safety=verdict.mode,
            goal_name=errand.mission.name,
            path=self._captain.course.path,
            waypoint=track.waypoint if track else 0,
            reason=verdict.reason or self._captain.course.waiting,
            events=events,
        )

    def _reference(self, track: Track | None) -> Reference | None:
        if track is None:
            return None
        (x, y), (vx, vy) = track.position, track.velocity
        return Reference((x, y, self._site.map.flight_height), (vx, vy, 0.0), self._nose.reference)


def warm_up(site: Site, room: Room, grid: OccupancyGrid) -> None:
    """Compile every numeric function that a pilot of this site calls, by flying a second on paper."""
    pilot = Pilot(site, room, grid)
    pose = Pose(
        (*room.home, site.map.flight_height), quaternion_from_euler(0.0, 0.0, room.home_yaw)
    )
    goal = next((place.name for place in room.places if place.name != "home"), "home")
    for tick in range(50):
        at = 0.02 * tick
        orders = (Order(OrderKind.GO, goal, issued_at=at),) if tick == 10 else ()
        sighting = Sighting(site.tracking.body, pose, at, at)
        chair = Obstacle("chair", (room.home[0] + 1e-3 * tick, room.home[1]), 0.1, seen_at=at)
        pilot.step(
            at,
            Inputs(
                (sighting,),
                Telemetry(at, DroneStatus.FLYING, 1.0),
                orders,
                (chair,) if tick > 20 else (),
            ),
        )
    pilot.plan(room.home)


def _estimator(site: Site) -> Estimator:
    if site.mode == "paper":
        return PaperFilter(site.control, site.tracking.body)
    return PoseFilter(site.drone, site.control, site.tracking.body)
