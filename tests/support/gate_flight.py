"""A flight where the last gate finds nothing wrong."""

from __future__ import annotations

from housefly.config.airframe import airframe_named
from housefly.config.limits import LimitsConfig
from housefly.messages import DroneStatus, Phase, Reference, Setpoint, Telemetry
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.rules import SAFETY_RULES

AIRFRAME = airframe_named("ardrone")
LIMITS = LimitsConfig()
FENCE = Geofence((0.0, 0.0, 10.0, 5.0), 2.3)
RULES = {rule.code: rule for rule in SAFETY_RULES}
HERE = (5.0, 2.0, 1.1)
REPORT = Telemetry(0.0, DroneStatus.FLYING, 0.9, height=1.05, acceleration=(0.0, 0.0, 9.81))
FINE = GateInputs(
    now=0.0,
    status=DroneStatus.FLYING,
    battery=0.9,
    pose_age=0.02,
    telemetry_age=0.05,
    position=HERE,
    stopped=False,
    cutting=False,
    phase=Phase.OUTBOUND,
    velocity=(0.0, 0.0, 0.0),
    reference=Reference(HERE, (0.0, 0.0, 0.0), 0.0),
    flight_height=1.1,
    flown=Setpoint(),
    telemetry=REPORT,
    consistency=TrackingConsistency(drift=0.0),
    home_time=20.0,
)
