"""One tick of the pilot as one compiled composition: from the estimate to the limited command.

    estimator -> path or trajectory -> yaw reference -> acceptor -> control -> gate -> estimator

The live pilot calls ``step_commanded`` once a tick, the batch once a tick for each of thousands of
drones. Sightings go in before, by ``estimator_updated``; between the two the mission decides what
to track, which is words and tables and not numbers.
"""

from __future__ import annotations

from math import inf, isfinite, nan, sqrt
from typing import NamedTuple

from housefly.numeric import CompiledBox, compiled, compiled_with_arrays, wrapped
from housefly.pilot.behavior.acceptor import (
    REST,
    Acceptor,
    AcceptorState,
    Tolerances,
    acceptor_advanced,
    printed_conditions,
    steady_conditions,
)
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.path_progress import (
    PathProgress,
    TrajectorySetpoint,
    at_height,
    progress_advanced,
    progress_headed,
    setpoint_at,
    standing_setpoint,
)
from housefly.pilot.behavior.trajectory_progress import (
    TRAJECTORY_START,
    is_in_space,
    trajectory_advanced,
    trajectory_setpoint,
)
from housefly.pilot.behavior.waypoints import paper_heading, waypoint_advanced, waypoint_setpoint
from housefly.pilot.behavior.yaw_reference import (
    YAW_REFERENCE_RATE,
    YawReference,
    yaw_reference_advanced,
)
from housefly.pilot.control.feed_forward import feed_forward_reference, tilt_lead
from housefly.pilot.control.forms import (
    NOT_FORMED,
    TILTS,
    FormCode,
    FormedCommand,
    FormModel,
    place_asked,
    velocity_asked,
)
from housefly.pilot.control.laws import acceleration
from housefly.pilot.control.steering import (
    AT_REST,
    ControlOutput,
    ControlReference,
    Gains,
    control_output,
    paper_control_output,
)
from housefly.pilot.estimation.delay_filter import CommandHistory
from housefly.pilot.estimation.estimator import (
    control_state,
    estimator_commanded,
)
from housefly.pilot.estimation.estimator_state import (
    EstimatorParameters,
    EstimatorState,
    PoseEstimate,
)
from housefly.pilot.planning.trajectory.time_scale import TimeScale
from housefly.pilot.safety.limits import CommandLimits, GatedCommand, gated, is_flown_in


class PilotParameters(NamedTuple):
    """What the compiled step needs of a site.

    Attributes:
        is_paper: mode paper; else mode default.
        estimator: kind, model and noises.
        tolerances: of the acceptor.
        gains: of the control laws.
        limits: of the last gate.
        speed: wanted along a path [m/s].
        form: how the drone is steered.
    """

    is_paper: bool
    estimator: EstimatorParameters
    tolerances: Tolerances
    gains: Gains
    limits: CommandLimits
    speed: float
    form: FormModel = TILTS


class StepState(NamedTuple):
    """What one tick leaves for the next, besides the estimator's own state.

    Attributes:
        progress: along the path.
        yaw: wanted headings.
        acceptor: the finite state acceptor.
        gate: the ``SafetyModeCode`` found last.
        scale: how far a trajectory in space has been flown.
    """

    progress: PathProgress
    yaw: YawReference
    acceptor: Acceptor
    gate: int
    scale: TimeScale


class Guidance(NamedTuple):
    """What the mission wants in one tick.

    Attributes:
        active: control flies the drone.
        following: along the path; else it holds a place.
        x, y, yaw: the place [m] and heading [rad] to hold.
        arrival_yaw: heading at the end of the path [rad]; nan keeps the path's.
        height: z_ref [m]; a trajectory in space has its own.
        speed_factor: share of the cruise speed to fly at, 0 to 1; 0 stops on the trajectory.
        kept: the place is kept although a path is followed: its reference comes to rest.
    """

    active: bool
    following: bool
    x: float
    y: float
    yaw: float
    arrival_yaw: float
    height: float
    speed_factor: float
    kept: bool = False


class Override(NamedTuple):
    """A setpoint that takes the place of what control asks, where ``active``."""

    active: bool
    theta: float
    phi: float
    vz: float
    yaw_rate: float


class StepOutput(NamedTuple):
    """What one tick decides.

    Attributes:
        target: the reference.
        asked: by control.
        flying: control flies the drone; else it leaves it to its own hover.
        command: what leaves the gate.
        formed: the same as a drone is asked for it that is not steered by tilt.
    """

    target: TrajectorySetpoint
    asked: ControlOutput
    flying: bool
    command: GatedCommand
    formed: FormedCommand


