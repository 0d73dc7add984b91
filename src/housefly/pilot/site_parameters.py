"""The parameters of the compiled step for one site."""

from __future__ import annotations

from housefly.config.control import ControlConfig
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES, Tolerances
from housefly.pilot.control.steering import Gains
from housefly.pilot.estimation.estimator import EstimatorKind, EstimatorParameters, axis_model
from housefly.pilot.safety.limits import CommandLimits
from housefly.pilot.step import PilotParameters


def pilot_parameters(
    is_paper: bool, drone: DroneConfig, control: ControlConfig, limits: LimitsConfig
) -> PilotParameters:
    """Return the parameters of a mode, a drone, its control and its limits."""
    return PilotParameters(
        is_paper=is_paper,
        estimator=estimator_parameters(is_paper, drone, control),
        tolerances=PAPER_TOLERANCES if is_paper else _tolerances(control),
        gains=gains_of(drone, control, limits),
        limits=CommandLimits(
            tilt_max=limits.tilt_max,
            vertical_speed_max=limits.vertical_speed_max,
            yaw_rate_max=limits.yaw_rate_max,
        ),
        speed=limits.speed,
    )


def estimator_parameters(
    is_paper: bool, drone: DroneConfig, control: ControlConfig
) -> EstimatorParameters:
    """Return what the estimator of a mode is told of a drone and its noises."""
    noise = control.acceleration_noise
    kind = EstimatorKind.ON_ARRIVAL if is_paper else EstimatorKind.DELAY_COMPENSATED
    return EstimatorParameters(
        kind=int(kind),
        model=axis_model(drone.attitude_lag, drone.attitude_gain, drone.drag, noise),
        delay=drone.command_delay,
        acceleration_noise=noise,
        position_noise=control.position_noise,
    )


def gains_of(drone: DroneConfig, control: ControlConfig, limits: LimitsConfig) -> Gains:
    """Return what the control laws need."""
    return Gains(
        alpha=control.alpha,
        beta=control.beta,
        height=control.height_gain,
        yaw=control.yaw_gain,
        tilt_max=limits.tilt_max,
        climb_max=limits.vertical_speed_max,
        turn_max=limits.yaw_rate_max,
        gain=drone.attitude_gain,
        drag=drone.drag,
        delay=drone.command_delay,
        wraps=True,
    )


def _tolerances(control: ControlConfig) -> Tolerances:
    return Tolerances(
        height=control.epsilon_height,
        yaw=control.epsilon_yaw,
        position=control.epsilon_position,
        dwell=control.dwell,
    )
