"""What is known of the velocity that a drone reports: how late it is, and how wrong."""

from __future__ import annotations

from math import exp
from typing import NamedTuple

from housefly.config.airframe import FlowConstants
from housefly.numeric import compiled


class FlowModel(NamedTuple):
    """The errors of a drone's optical flow, as its airframe has them.

    Attributes:
        delay: velocity and height of a report are this old [s].
        noise: white noise of a reported velocity, one sigma [m/s].
        bias: slowly wandering bias of it, one sigma [m/s].
        bias_time: correlation time of that bias [s].
    """

    delay: float
    noise: float
    bias: float
    bias_time: float


NO_FLOW = FlowModel(delay=0.0, noise=0.0, bias=0.0, bias_time=1.0)
"""Of a drone that reports no velocity: none is ever believed."""


def flow_model(flow: FlowConstants | None) -> FlowModel:
    """Return the model of an airframe's flow."""
    if flow is None:
        return NO_FLOW
    return FlowModel(flow.delay, flow.noise, flow.bias, flow.bias_time)


@compiled
def flow_bias_variance(flow: FlowModel, seconds: float) -> float:
    """Return the variance of the odometry over a time [s] by the bias of the flow [m^2]."""
    tau = flow.bias_time
    return 2.0 * flow.bias**2 * tau * (seconds - tau * (1.0 - exp(-seconds / tau)))