class StepReport(NamedTuple):
    """What the pilot's words and tables need of a state that stays with the compiled code.

    Attributes:
        acceptor: state of the finite state acceptor.
        gate: the ``SafetyModeCode`` found last.
        yaw_target: wanted heading [rad].
        yaw_reference: heading to ask for [rad].
        scale: how far a trajectory in space has been flown.
    """

    acceptor: int
    gate: int
    yaw_target: float
    yaw_reference: float
    scale: TimeScale


NO_OVERRIDE = Override(False, 0.0, 0.0, 0.0, 0.0)
INITIAL_STEP = StepState(
    progress=PathProgress(s=0.0, v=0.0, a=0.0, leg=0, yaw=nan),
    yaw=YawReference(0.0, nan),
    acceptor=Acceptor(0, 0.0),
    gate=0,
    scale=TRAJECTORY_START,
)
"""Before the first tick."""
INITIAL_REPORT = StepReport(
    acceptor=INITIAL_STEP.acceptor.state,
    gate=INITIAL_STEP.gate,
    yaw_target=INITIAL_STEP.yaw.target,
    yaw_reference=INITIAL_STEP.yaw.reference,
    scale=INITIAL_STEP.scale,
)
"""The same, reported."""


@compiled
def progress_started(params: PilotParameters, yaw: float) -> PathProgress:
    """Return the progress at the beginning of a path, at a heading [rad]."""
    heading = paper_heading(yaw) if params.is_paper else nan
    return PathProgress(s=0.0, v=0.0, a=0.0, leg=0, yaw=heading)


@compiled
def step_commanded(
    state: StepState,
    estimator: EstimatorState,
    history: CommandHistory,
    params: PilotParameters,
    here: PoseEstimate,
    guidance: Guidance,
    profile: PathProfile,
    override: Override,
    mode: int,
    airborne: bool,
    now: float,
    dt: float,
) -> tuple[StepState, EstimatorState, StepOutput]:
    """Return states and decisions of one tick.

    Args:
        state: of the last tick.
        estimator: advanced to now.
        history: the commands given, which the estimator refers to.
        params: of the pilot.
        here: the estimate for now; only its yaw counts while the guidance is not active.
        guidance: what the mission wants.
        profile: the path in use; any one while none is followed.
        override: what takes the place of control.
        mode: the ``SafetyModeCode`` that the rules of the gate found.
        airborne: the propellers carry the drone.
        now: [s].
        dt: how far references move on [s].
    """
    lead = 0.0
    if guidance.active:
        if guidance.following and is_in_space(profile) and not (params.is_paper or guidance.kept):
            lead = tilt_lead(params.gains)
        state, target = _tracked(state, params, here, guidance, profile, now, dt)
        asked, flying = _asked(
            state, estimator, history, params, here, guidance, profile, target, now
        )
    else:
        state, target = _rested(state, guidance, now), _held(guidance)
        asked, flying = AT_REST, False
    if override.active:
        tilt = sqrt(override.theta * override.theta + override.phi * override.phi)
        theta, phi = override.theta, override.phi
        ax, ay = acceleration(theta, phi, here.yaw)
        asked = ControlOutput(theta, phi, override.vz, override.yaw_rate, tilt, ax, ay)
        flying = True
    command = gated(asked, flying, mode, airborne, params.limits)
    heading = here.yaw + lead * command.yaw_rate
    formed = NOT_FORMED
    if params.form.form == FormCode.TILT_AND_CLIMB.value:
        ux, uy = acceleration(command.theta, command.phi, heading)
    else:
        formed = _formed(command, asked, estimator, history, params, here, heading, now)
        command = GatedCommand(
            mode=command.mode,
            flown=formed.flown,
            theta=0.0,
            phi=0.0,
            vz=command.vz,
            yaw_rate=command.yaw_rate,
        )
        ux, uy = formed.ux, formed.uy
    estimator = estimator_commanded(
        estimator, history, params.estimator, ux, uy, command.flown, command.vz
    )
    state = StepState(
        progress=state.progress,
        yaw=state.yaw,
        acceptor=state.acceptor,
        gate=command.mode,
        scale=state.scale,
    )
    return state, estimator, StepOutput(target, asked, flying, command, formed)


