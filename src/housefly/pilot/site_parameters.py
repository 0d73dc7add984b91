"""The parameters of the compiled step for one site."""

from __future__ import annotations

from math import inf

from housefly.config.control import ControlConfig
from housefly.config.drone import DroneConfig
from housefly.config.estimation import ONLY_LEVEL_PUSHES, EstimationConfig
from housefly.config.limits import LimitsConfig
from housefly.errors import ConfigError
from housefly.messages.steering import SetpointForm
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES, Tolerances
from housefly.pilot.control.forms import FormCode, FormModel
from housefly.pilot.control.steering import Gains
from housefly.pilot.estimation.climb_axis import ClimbModel
from housefly.pilot.estimation.estimator import axis_model
from housefly.pilot.estimation.estimator_state import (
    EstimatorKind,
    EstimatorParameters,
)
from housefly.pilot.safety.limits import CommandLimits
from housefly.pilot.safety.motion_rules import speed_bound
from housefly.pilot.step import PilotParameters


def pilot_parameters(
    is_paper: bool,
    drone: DroneConfig,
    control: ControlConfig,
    limits: LimitsConfig,
    estimation: EstimationConfig = ONLY_LEVEL_PUSHES,
) -> PilotParameters:
    """Return the parameters of a mode, a drone, its control, its limits and its estimation; mode
    paper has none of the last.

    Raises:
        ConfigError: mode paper, and a drone that is not steered by tilt.
    """
    form = drone.airframe.capabilities.form
    if is_paper and form is not SetpointForm.TILT_AND_CLIMB:
        raise ConfigError(
            "mode",
            f"is 'paper', which steers by tilt and climb; the drone ({drone.kind}) takes"
            f" {form.value}",
        )
    estimation = ONLY_LEVEL_PUSHES if is_paper else estimation
    return PilotParameters(
        is_paper=is_paper,
        estimator=estimator_parameters(is_paper, drone, control, estimation),
        tolerances=PAPER_TOLERANCES if is_paper else _tolerances(control),
        gains=gains_of(drone, control, limits, estimation),
        limits=CommandLimits(
            tilt_max=limits.tilt_max,
            vertical_speed_max=_climb_command_max(drone, limits, estimation),
            yaw_rate_max=_turn_max(drone, limits),
        ),
        speed=limits.speed,
        form=form_model(drone, limits),
    )


def form_model(drone: DroneConfig, limits: LimitsConfig) -> FormModel:
    """Return how a drone answers the form of setpoints that is made for it."""
    response, form = drone.airframe.response, FORM_CODES[drone.airframe.capabilities.form]
    speed_max = inf if form is FormCode.TILT_AND_CLIMB else response.speed_max or inf
    return FormModel(
        form=int(form),
        gain=drone.attitude_gain,
        pull=pull_of(drone),
        stiffness=response.stiffness or 1.0,
        climb_pull=drone.climb_lag,
        speed_max=min(speed_bound(limits), speed_max),
    )


FORM_CODES = {
    SetpointForm.TILT_AND_CLIMB: FormCode.TILT_AND_CLIMB,
    SetpointForm.VELOCITY: FormCode.VELOCITY,
    SetpointForm.POSITION: FormCode.POSITION,
}


def pull_of(drone: DroneConfig) -> float:
    """Return what brings a drone to rest to which nothing is asked [1/s] (``control.forms``).

    0 for one that is steered by tilt: that is drag alone.
    """
    response = drone.airframe.response
    pulls = {
        SetpointForm.VELOCITY: response.velocity_lag,
        SetpointForm.POSITION: response.damping,
    }
    return pulls.get(drone.airframe.capabilities.form) or 0.0


def estimator_parameters(
    is_paper: bool,
    drone: DroneConfig,
    control: ControlConfig,
    estimation: EstimationConfig = ONLY_LEVEL_PUSHES,
) -> EstimatorParameters:
    """Return what the estimator of a mode is told of a drone and its noises."""
    noise = control.acceleration_noise
    kind = EstimatorKind.ON_ARRIVAL if is_paper else EstimatorKind.DELAY_COMPENSATED
    return EstimatorParameters(
        kind=int(kind),
        model=axis_model(
            drone.attitude_lag,
            drone.attitude_gain,
            drone.drag,
            noise,
            estimation.disturbance_wander,
            pull_of(drone),
        )._replace(hover_drag=drone.drag + drone.airframe.response.hover_brake),
        delay=_delay(drone, estimation),
        acceleration_noise=noise,
        position_noise=control.position_noise,
        climb=ClimbModel(
            pole=drone.climb_lag,
            sink_gain=_sink_gain(drone, estimation),
            noise=estimation.climb_noise,
            wander=estimation.lift_wander,
        ),
        delay_deviation=estimation.delay_deviation if estimation.delay_compensated else 0.0,
        mistrust=estimation.mistrust,
    )


def gains_of(
    drone: DroneConfig,
    control: ControlConfig,
    limits: LimitsConfig,
    estimation: EstimationConfig = ONLY_LEVEL_PUSHES,
) -> Gains:
    """Return what the control laws need."""
    return Gains(
        alpha=control.alpha,
        beta=control.beta,
        height=control.height_gain,
        yaw=control.yaw_gain,
        tilt_max=limits.tilt_max,
        climb_max=min(limits.vertical_speed_max, drone.airframe.response.climb_max or inf),
        turn_max=_turn_max(drone, limits),
        gain=drone.attitude_gain,
        drag=pull_of(drone) or drone.drag,
        delay=_delay(drone, estimation),
        wraps=True,
        lag=drone.attitude_lag,
        climb_lag=drone.climb_lag,
        inverts_climb=estimation.lift_wander > 0.0,
        climb_command_max=_climb_command_max(drone, limits, estimation),
        sink_gain=_sink_gain(drone, estimation),
        feed_forward=control.feed_forward,
    )


def _climb_command_max(
    drone: DroneConfig, limits: LimitsConfig, estimation: EstimationConfig
) -> float:
    asked = limits.full_climb if estimation.lift_wander > 0.0 else limits.vertical_speed_max
    return min(asked, drone.airframe.response.climb_max or inf)


def _turn_max(drone: DroneConfig, limits: LimitsConfig) -> float:
    return min(limits.yaw_rate_max, drone.airframe.response.turn_max or inf)


def _sink_gain(drone: DroneConfig, estimation: EstimationConfig) -> float:
    return drone.sink_gain if estimation.lift_wander > 0.0 else 1.0


def _delay(drone: DroneConfig, estimation: EstimationConfig) -> float:
    return drone.command_delay if estimation.delay_compensated else 0.0


def _tolerances(control: ControlConfig) -> Tolerances:
    return Tolerances(
        height=control.epsilon_height,
        yaw=control.epsilon_yaw,
        position=control.epsilon_position,
        dwell=control.dwell,
    )
