"""The messages: every value that crosses a border between two packages.

All values are frozen. SI units. World frame: x along the long wall, y left, z up. Body frame:
forward, left, up. Times are seconds of the monotonic clock; only what the room remembers
(``messages.world``) is stamped in Unix time. Pitch is theta, roll is phi, yaw is psi; signs follow
REP-103: positive theta is nose down (accelerates forward), positive phi is right side down
(accelerates right), positive psi is counter-clockwise seen from above.
"""

from housefly.messages.depth import DepthImage
from housefly.messages.event_code import EventCode
from housefly.messages.flight import (
    Event,
    Inputs,
    LinkStatus,
    Order,
    OrderAnswer,
    OrderKind,
    OrderOutcome,
    OrderSource,
    Outputs,
    Phase,
    PilotStep,
    Severity,
)
from housefly.messages.obstacles import Obstacle, ObstacleKind
from housefly.messages.preflight import PreflightCheck
from housefly.messages.scan import Scan
from housefly.messages.sensing import (
    DroneFault,
    DroneStatus,
    Estimate,
    Pose,
    SensorReport,
    Sighting,
    SightNews,
    Telemetry,
    TrackedFrame,
    VideoFrame,
)
from housefly.messages.steering import (
    LEVEL,
    Action,
    AnySetpoint,
    Behavior,
    Clearing,
    Command,
    KnownMotion,
    Path,
    PlanAnswer,
    PlannedTrajectory,
    PositionSetpoint,
    Reference,
    SafetyMode,
    Setpoint,
    SetpointForm,
    TrajectoryPoint,
    VelocitySetpoint,
)
from housefly.messages.world import (
    Covariance,
    Fact,
    Facts,
    Observation,
    RecordingNews,
    RoomEvent,
)

__all__ = [
    "LEVEL",
    "Action",
    "AnySetpoint",
    "Behavior",
    "Clearing",
    "Command",
    "Covariance",
    "DepthImage",
    "DroneFault",
    "DroneStatus",
    "Estimate",
    "Event",
    "EventCode",
    "Fact",
    "Facts",
    "Inputs",
    "KnownMotion",
    "LinkStatus",
    "Observation",
    "Obstacle",
    "ObstacleKind",
    "Order",
    "OrderAnswer",
    "OrderKind",
    "OrderOutcome",
    "OrderSource",
    "Outputs",
    "Path",
    "Phase",
    "PilotStep",
    "PlanAnswer",
    "PlannedTrajectory",
    "Pose",
    "PositionSetpoint",
    "PreflightCheck",
    "RecordingNews",
    "Reference",
    "RoomEvent",
    "SafetyMode",
    "Scan",
    "SensorReport",
    "Setpoint",
    "SetpointForm",
    "Severity",
    "SightNews",
    "Sighting",
    "Telemetry",
    "TrackedFrame",
    "TrajectoryPoint",
    "VelocitySetpoint",
    "VideoFrame",
]