@compiled
def _formed(
    command: GatedCommand,
    asked: ControlOutput,
    estimator: EstimatorState,
    history: CommandHistory,
    params: PilotParameters,
    here: PoseEstimate,
    heading: float,
    now: float,
) -> FormedCommand:
    """Return what left the gate as a drone is asked for it that is not steered by tilt.

    A place is asked only of a drone that was seen, and nothing of one that is not flown.
    """
    is_place = params.form.form == FormCode.POSITION.value
    if not command.flown or (is_place and not estimator.gate.initialized):
        return NOT_FORMED
    is_asked = isfinite(asked.ax) and isfinite(asked.ay)
    ax, ay = (asked.ax, asked.ay) if is_asked else (0.0, 0.0)
    if is_place:
        ahead = control_state(estimator, history, params.estimator, here, now)
        return place_asked(ax, ay, command.vz, ahead, params.form)
    return velocity_asked(ax, ay, heading, params.form)


@compiled_with_arrays
def boxed_path_begun(
    state: CompiledBox[StepState], params: CompiledBox[PilotParameters], yaw: float
) -> None:
    """Go to the beginning of a new path or trajectory, at a heading [rad]."""
    before = state[0]
    state[0] = StepState(
        progress=progress_started(params[0], yaw),
        yaw=before.yaw,
        acceptor=before.acceptor,
        gate=before.gate,
        scale=TRAJECTORY_START,
    )


@compiled_with_arrays
def boxed_step(
    state: CompiledBox[StepState],
    estimator: CompiledBox[EstimatorState],
    history: CommandHistory,
    params: CompiledBox[PilotParameters],
    here: PoseEstimate,
    guidance: Guidance,
    profile: PathProfile,
    override: Override,
    mode: int,
    airborne: bool,
    now: float,
    dt: float,
) -> tuple[StepReport, StepOutput]:
    """Do ``step_commanded`` on boxed states: what the live pilot calls.

    Args:
        state: holds what one tick leaves for the next; all others are as there.
        estimator: holds the state that is advanced.
        history: of commands.
        params: holds the parameters.
        here: the estimate for now.
        guidance: what the mission wants.
        profile: the path in use.
        override: what takes the place of control.
        mode: of the gate.
        airborne: the propellers carry the drone.
        now: [s].
        dt: [s].
    """
    after, known, output = step_commanded(
        state[0], estimator[0], history, params[0], here, guidance, profile, override,
        mode, airborne, now, dt,
    )  # fmt: skip
    state[0], estimator[0] = after, known
    report = StepReport(
        acceptor=after.acceptor.state,
        gate=after.gate,
        yaw_target=after.yaw.target,
        yaw_reference=after.yaw.reference,
        scale=after.scale,
    )
    return report, output


@compiled
def _held(guidance: Guidance) -> TrajectorySetpoint:
    standing = standing_setpoint(guidance.x, guidance.y, guidance.yaw, 0, True)
    return at_height(standing, guidance.height)


@compiled
def _rested(state: StepState, guidance: Guidance, now: float) -> StepState:
    """Return the state while nothing is tracked: the acceptor rests, the next heading is free."""
    return StepState(
        progress=state.progress,
        yaw=YawReference(state.yaw.target, nan),
        acceptor=acceptor_advanced(state.acceptor, REST, now, 0.0),
        gate=state.gate,
        scale=state.scale,
    )


@compiled
def _tracked(
    state: StepState,
    params: PilotParameters,
    here: PoseEstimate,
    guidance: Guidance,
    profile: PathProfile,
    now: float,
    dt: float,
) -> tuple[StepState, TrajectorySetpoint]:
    """Return the state with reference, heading and acceptor moved on, and the reference."""
    progress, scale, target = state.progress, state.scale, _held(guidance)
    if guidance.following and is_in_space(profile) and not params.is_paper:
        wanted = guidance.speed_factor if is_flown_in(state.gate) else 0.0
        scale, leg = trajectory_advanced(
            scale, progress.leg, profile, wanted, here.x, here.y, here.z, dt
        )
        progress = PathProgress(s=progress.s, v=progress.v, a=progress.a, leg=leg, yaw=progress.yaw)
        target = trajectory_setpoint(scale, leg, profile)
    elif guidance.following:
        progress, target = _followed(
            state, params, here, profile, params.speed * guidance.speed_factor, dt
        )
        target = at_height(target, guidance.height)
    aim = _held(guidance) if guidance.kept else target
    yaw = _yaw_reference(state.yaw, params, here, guidance, aim, dt)
    acceptor = _accepted(state.acceptor, params, here, guidance, profile, target, yaw, now)
    state = StepState(progress=progress, yaw=yaw, acceptor=acceptor, gate=state.gate, scale=scale)
    return state, target


