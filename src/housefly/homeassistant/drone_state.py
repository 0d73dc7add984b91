"""What a drone does, in the words of a vacuum cleaner, and where it is."""

from __future__ import annotations

import json
from collections.abc import Iterable
from math import degrees, dist, hypot, radians

from housefly.geometry import Vec2, wrap_angle
from housefly.homeassistant.drone_entities import drone_key
from housefly.homeassistant.topics import HomeTopics
from housefly.messages import DroneStatus, Estimate, Phase, PilotStep, SafetyMode
from housefly.room.model import Place

_ON_PAD = 0.5
"""Who stands no further from the pad is docked [m]."""
_AT_PLACE = 1.5
"""Who is further from every place is somewhere in the room [m]."""
_MOVED, _TURNED = 0.1, radians(10.0)
"""Who has moved or turned by less stands where it stood [m], [rad]."""
_BY_SAFETY = {
    SafetyMode.CUT: "error",
    SafetyMode.LAND: "error",
    SafetyMode.DESCEND: "error",
    SafetyMode.STOPPED: "paused",
    SafetyMode.HOLD: "paused",
    SafetyMode.RETURN: "returning",
}
"""In flight the safety gate's word goes before that of the mission."""
_BY_PHASE = {
    Phase.TAKING_OFF: "cleaning",
    Phase.OUTBOUND: "cleaning",
    Phase.LOOKING: "cleaning",
    Phase.HOLDING: "paused",
    Phase.RETURNING: "returning",
    Phase.LANDING: "returning",
}


def is_flying(step: PilotStep) -> bool:
    """Return whether a drone is under way."""
    return step.outputs.phase is not Phase.IDLE


def vacuum_state(step: PilotStep, pad: Vec2) -> str:
    """Return docked, idle, cleaning, returning, paused or error.

    Args:
        step: the newest of its pilot.
        pad: where it starts and lands, world xy [m].
    """
    out, report = step.outputs, step.inputs.telemetry
    is_broken = report is not None and report.status is DroneStatus.EMERGENCY
    if out.safety is SafetyMode.CUT or is_broken:
        return "error"
    if is_flying(step):
        return _BY_SAFETY.get(out.safety) or _BY_PHASE[out.phase]
    if out.estimate is None:
        return "idle"
    x, y, _ = out.estimate.position
    return "docked" if hypot(x - pad[0], y - pad[1]) <= _ON_PAD else "idle"


def shown_estimate(before: Estimate | None, step: PilotStep) -> Estimate | None:
    """Return where a drone is shown: where it was, until it has moved; noise is no news."""
    now = step.outputs.estimate
    if before is None or now is None:
        return now or before
    is_moved = dist(before.position, now.position) >= _MOVED
    return now if is_moved or abs(wrap_angle(now.yaw - before.yaw)) >= _TURNED else before


def drone_states(
    drone: str,
    step: PilotStep | None,
    estimate: Estimate | None,
    pad: Vec2,
    places: Iterable[Place],
    topics: HomeTopics,
    *,
    is_heard: bool,
) -> dict[str, bytes]:
    """Return what the topics of one drone are to hold; nothing is claimed before its first step."""
    key = drone_key(drone)
    found = {topics.part_availability(key): b"online" if step and is_heard else b"offline"}
    if step is None:
        return found
    out, report = step.outputs, step.inputs.telemetry
    state = vacuum_state(step, pad)
    told = {"phase": out.phase.value, "safety": out.safety.value, "goal": out.goal_name}
    found[topics.state(key)] = _json({"state": state})
    found[topics.attributes(key)] = _json({**told, "reason": str(out.reason)})
    if report is not None:
        found[topics.state(f"{key}-battery")] = f"{100.0 * report.battery:.0f}".encode()
    if estimate is not None:
        (x, y, z), yaw = estimate.position, estimate.yaw
        where = {"x": round(x, 2), "y": round(y, 2), "z": round(z, 2)}
        found[topics.state(f"{key}-place")] = _place(x, y, places).encode()
        found[topics.attributes(f"{key}-place")] = _json(
            {**where, "heading_degrees": round(degrees(yaw))}
        )
    return found


def _place(x: float, y: float, places: Iterable[Place]) -> str:
    """Return the nearest place; two of Home Assistant's own words would mean the house."""
    near = [
        (hypot(x - place.viewpoint[0], y - place.viewpoint[1]), place.title or place.name)
        for place in places
    ]
    distance, name = min(near, default=(float("inf"), ""))
    if distance > _AT_PLACE:
        return "in the room"
    return "pad" if name.lower() in ("home", "not_home", "none") else name


def _json(tree: object) -> bytes:
    return json.dumps(tree, ensure_ascii=False).encode()
