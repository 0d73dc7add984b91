"""The whole chain as one pure step: sightings, telemetry and orders in, one command out.

    estimate -> map -> mission -> gate's rules -> compiled step -> command

No clock, no wire, no thread: the same pilot flies hardware, the twin, a recording, and any number
of simulated flights, and the same inputs give the same outputs bit for bit. What is numbers runs in
``estimation.estimator`` and ``step``, which the batch of ``lab.experiments`` calls too; here are
words, events and the mission.
"""

from __future__ import annotations

from dataclasses import replace
from math import inf, nan

from housefly.geometry import Vec2
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Inputs, Outputs, Phase, Severity
from housefly.messages.obstacles import Obstacle
from housefly.messages.preflight import PreflightCheck
from housefly.messages.sensing import (
    AIRBORNE_STATUSES,
    DroneStatus,
    Estimate,
    Sighting,
    Telemetry,
)
from housefly.messages.steering import (
    Action,
    Behavior,
    Command,
    KnownMotion,
    PlanAnswer,
    Reference,
    SafetyMode,
)
from housefly.messages.words import Words
from housefly.numeric import boxed, wrapped
from housefly.pilot.behavior.braking import coasted
from housefly.pilot.behavior.mission import PeopleSilence, TrajectoryReference, VehicleStatus
from housefly.pilot.behavior.path_profile import NO_PATH, PathProfile
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.reported_status import ReportedStatus
from housefly.pilot.behavior.steered_landing import MOVES_MAX, SteeredLanding
from housefly.pilot.behavior.trajectory_progress import is_in_space
from housefly.pilot.behavior.way_home import WayHome
from housefly.pilot.contracts import Maneuver, Map, Missions, PilotSettings
from housefly.pilot.control.flow_hold import FlowHold, climb_to
from housefly.pilot.control.landing_aim import landing_drift
from housefly.pilot.estimation.consistency import NOTHING_KNOWN, TrackingConsistency
from housefly.pilot.estimation.dead_reckoning import ReckonedHeight, ReckonedPose
from housefly.pilot.estimation.estimation_report import (
    NOTHING_ESTIMATED,
    EstimationReport,
    estimation_report,
)
from housefly.pilot.estimation.estimator_state import PoseEstimate
from housefly.pilot.estimation.pose_estimator import PoseEstimator
from housefly.pilot.kept_place import TO_FLOOR, KeptPlace, known_motion, sinking
from housefly.pilot.safety.gate import Gate, GateAssessment, GateNotices, GateVerdict, gate_verdict
from housefly.pilot.safety.inputs import CRUISE_PHASES, GateInputs
from housefly.pilot.safety.limits import is_flown_in
from housefly.pilot.safety.tracking_rules import is_disproved
from housefly.pilot.step import (
    INITIAL_REPORT,
    INITIAL_STEP,
    NO_OVERRIDE,
    Guidance,
    Override,
    StepOutput,
    boxed_path_begun,
    boxed_step,
)