@compiled
def _followed(
    state: StepState,
    params: PilotParameters,
    here: PoseEstimate,
    profile: PathProfile,
    speed: float,
    dt: float,
) -> tuple[PathProgress, TrajectorySetpoint]:
    before = state.progress
    if params.is_paper:
        waypoints, eps3 = profile.waypoints, params.tolerances.position
        index, yaw = waypoint_advanced(before.leg, before.yaw, waypoints, here.x, here.y, eps3)
        progress = PathProgress(s=0.0, v=0.0, a=0.0, leg=index, yaw=yaw)
        return progress, waypoint_setpoint(index, yaw, waypoints)
    is_moving = (
        state.acceptor.state == AcceptorState.PATH_TRACKING
        or state.acceptor.state == AcceptorState.HOVER
    ) and is_flown_in(state.gate)
    moved = progress_advanced(before, profile, speed, here.x, here.y, is_moving, dt)
    progress = progress_headed(moved, profile)
    return progress, setpoint_at(progress, profile)


@compiled
def _yaw_reference(
    before: YawReference,
    params: PilotParameters,
    here: PoseEstimate,
    guidance: Guidance,
    target: TrajectorySetpoint,
    dt: float,
) -> YawReference:
    wish = target.yaw
    arrived = guidance.following and target.finished and not (params.is_paper or guidance.kept)
    if arrived and isfinite(guidance.arrival_yaw):
        wish = guidance.arrival_yaw
    turn_max = inf if params.is_paper else YAW_REFERENCE_RATE * dt
    return yaw_reference_advanced(before, wish, here.yaw, turn_max)


@compiled
def _accepted(
    before: Acceptor,
    params: PilotParameters,
    here: PoseEstimate,
    guidance: Guidance,
    profile: PathProfile,
    target: TrajectorySetpoint,
    yaw: YawReference,
    now: float,
) -> Acceptor:
    """Return the acceptor; place counts to the path's end, in mode paper to the waypoint."""
    x, y = target.x, target.y
    if guidance.following and not params.is_paper:
        end = len(profile.points) - 1
        x, y = profile.points[end, 0], profile.points[end, 1]
    off = sqrt((here.x - x) ** 2 + (here.y - y) ** 2)
    turn = here.yaw - yaw.target
    turn = wrapped(turn) if params.gains.wraps else turn
    rise, eps = here.z - target.z, params.tolerances
    if params.is_paper:
        conditions = printed_conditions(rise, turn, off, eps.height, eps.yaw, eps.position)
    else:
        conditions = steady_conditions(
            before.state, rise, turn, off, eps.height, eps.yaw, eps.position
        )
    return acceptor_advanced(before, conditions, now, eps.dwell)


@compiled
def _asked(
    state: StepState,
    estimator: EstimatorState,
    history: CommandHistory,
    params: PilotParameters,
    here: PoseEstimate,
    guidance: Guidance,
    profile: PathProfile,
    target: TrajectorySetpoint,
    now: float,
) -> tuple[ControlOutput, bool]:
    """Return what control asks, and whether it flies: in mode paper's hover the drone does."""
    ahead = control_state(estimator, history, params.estimator, here, now)
    if guidance.kept:
        target = _held(guidance)
    if guidance.following and is_in_space(profile) and not (params.is_paper or guidance.kept):
        delay = params.gains.delay + ahead.delay_change
        reference = feed_forward_reference(
            state.scale, profile, target, state.yaw.reference, params.gains, delay
        )
    else:
        reference = ControlReference(
            position=(target.x, target.y),
            velocity=(target.vx, target.vy),
            acceleration=(target.ax, target.ay),
            height=target.z,
            yaw=state.yaw.reference,
            climb=0.0,
            turn=0.0,
            lead=0.0,
        )
    if params.is_paper:
        asked = paper_control_output(state.acceptor.state, reference, ahead, params.gains)
        return asked, state.acceptor.state != AcceptorState.HOVER
    return control_output(reference, ahead, params.gains), True
