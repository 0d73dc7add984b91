"""How drones, links and sensors are, as ROS diagnostics."""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum
from typing import Any

from housefly.hub.api.answers import SensorAnswer
from housefly.messages import LinkStatus, PilotStep, SafetyMode
from housefly.record.ros_messages import header, message

_FLIES_ON = frozenset(
    {
        *(SafetyMode.WARN, SafetyMode.SLOW, SafetyMode.HOLD),
        *(SafetyMode.RETURN, SafetyMode.STOPPED),
    }
)


class Level(IntEnum):
    """Of diagnostic_msgs/DiagnosticStatus."""

    OK = 0
    WARN = 1
    ERROR = 2
    STALE = 3


def flight_status(drone: str, step: PilotStep) -> Any:
    """Return the status of a drone's flight."""
    outputs, telemetry, estimate = step.outputs, step.inputs.telemetry, step.outputs.estimate
    level = Level.WARN if outputs.safety in _FLIES_ON else Level.ERROR
    values = {
        "phase": outputs.phase.value,
        "safety": outputs.safety.value,
        "behavior": outputs.behavior.value,
        "drone": "" if telemetry is None else telemetry.status.value,
        "battery": "" if telemetry is None else f"{telemetry.battery:.2f}",
        "pose age [s]": "" if estimate is None else f"{estimate.pose_age:.3f}",
    }
    level = Level.OK if outputs.safety is SafetyMode.NOMINAL else level
    return _status(level, f"{drone}: flight", str(outputs.reason), drone, values)


def link_status(drone: str, link: LinkStatus) -> Any:
    """Return the status of a pilot's wires and loop."""
    is_well = link.tracking_connected and link.drone_connected
    values = {
        "tracking [Hz]": f"{link.tracking_rate_hz:.0f}",
        "telemetry [Hz]": f"{link.telemetry_rate_hz:.0f}",
        "video [Hz]": f"{link.video_rate_hz:.0f}",
        "tracking latency [ms]": f"{1e3 * link.tracking_latency_s:.1f}",
        "late, 99 of 100 steps [ms]": f"{1e3 * link.loop_p99_s:.2f}",
        "missed steps": str(link.missed_ticks),
    }
    words = "; ".join(map(str, link.notes))
    return _status(Level.OK if is_well else Level.WARN, f"{drone}: links", words, drone, values)


def sensor_status(sensor: SensorAnswer) -> Any:
    """Return the status of a sensor; STALE where it is silent."""
    is_well = sensor.connected and not sensor.problem
    level = Level.OK if is_well else Level.WARN if sensor.connected else Level.STALE
    values = {
        "kind": sensor.kind,
        "rate [Hz]": f"{sensor.rate_hz:.1f}",
        "age [s]": "" if sensor.age is None else f"{sensor.age:.1f}",
        **{name: str(count) for name, count in sensor.counts.items()},
    }
    name = f"sensor: {sensor.title or sensor.sensor}"
    return _status(level, name, str(sensor.problem), sensor.sensor, values)


def diagnostics_message(at: float, statuses: Sequence[Any]) -> Any:
    """Return diagnostic_msgs/DiagnosticArray."""
    return message("diagnostic_msgs/msg/DiagnosticArray", header(at, ""), list(statuses))


def _status(level: Level, name: str, words: str, part: str, values: dict[str, str]) -> Any:
    pairs = [message("diagnostic_msgs/msg/KeyValue", key, value) for key, value in values.items()]
    return message(
        "diagnostic_msgs/msg/DiagnosticStatus", int(level), name, words or "ok", part, pairs
    )