TICK_MAX = 0.1
"""After a stall the references move on by no more than this [s]."""
REFUSALS_MAX = 100
"""No more refusals of obstacles are told and remembered than this."""
POSE_LEAD_MAX = 0.3
"""A drone that does not take the time of a pose is told no farther ahead than this [s]."""
SLOW_FACTOR = 0.5
"""Share of the cruise speed of a drone that is to fly slowly."""
PHASE_ACTIONS = {
    Phase.IDLE: Action.IDLE,
    Phase.TAKING_OFF: Action.TAKE_OFF,
    Phase.LANDING: Action.LAND,
}
_BEHAVIORS = tuple(Behavior)
_NOWHERE = PoseEstimate(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Pilot:
    """One drone's pilot; ``assembly.make_pilot`` builds one for a site and a room."""

    def __init__(
        self,
        settings: PilotSettings,
        room_map: Map,
        missions: Missions,
        gate: Gate,
        maneuver: Maneuver | None = None,
    ) -> None:
        self._settings = settings
        self._params, self._boxed_params = settings.parameters, boxed(settings.parameters)
        self._map = room_map
        self._missions = missions
        self._gate = gate
        self._maneuver = maneuver
        self._notices = GateNotices()
        self._estimator: PoseEstimator | None = None
        self._boxed_step, self._stepped = boxed(INITIAL_STEP), INITIAL_REPORT
        self._profile: PathProfile = NO_PATH
        self._target: TrajectorySetpoint | None = None
        self._telemetry: Telemetry | None = None
        self._reported, self._sent, self._climb = ReportedStatus(), Command(Action.IDLE), 0.0
        self._now = -inf
        self._refused: set[Words] = set()
        self._vehicle: VehicleStatus | None = None
        self._way_home = WayHome(
            room_map.route, settings.home, self._params.speed, in_space=room_map.in_space
        )
        self._demand: Vec2 | None = None
        self._maneuvering = self._was_free = self._in_space = False
        self._height = settings.flight_height
        self._landing: SteeredLanding | None = None
        self._flow_hold: FlowHold | None = None
        self._kept: KeptPlace | None = None
        self._held = False
        self._reckoned_height: ReckonedHeight | None = None
        self._motion: KnownMotion | None = None
        self._seen: tuple[Sighting | None, Estimate | None] = (None, None)
        self._has_sonar = settings.airframe.sonar is not None

    @property
    def consistency(self) -> TrackingConsistency:
        """How well tracking agrees with the drone's own report, as of the last step."""
        return self._estimator.monitor.consistency(self._now) if self._estimator else NOTHING_KNOWN

    @property
    def estimation(self) -> EstimationReport:
        """What the estimator found out besides the pose, as of the last step."""
        estimator = self._estimator
        if estimator is None:
            return NOTHING_ESTIMATED
        return estimation_report(estimator.state, estimator.history, self._params.estimator)

    @property
    def demanded_acceleration(self) -> Vec2 | None:
        """What the control law demanded in the last step, before any limit [m/s^2], or None."""
        return self._demand

    @property
    def known_motion(self) -> KnownMotion | None:
        """How the drone moves, as of the last step, should this pilot fall silent; or None."""
        return self._motion

    @property
    def external_pose(self) -> Sighting | None:
        """Where tracking saw the drone, for one that wants to be told; None if in doubt.

        One that does not take the time of a pose is told where it is by now: its place moved on,
        its attitude as it was seen.
        """
        (seen, estimate), able = self._seen, self._settings.airframe.capabilities
        if seen is None or estimate is None or able.external_pose_stamped:
            return seen
        age = min(max(estimate.at - seen.captured_at, 0.0), POSE_LEAD_MAX)
        x, y, z = (p + age * v for p, v in zip(seen.pose.position, estimate.velocity, strict=True))
        return replace(seen, pose=replace(seen.pose, position=(x, y, z)))

    @property
    def origin_confirmed(self) -> bool:
        """Whether tracking has shown the drone on its pad, or was found to agree with the map."""
        return self._missions.origin_confirmed

    @property
    def origin_revoked(self) -> bool:
        """Whether tracking was found lying, and has not shown the drone on its pad since."""
        return self._missions.origin_revoked

    def plan(self, goal: Vec2, start: Vec2 | None = None) -> PlanAnswer:
        """Answer "how do I get there?" from a start [m], else from the drone, else from the pad."""
        found = self._estimator.estimate(self._now) if self._estimator else None
        here = found[1].position[:2] if found else self._settings.home
        return self._map.route(start or here, goal)

    def preflight(self) -> tuple[PreflightCheck, ...]:
        """Return what the pre-flight checks find, as of the last step; nothing before the first."""
        return self._missions.preflight(self._vehicle) if self._vehicle else ()

    def step(self, now: float, inputs: Inputs) -> Outputs:
        """Take in what happened and return what to do.

        Args:
            now: time [s]; a time before the last one counts as the last one.
            inputs: sightings since the last step, of the drone and tracked furniture, the newest
                telemetry, orders, obstacles.
        """
        now = max(now, self._now)
        dt = min(now - self._now, TICK_MAX)
        self._now = now
        self._receive(inputs.telemetry)
        events = self._see(inputs, now)
        events.extend(self._update_map(inputs.obstacles, inputs.sightings, now))
        here, estimate = self._estimated(now)
        vehicle = self._vehicle = self._vehicle_status(now, estimate, inputs)
        facing = self._is_facing(estimate)
        events.extend(self._missions.update(inputs.orders, vehicle, self._target, facing))
        verdict = self._command(self._gate_inputs(vehicle, inputs.late), vehicle, here, dt)
        events.extend(self._notices.update(verdict, now))
        return self._outputs(estimate, verdict, tuple(events))

    def _receive(self, telemetry: Telemetry | None) -> None:
        if telemetry is not None:
            self._telemetry = telemetry
            ends = self._sent.action in (Action.LAND, Action.CUT)
            self._reported = self._reported.updated(telemetry, told_to_end=ends)

    # --- estimation ---

    def _see(self, inputs: Inputs, now: float) -> list[Event]:
        """Hand the sightings to the estimator; an order on the pad starts it anew.

        What a filter learned from a drone that stands still says nothing about the air, and so a
        flight depends on no more of the past than its own recording holds.
        """
        grounded = self._reported.status is DroneStatus.LANDED
        estimator = self._estimator or self._new_estimator(now)
        estimator.monitor.feel(inputs.telemetry, self._reported.status, estimator.climb_rate)
        events = list(estimator.update(inputs.sightings, now, grounded))
        accepted, phase = estimator.accepted, self._missions.state.phase
        is_idle = grounded and phase is Phase.IDLE and not estimator.monitor.is_doubtful
        if inputs.orders and is_idle and accepted is not None:
            estimator = self._new_estimator(now)
            estimator.monitor.feel(inputs.telemetry, self._reported.status, 0.0)
            events.extend(estimator.update((accepted,), now, grounded))
        self._estimator = estimator
        return events

    def _new_estimator(self, now: float) -> PoseEstimator:
        settings = self._settings
        return PoseEstimator(
            self._params.estimator,
            settings.body,
            now,
            settings.airframe,
            drag=settings.drag,
            odometry_error=settings.odometry_error,
            trusting=not settings.guarded,
        )

    def _estimated(self, now: float) -> tuple[PoseEstimate, Estimate | None]:
        assert self._estimator is not None
        return self._estimator.estimate(now) or (_NOWHERE, None)

    # --- map and mission ---

    def _update_map(
        self, obstacles: tuple[Obstacle, ...], sightings: tuple[Sighting, ...], now: float
    ) -> list[Event]:
        """Bring the map up to now; a refused obstacle is told once for each source and reason."""
        refused = [
            words
            for words in self._map.update(obstacles, sightings, now)
            if words not in self._refused
        ]
        refused = refused[: REFUSALS_MAX - len(self._refused)]
        self._refused.update(refused)
        return [
            Event(
                now,
                Severity.WARNING,
                EventCode.OBSTACLE_REFUSED,
                Words("obstacle refused: {why}", why=words),
            )
            for words in refused
        ]

    def _vehicle_status(
        self, now: float, estimate: Estimate | None, inputs: Inputs
    ) -> VehicleStatus:
        telemetry, known = self._telemetry, self.consistency
        return VehicleStatus(
            now=now,
            status=self._reported.status,
            battery=telemetry.battery if telemetry else 0.0,
            telemetry_age=now - telemetry.received_at if telemetry else inf,
            estimate=estimate,
            landing_forced=self._gate.landing,
            return_wanted=self._gate.returning,
            standing_height=self._gate.standing_height,
            gauge_stuck=self._gate.gauge_stuck,
            maneuvering=self._maneuvering,
            held=self._held,
            reference=self._trajectory_reference(),
            telemetry=telemetry,
            consistency=known,
            tracking_disproved=self._reported.status in AIRBORNE_STATUSES and is_disproved(known),
            origin_known=inputs.origin_known,
            silence=PeopleSilence(now - inputs.people_seen_at, self._settings.people_silence),
            reckoned=self._reckoned(now),
            landing_waits=self._gate.landing_waits,
        )

    def _reckoned(self, now: float) -> ReckonedPose | None:
        """Return where the drone is by its own motion, while the gate leaves it to that."""
        is_flying = self._reported.status is DroneStatus.FLYING
        if self._estimator is None or not (self._held and is_flying):
            return None
        reckoned = self._estimator.monitor.reckoned(now)
        before, self._reckoned_height = self._reckoned_height, None
        if reckoned is None or not self._gate.landing_waits:
            return reckoned
        (x, y, z), gains, told = reckoned.position, self._params.gains, self._telemetry
        height = self._reckoned_height = (before or ReckonedHeight(now, z)).advanced(
            now,
            self._climb,
            gains.climb_lag,
            gains.sink_gain,
            told.height + self._gate.standing_height if told and self._has_sonar else nan,
        )
        return replace(reckoned, position=(x, y, height.height))

    def _trajectory_reference(self) -> TrajectoryReference | None:
        if not self._in_space or self._target is None:
            return None
        return TrajectoryReference(self._target, self._stepped.yaw_reference, self._stepped.scale)

    def _is_facing(self, estimate: Estimate | None) -> bool:
        if estimate is None:
            return False
        turn = wrapped(self._stepped.yaw_target - estimate.yaw)
        return abs(turn) < self._settings.facing_tolerance

    # --- the compiled step ---

    def _command(
        self, inputs: GateInputs, vehicle: VehicleStatus, here: PoseEstimate, dt: float
    ) -> GateVerdict:
        assert self._estimator is not None
        now, state = vehicle.now, self._missions.state
        assessment = self._gate.assess(inputs)
        guidance = self._guidance(now, vehicle.estimate, assessment)
        blind = self._blind_override(now, assessment)
        override = blind or self._override(now, vehicle.estimate)
        self._stepped, output = boxed_step(
            self._boxed_step,
            self._estimator.box,
            self._estimator.history,
            self._boxed_params,
            here,
            guidance,
            self._profile,
            override,
            assessment.severity,
            assessment.airborne and not state.resetting,
            now,
            dt,
        )
        self._target = output.target if guidance.active else None
        self._demand = (output.asked.ax, output.asked.ay) if output.flying else None
        action = Action.FLY if blind else self._action(output, guidance)
        verdict = gate_verdict(action, output.command, assessment, output.formed)
        self._climb = output.command.vz if verdict.command.action is Action.FLY else 0.0
        self._sent, self._motion = verdict.command, self._known_motion(here, assessment)
        seen = self._estimator.accepted if assessment.knows_place else None
        self._seen = seen, vehicle.estimate
        is_off = assessment.held or assessment.waits
        self._held = is_off or not is_flown_in(self._stepped.gate)
        self._maneuvering, self._height = override.active and not blind, output.target.z
        self._in_space = guidance.active and guidance.following and is_in_space(self._profile)
        return verdict

    def _known_motion(self, here: PoseEstimate, assessment: GateAssessment) -> KnownMotion | None:
        if self._params.is_paper or self._estimator is None or not assessment.airborne:
            return None
        push = self._estimator.disturbance
        return known_motion(here, push, assessment.knows_place, assessment.knows_speed)

    def _guidance(
        self, now: float, estimate: Estimate | None, assessment: GateAssessment
    ) -> Guidance:
        """Return what to track; a new path begins at its start."""
        landing = self._steered_landing(now, estimate, assessment)
        if landing is not None:
            return landing
        guidance = self._mission_guidance(estimate, assessment)
        if estimate is None or self._params.is_paper or not (assessment.kept and guidance.active):
            self._kept = None
            return guidance
        kept = self._kept = self._kept or KeptPlace.of(
            estimate, self._settings.airframe.braking.coast_time
        )
        return kept.guidance(guidance)

    def _mission_guidance(self, estimate: Estimate | None, assessment: GateAssessment) -> Guidance:
        task, mission = self._missions.task, self._missions.state
        active = estimate is not None and mission.phase in CRUISE_PHASES
        x, y = estimate.position[:2] if estimate else (0.0, 0.0)
        arrival_yaw: float | None = None
        if active and estimate is not None and task.profile is not None:
            if task.profile is not self._profile:
                self._profile = task.profile
                boxed_path_begun(self._boxed_step, self._boxed_params, estimate.yaw)
            arrival_yaw = mission.mission.arrival_yaw((x, y))
        hold_x, hold_y = task.hold or (x, y)
        if task.height is not None:
            hold_x, hold_y = self._landing_aim((hold_x, hold_y))
        return Guidance(
            active=active,
            following=task.profile is not None,
            x=hold_x,
            y=hold_y,
            yaw=task.hold_yaw,
            arrival_yaw=nan if arrival_yaw is None else arrival_yaw,
            height=self._settings.flight_height if task.height is None else task.height,
            speed_factor=0.0 if task.halted else self._speed_factor(assessment),
        )

    def _speed_factor(self, assessment: GateAssessment) -> float:
        """Return the share of the cruise speed, or of a trajectory's own, to fly at."""
        return min(self._missions.speed_factor, SLOW_FACTOR if self._is_slow(assessment) else 1.0)

    def _steered_landing(
        self, now: float, estimate: Estimate | None, assessment: GateAssessment
    ) -> Guidance | None:
        """Return where to sink for a landing that the gate wants and the pilot may steer."""
        is_descent = assessment.mode is SafetyMode.DESCEND and assessment.airborne
        if estimate is None or self._params.is_paper or not (assessment.steered or is_descent):
            self._landing = None
            return None
        if not assessment.knows_motion:  # braked by a mirrored velocity it would gather speed
            self._landing = None
            return None
        here, height = estimate.position[:2], estimate.position[2]
        if not assessment.knows_place:
            return sinking(estimate)
        landing = self._landing = self._landing_now(now, estimate, assessment)
        lowest = TO_FLOOR if assessment.to_floor else self._settings.sinks_to
        x, y = landing.setpoint(now)
        if not assessment.to_floor:
            x, y = self._landing_aim((x, y))
        return Guidance(
            active=True,
            following=False,
            x=x,
            y=y,
            yaw=estimate.yaw,
            arrival_yaw=nan,
            height=landing.height_setpoint(now, here, height, lowest),
            speed_factor=1.0,
        )

    def _landing_now(
        self, now: float, estimate: Estimate, assessment: GateAssessment
    ) -> SteeredLanding:
        """Return the landing; where a person or the mission asked for it, it is where it is."""
        landing, here, height = self._landing, estimate.position[:2], estimate.position[2]
        is_ordered = assessment.mode is not SafetyMode.LAND or self._missions.state.stopped
        if landing is None:
            rest = coasted(here, estimate.velocity[:2], self._settings.airframe.braking.coast_time)
            beside = None if is_ordered else self._map.clear_floor(here, height)
            return SteeredLanding(here if beside else rest, height, now, beside or rest)
        may_move = landing.moves < MOVES_MAX and landing.sinks(now, here)
        found = self._missions.found_below(self._vehicle) if may_move and self._vehicle else ()
        if not found:
            return landing
        beside = self._map.clear_floor(here, height, found)
        return landing.moved(here, now, beside) if beside else landing

    def _landing_aim(self, spot: Vec2) -> Vec2:
        """Return where to steer, so that the drone's own last bit ends on the spot [m]."""
        height = self._settings.drifts_from
        if height <= 0.0 or self._estimator is None:
            return spot
        push = self._estimator.disturbance
        brake = self._params.estimator.model.hover_drag
        x, y = landing_drift(push, height, brake, self._settings.airframe)
        return spot[0] - x, spot[1] - y

    def _blind_override(self, now: float, assessment: GateAssessment) -> Override | None:
        """Return the setpoint that holds a drone without tracking above what stands below."""
        plan = self._missions.blind_landing
        if plan.here is None or not assessment.waits:
            self._flow_hold = None
            return None
        (x, y, _), (vx, vy) = plan.here.position, plan.here.velocity
        error = plan.target[0] - x, plan.target[1] - y
        is_moving = any(plan.velocity)
        hold = (self._flow_hold or FlowHold(now)).pushed((0.0, 0.0) if is_moving else error, now)
        self._flow_hold, drag = hold, self._params.gains.drag
        setpoint = hold.setpoint(
            error,
            (plan.velocity[0] - vx, plan.velocity[1] - vy),
            (drag * plan.velocity[0], drag * plan.velocity[1]),
            climb_to(plan.height, plan.here.position, plan.may_sink),
            plan.here.yaw,
            self._params.gains.gain,
            self._params.gains.tilt_max,
        )
        return Override(True, setpoint.theta, setpoint.phi, setpoint.vz, setpoint.yaw_rate)

    def _override(self, now: float, estimate: Estimate | None) -> Override:
        """Return the setpoint of the maneuver, while the drone holds a place."""
        mission = self._missions.state
        if self._maneuver is None or estimate is None or mission.phase is not Phase.HOLDING:
            return NO_OVERRIDE
        if mission.stopped or mission.cutting or mission.resetting:
            return NO_OVERRIDE
        setpoint = self._maneuver.propose(now, estimate)
        if setpoint is None:
            return NO_OVERRIDE
        return Override(True, setpoint.theta, setpoint.phi, setpoint.vz, setpoint.yaw_rate)

    def _action(self, output: StepOutput, guidance: Guidance) -> Action:
        """Return what the pilot wants; in the paper's hover it leaves the drone to itself."""
        mission = self._missions.state
        if mission.cutting or mission.resetting:
            return Action.CUT if mission.cutting else Action.RESET
        if not guidance.active and mission.phase not in CRUISE_PHASES:
            return PHASE_ACTIONS[mission.phase]
        return Action.FLY if self._target is not None and output.flying else Action.HOVER

    @staticmethod
    def _is_slow(assessment: GateAssessment) -> bool:
        return any(rule.mode is SafetyMode.SLOW for rule in assessment.broken)

    @property
    def _is_flown(self) -> bool:
        """Whether control flew the drone along its reference in the last step."""
        return self._sent.action is Action.FLY and self._kept is None

    def _gate_inputs(self, vehicle: VehicleStatus, late: float) -> GateInputs:
        mission, estimate = self._missions.state, vehicle.estimate
        is_free = self._maneuvering or self._missions.is_yielding
        # The reference of the last step counts: one set for making way is no place to be at.
        is_tracking = self._target is not None and not (is_free or self._was_free)
        self._was_free = is_free
        if vehicle.place is not None and vehicle.status in AIRBORNE_STATUSES:
            self._way_home.update(vehicle.place, vehicle.now)
        return GateInputs(
            now=vehicle.now,
            status=vehicle.status,
            battery=vehicle.battery,
            pose_age=vehicle.pose_age,
            telemetry_age=vehicle.telemetry_age,
            position=estimate.position if estimate else None,
            stopped=mission.stopped,
            cutting=mission.cutting,
            phase=mission.phase,
            velocity=estimate.velocity if estimate else None,
            yaw=estimate.yaw if estimate else nan,
            reference=self._reference() if is_tracking and not self._params.is_paper else None,
            flight_height=self._height,
            height_follows=self._in_space,
            flown=self._sent.asked if self._is_flown else None,
            telemetry=vehicle.telemetry,
            consistency=vehicle.consistency,
            late=late,
            silence=vehicle.silence,
            home_time=self._way_home.duration,
            has_way_home=self._way_home.exists,
            landing_blocker=self._missions.blind_landing.fault,
            missing_lean=self._estimator.monitor.lean.missing(vehicle.now)
            if self._estimator
            else None,
            steers=not self._params.is_paper,
        )

    # --- answer ---

    def _outputs(
        self, estimate: Estimate | None, verdict: GateVerdict, events: tuple[Event, ...]
    ) -> Outputs:
        mission, task, target = self._missions.state, self._missions.task, self._target
        last = len(task.path.waypoints) - 1 if task.path else 0
        return Outputs(
            command=verdict.command,
            estimate=estimate,
            reference=self._reference(),
            behavior=_BEHAVIORS[self._stepped.acceptor],
            phase=mission.phase,
            safety=verdict.mode,
            goal_name=mission.mission.name,
            path=task.path,
            waypoint=min(target.waypoint, last) if target else 0,
            reason=verdict.reason or task.waiting,
            events=events,
            warnings=self._warnings(verdict, task.waiting),
            clears=verdict.clears,
            answers=self._missions.answers,
        )

    @staticmethod
    def _warnings(verdict: GateVerdict, waiting: Words) -> tuple[Words, ...]:
        words = (verdict.reason, *(rule.words for rule in verdict.broken), waiting)
        return tuple(dict.fromkeys(filter(None, words)))

    def _reference(self) -> Reference | None:
        if self._target is None:
            return None
        target, height = self._target, self._height
        position, velocity = (target.x, target.y, height), (target.vx, target.vy, target.vz)
        return Reference(position, velocity, self._stepped.yaw_reference)
