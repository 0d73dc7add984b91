"""What may differ between the drones of an experiment: a row a drone, a column a quantity.

The same table declares the columns, their units and ranges, and where a site gives their values.
Campaign files, results and the compiled loop all use these names.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.errors import ConfigError
from housefly.pilot.behavior.acceptor import PAPER_TOLERANCES
from housefly.pilot.control.forms import FormCode
from housefly.pilot.estimation.estimator import DISTURBANCE_WANDER
from housefly.pilot.estimation.estimator_state import EstimatorKind
from housefly.pilot.site_parameters import FORM_CODES, form_model, pull_of
from housefly.twin.command_delay import simulated_command_delay

DEFAULT, PAPER = 0, 1
"""Values of the column ``mode``."""


class Parameter(NamedTuple):
    """One column.

    Attributes:
        name: of the column; SI, or the unit stands in the name.
        unit: "1" for pure numbers.
        low: smallest value accepted from outside.
        high: largest value accepted from outside.
        of: the value that a site gives.
        meaning: one line.
    """

    name: str
    unit: str
    low: float
    high: float
    of: Callable[[Site], float]
    meaning: str


def _is_paper(site: Site) -> bool:
    return site.mode == "paper"


def _believed_delay(site: Site) -> float:
    is_known = _is_paper(site) or site.estimation.delay_compensated
    return site.drone.command_delay if is_known else 0.0


def _estimated(value: Callable[[Site], float], without: float = 0.0) -> Callable[[Site], float]:
    """Return a value of the site that mode paper has not."""
    return lambda site: without if _is_paper(site) else value(site)


def _sink_gain(site: Site) -> float:
    is_counted = not _is_paper(site) and site.estimation.lift_wander > 0.0
    return site.drone.sink_gain if is_counted else 1.0


def _climb_command_max(site: Site) -> float:
    is_counted = not _is_paper(site) and site.estimation.lift_wander > 0.0
    return site.limits.full_climb if is_counted else site.limits.vertical_speed_max


def _stiffness(site: Site) -> float:
    return site.drone.airframe.response.stiffness or 1.0


# fmt: off
_P = Parameter
PARAMETERS: tuple[Parameter, ...] = (
    _P("mode", "1", DEFAULT, PAPER, lambda s: PAPER if _is_paper(s) else DEFAULT,
       "0 default, 1 paper"),
    _P("estimator", "1", EstimatorKind.DELAY_COMPENSATED, EstimatorKind.FINITE_DIFFERENCE,
       lambda s: EstimatorKind.ON_ARRIVAL if _is_paper(s) else EstimatorKind.DELAY_COMPENSATED,
       "0 delay-compensated, 1 Kalman on arrival (paper), 2 Kalman fed the held sample,"
       " 3 held sample and finite difference"),
    _P("form", "1", FormCode.TILT_AND_CLIMB, FormCode.POSITION,
       lambda s: FORM_CODES[s.drone.airframe.capabilities.form],
       "what the drone is steered by: 0 tilt and climb, 1 velocity, 2 position"),
    _P("rate_hz", "Hz", 20.0, 200.0, lambda s: s.control.rate_hz, "rate of the pilot's loop"),
    _P("alpha", "1/s", -20.0, 60.0, lambda s: s.control.alpha,
       "damping gain; negative is the paper's literal sign"),
    _P("beta", "1/s^2", -50.0, 500.0, lambda s: s.control.beta, "stiffness gain"),
    _P("yaw_gain", "1/s", -10.0, 20.0, lambda s: s.control.yaw_gain, "K1"),
    _P("height_gain", "1/s", -10.0, 20.0, lambda s: s.control.height_gain, "K2"),
    _P("epsilon_height", "m", 0.001, 2.0,
       lambda s: PAPER_TOLERANCES.height if _is_paper(s) else s.control.epsilon_height,
       "eps1 of the acceptor"),
    _P("epsilon_yaw", "rad", 0.0001, 3.2,
       lambda s: PAPER_TOLERANCES.yaw if _is_paper(s) else s.control.epsilon_yaw,
       "eps2 of the acceptor"),
    _P("epsilon_position", "m", 0.001, 2.0,
       lambda s: PAPER_TOLERANCES.position if _is_paper(s) else s.control.epsilon_position,
       "eps3 of the acceptor"),
    _P("dwell", "s", 0.0, 5.0, lambda s: 0.0 if _is_paper(s) else s.control.dwell,
       "shortest stay in a state"),
    _P("wrap_yaw", "1", 0.0, 1.0, lambda s: 1.0,
       "1 wraps yaw errors; 0 is the paper's literal reading"),
    _P("acceleration_noise", "m/s^2", 0.001, 50.0, lambda s: s.control.acceleration_noise,
       "Kalman Q, one sigma; mode paper's filter takes it as a density [m/s^1.5]"),
    _P("position_noise", "m", 1e-05, 1.0, lambda s: s.control.position_noise,
       "Kalman R, one sigma"),
    _P("model_lag", "1/s", 0.5, 50.0, lambda s: s.drone.attitude_lag,
       "lambda that the pilot believes"),
    _P("model_gain", "1", 0.2, 2.0, lambda s: s.drone.attitude_gain,
       "c / lambda that the pilot believes"),
    _P("model_drag", "1/s", 0.0, 5.0, lambda s: s.drone.drag, "drag that the pilot believes"),
    _P("model_delay", "s", 0.0, 0.5, _believed_delay, "command delay that the pilot believes"),
    _P("model_climb_lag", "1/s", 0.2, 50.0, lambda s: s.drone.climb_lag,
       "pole of the climb rate that the pilot believes"),
    _P("model_sink_gain", "1", 0.5, 3.0, _sink_gain,
       "what the pilot believes of a commanded sinking: done over commanded"),
    _P("feed_forward", "1", 0.0, 1.0, lambda s: s.control.feed_forward,
       "share of the reference's velocity and acceleration that is led with"),
    _P("disturbance_wander", "m/s^2/sqrt(s)", 0.0, 2.0,
       _estimated(lambda s: s.estimation.disturbance_wander, DISTURBANCE_WANDER),
       "how fast a push in the plane may change; 0 knows of none"),
    _P("lift_wander", "m/s^2/sqrt(s)", 0.0, 5.0, _estimated(lambda s: s.estimation.lift_wander),
       "how fast a push up or down may change; 0 knows of none"),
    _P("climb_noise", "m/s^1.5", 0.001, 5.0, lambda s: s.estimation.climb_noise,
       "unmodelled vertical acceleration; counts with lift_wander"),
    _P("delay_deviation", "s", 0.0, 0.2,
       _estimated(
           lambda s: s.estimation.delay_deviation if s.estimation.delay_compensated else 0.0
       ),
       "one sigma by which model_delay may be wrong; 0 believes it"),
    _P("mistrust", "1", 0.0, 1.0, _estimated(lambda s: s.estimation.mistrust),
       "share by which delays and lag may be wrong, by which gains are lowered"),
    _P("tilt_max", "rad", 0.02, 0.5, lambda s: s.limits.tilt_max, "largest pitch or roll"),
    _P("vertical_speed_max", "m/s", 0.05, 2.0, lambda s: s.limits.vertical_speed_max,
       "largest climb rate"),
    _P("climb_command_max", "m/s", 0.05, 2.0, _climb_command_max,
       "largest climb rate asked of the drone's own loop; counts with lift_wander"),
    _P("yaw_rate_max", "rad/s", 0.1, 6.2, lambda s: s.limits.yaw_rate_max, "largest yaw rate"),
    _P("speed", "m/s", 0.05, 2.0, lambda s: s.limits.speed, "cruise speed of the reference"),
    _P("pose_age_level", "s", 0.05, inf, lambda s: s.limits.pose_age_level,
       "pose age at which the drone holds itself"),
    _P("pose_age_land", "s", 0.3, inf, lambda s: s.limits.pose_age_land,
       "pose age at which it lands: the flight ends"),
    _P("lag", "1/s", 0.5, 50.0, lambda s: s.drone.attitude_lag, "lambda of the drone"),
    _P("gain", "1", 0.05, 20.0, lambda s: s.drone.attitude_gain, "c / lambda of the drone"),
    _P("drag", "1/s", 0.0, 5.0, lambda s: s.drone.drag, "linear drag over mass of the drone"),
    _P("delay", "s", 0.0, 0.5, simulated_command_delay,
       "from command to first reaction of the drone"),
    _P("climb_lag", "1/s", 0.2, 50.0, lambda s: s.drone.climb_lag,
       "pole of the drone's climb rate"),
    _P("yaw_lag", "1/s", 0.2, 50.0, lambda s: s.drone.yaw_lag, "pole of the drone's yaw rate"),
    _P("model_pull", "1/s", 0.0, 50.0, lambda s: pull_of(s.drone),
       "pole of the velocity response, or damping of that to places, that the pilot believes"),
    _P("pull", "1/s", 0.0, 50.0, lambda s: pull_of(s.drone), "the same of the drone"),
    _P("model_stiffness", "1/s^2", 0.1, 400.0, _stiffness,
       "how hard the drone flies to a place, as the pilot believes"),
    _P("stiffness", "1/s^2", 0.1, 400.0, _stiffness, "the same of the drone"),
    _P("form_speed_max", "m/s", 0.1, 20.0, lambda s: form_model(s.drone, s.limits).speed_max,
       "fastest velocity asked for"),
    _P("wind_x", "m/s^2", -2.0, 2.0, lambda s: 0.0, "steady push along x"),
    _P("wind_y", "m/s^2", -2.0, 2.0, lambda s: 0.0, "steady push along y"),
    _P("lift", "m/s^2", -2.0, 2.0, lambda s: 0.0,
       "steady push upwards: a tenth of the weight is 0.98"),
    _P("sink_gain", "1", 0.5, 3.0, _sink_gain, "what the drone makes of a commanded sinking"),
    _P("gust", "m/s^2", 0.0, 2.0, lambda s: 0.0,
       "one sigma of a push that changes within a second"),
    _P("mocap_rate_hz", "Hz", 1.0, 400.0, lambda s: s.twin.mocap_rate_hz,
       "frames per second of the tracking"),
    _P("mocap_latency", "s", 0.0, 0.5, lambda s: s.twin.mocap_latency, "from exposure to arrival"),
    _P("mocap_jitter", "s", 0.0, 0.1, lambda s: 0.0005,
       "mean of the extra, exponentially distributed delay"),
    _P("mocap_noise", "m", 0.0, 0.1, lambda s: s.twin.mocap_noise,
       "one sigma of a tracked coordinate"),
    _P("mocap_dropout", "1", 0.0, 1.0, lambda s: s.twin.mocap_dropout, "share of frames lost"),
)
# fmt: on
WHOLE = ("mode", "estimator", "form")
"""Columns that hold whole numbers."""
CASE = np.dtype(
    [(p.name, np.int64 if p.name in WHOLE else np.float64) for p in PARAMETERS]
    + [("seed", np.int64)]
)
"""One drone of an experiment."""
BY_NAME = {parameter.name: parameter for parameter in PARAMETERS}

Cases = NDArray[Any]
"""Structured array of dtype ``CASE``."""


def cases(site: Site, count: int = 1, **columns: Any) -> Cases:
    """Return ``count`` drones of a site, some columns replaced by one number or ``count``.

    Raises:
        ConfigError: naming the column, the value and the allowed range.
    """
    table = np.zeros(count, CASE)
    for parameter in PARAMETERS:
        table[parameter.name] = parameter.of(site)
    for name, values in columns.items():
        if name not in CASE.names:  # type: ignore[operator]
            raise ConfigError(
                name, f"is no column of an experiment; there are: {', '.join(CASE.names or ())}"
            )
        table[name] = checked(name, np.asarray(values))
    return table


def checked(name: str, values: NDArray[Any]) -> NDArray[Any]:
    """Return the values of one column; raises ConfigError outside the column's range."""
    if name == "seed":
        return values
    parameter = BY_NAME[name]
    numbers = values.astype(float)
    bad = ~((numbers >= parameter.low) & (numbers <= parameter.high))
    if bad.any():
        unit = "" if parameter.unit == "1" else f" {parameter.unit}"
        raise ConfigError(
            name,
            f"is {numbers[bad].flat[0]:g}; allowed: a number from {parameter.low:g} to"
            f" {parameter.high:g}{unit}",
        )
    return values
