"""The optical flow of an AR.Drone, as its airframe has it."""

from __future__ import annotations

from housefly.config.airframe import airframe_named
from housefly.pilot.estimation.flow_model import flow_model

FLOW = flow_model(airframe_named("ardrone").flow)
