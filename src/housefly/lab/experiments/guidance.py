"""What a mission is to the live pilot: which place to hold, when to follow the path."""

from __future__ import annotations

from math import inf, isnan, nan
from typing import Any, NamedTuple

from housefly.lab.experiments.route import PATH, STEP, Route
from housefly.numeric import compiled
from housefly.pilot.behavior.acceptor import Tolerances
from housefly.pilot.behavior.path_progress import PathProgress
from housefly.pilot.control.forms import FormModel
from housefly.pilot.control.steering import Gains
from housefly.pilot.estimation.climb_axis import ClimbModel
from housefly.pilot.estimation.delay_filter import TIME_TOLERANCE
from housefly.pilot.estimation.estimator import axis_model
from housefly.pilot.estimation.estimator_state import (
    EstimatorParameters,
    PoseEstimate,
)
from housefly.pilot.safety.limits import CommandLimits
from housefly.pilot.step import Guidance, PilotParameters, StepState, progress_started


class TaskState(NamedTuple):
    """How far one drone has come with its task.

    Attributes:
        begun: the task has begun.
        x, y, yaw: where it waits before [m, rad]; the heading is nan before anything was seen.
    """

    begun: bool
    x: float
    y: float
    yaw: float


@compiled
def parameters_of_case(case: Any) -> PilotParameters:
    """Return the parameters of the pilot of one case."""
    pull = case.model_pull if case.model_pull > 0.0 else case.model_drag
    noise, limits = case.acceleration_noise, (case.tilt_max, case.vertical_speed_max)
    return PilotParameters(
        is_paper=case.mode > 0,
        estimator=EstimatorParameters(
            kind=case.estimator,
            model=axis_model(
                case.model_lag,
                case.model_gain,
                case.model_drag,
                noise,
                case.disturbance_wander,
                case.model_pull,
            ),
            delay=case.model_delay,
            acceleration_noise=noise,
            position_noise=case.position_noise,
            climb=ClimbModel(
                pole=case.model_climb_lag,
                sink_gain=case.model_sink_gain,
                noise=case.climb_noise,
                wander=case.lift_wander,
            ),
            delay_deviation=case.delay_deviation,
            mistrust=case.mistrust,
        ),
        tolerances=Tolerances(
            height=case.epsilon_height,
            yaw=case.epsilon_yaw,
            position=case.epsilon_position,
            dwell=case.dwell,
        ),
        gains=Gains(
            alpha=case.alpha,
            beta=case.beta,
            height=case.height_gain,
            yaw=case.yaw_gain,
            tilt_max=limits[0],
            climb_max=limits[1],
            turn_max=case.yaw_rate_max,
            gain=case.model_gain,
            drag=pull,
            delay=case.model_delay,
            wraps=case.wrap_yaw > 0.5,
            lag=case.model_lag,
            climb_lag=case.model_climb_lag,
            inverts_climb=case.lift_wander > 0.0,
            sink_gain=case.model_sink_gain,
            feed_forward=case.feed_forward,
            climb_command_max=case.climb_command_max,
        ),
        limits=CommandLimits(
            tilt_max=limits[0],
            vertical_speed_max=case.climb_command_max,
            yaw_rate_max=case.yaw_rate_max,
        ),
        speed=case.speed,
        form=FormModel(
            form=case.form,
            gain=case.model_gain,
            pull=case.model_pull,
            stiffness=case.model_stiffness,
            climb_pull=case.model_climb_lag,
            speed_max=case.form_speed_max,
            x_min=-inf,
            y_min=-inf,
            x_max=inf,
            y_max=inf,
            z_max=inf,
        ),
    )


@compiled
def task_created(route: Route) -> TaskState:
    """Return the task before anything was seen."""
    return TaskState(begun=False, x=route.start_x, y=route.start_y, yaw=nan)


@compiled
def guided(
    task: TaskState,
    state: StepState,
    route: Route,
    params: PilotParameters,
    here: PoseEstimate,
    active: bool,
    now: float,
) -> tuple[TaskState, PathProgress, Guidance]:
    """Return the task and the progress of one tick, and what the pilot is to track.

    Args:
        task: before.
        state: of the pilot's step.
        route: of the experiment.
        params: of the pilot.
        here: the estimate.
        active: something was seen.
        now: [s].
    """
    progress = state.progress
    if active:
        if isnan(task.yaw):
            task = _found(route, here)
        if not task.begun and now >= route.settle - TIME_TOLERANCE:
            task = TaskState(begun=True, x=task.x, y=task.y, yaw=task.yaw)
            progress = progress_started(params, here.yaw)
    x, y, yaw = task.x, task.y, route.yaw if isnan(task.yaw) else task.yaw
    if task.begun and route.task != PATH:
        at = len(route.path.waypoints) - 1 if route.task == STEP else 0
        x, y, yaw = route.path.waypoints[at, 0], route.path.waypoints[at, 1], route.yaw
    guidance = Guidance(
        active=active,
        following=task.begun and route.task == PATH,
        x=x,
        y=y,
        yaw=yaw,
        arrival_yaw=route.arrival_yaw,
        height=route.height,
        speed_factor=1.0,
        kept=False,
    )
    return task, progress, guidance


@compiled
def _found(route: Route, here: PoseEstimate) -> TaskState:
    """Return the task of a drone just found in the air.

    On a path it waits right there, as the live pilot does.
    """
    if route.task == PATH:
        return TaskState(begun=False, x=here.x, y=here.y, yaw=here.yaw)
    return TaskState(begun=False, x=route.start_x, y=route.start_y, yaw=route.yaw)
