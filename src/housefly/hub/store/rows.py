"""Converts values to table rows and back."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import isfinite

from housefly.geometry import Quaternion, Vec3
from housefly.hub.situations.hysteresis import NOT_KNOWN, UNKNOWN
from housefly.hub.store.database import Row
from housefly.hub.things.thing import NamedPose, Thing, ThingKind
from housefly.messages import Covariance, Facts, Observation, RoomEvent
from housefly.messages.words import from_tree, with_trees

_NO_POSITION: Row = (None, None, None)
_NO_ORIENTATION: Row = (None, None, None, None)

_POSE_COLUMNS = "x, y, z, qw, qx, qy, qz"
SAMPLE_COLUMNS = f"received_at, {_POSE_COLUMNS}, covariance, inside, facts"
THING_COLUMNS = f"id, name, kind, {_POSE_COLUMNS}, inside, facts"
EVENT_COLUMNS = "at, kind, thing, source, cause, confidence, facts"
VIEWPOINT_COLUMNS = "name, robot, x, y, z, yaw, pitch"


def row_of_sample(sample: Observation) -> Row:
    """Return the columns ``SAMPLE_COLUMNS``; a position that is not finite is stored as none."""
    return (
        sample.received_at,
        *(sample.position if _has_position(sample) else _NO_POSITION),  # type: ignore[misc]
        *(sample.orientation or _NO_ORIENTATION),
        json.dumps(sample.covariance) if sample.covariance else "",
        sample.inside,
        _text_of(sample.facts),
    )


def sample_from_row(row: Row) -> Observation:
    """Return a sample from thing, source, captured_at, valid and ``SAMPLE_COLUMNS``."""
    (
        thing,
        source,
        captured_at,
        valid,
        received_at,
        x,
        y,
        z,
        qw,
        qx,
        qy,
        qz,
        covariance,
        inside,
        facts,
    ) = row
    return Observation(
        thing=thing,
        source=source,
        captured_at=captured_at,
        received_at=received_at,
        position=_vector(x, y, z),
        orientation=_quaternion(qw, qx, qy, qz),
        covariance=_covariance(covariance),
        inside=inside,
        valid=bool(valid),
        facts=_renewed(_facts(facts)),
    )


def _has_position(sample: Observation) -> bool:
    """Return whether a sample has a finite position."""
    return sample.position is not None and all(map(isfinite, sample.position))


def is_valid(sample: Observation) -> bool:
    """Return whether a sample is stored as valid: marked valid, and its position finite if any."""
    return sample.valid and (sample.position is None or _has_position(sample))


def row_of_event(event: RoomEvent) -> Row:
    """Return the columns ``EVENT_COLUMNS``."""
    h = event
    return h.at, h.kind, h.thing, h.source, h.cause, h.confidence, _text_of(h.facts)


def event_from_row(row: Row) -> RoomEvent:
    """Return an event from the columns ``EVENT_COLUMNS``."""
    at, kind, thing, source, cause, confidence, facts = row
    return RoomEvent(kind, thing, at, source, cause, confidence, _renewed(_facts(facts)))


def row_of_thing(thing: Thing) -> Row:
    """Return the columns ``THING_COLUMNS``."""
    pose = (*(thing.position or _NO_POSITION), *(thing.orientation or _NO_ORIENTATION))
    return thing.id, thing.name, thing.kind.value, *pose, thing.inside, _text_of(thing.facts)


def row_of_viewpoint(viewpoint: NamedPose) -> Row:
    """Return the columns ``VIEWPOINT_COLUMNS``."""
    return viewpoint.name, viewpoint.robot, *viewpoint.position, viewpoint.yaw, viewpoint.pitch


def thing_from_row(row: Row, aliases: Sequence[str], viewpoints: Sequence[Row]) -> Thing:
    """Return a thing from ``THING_COLUMNS``, its aliases and its ``VIEWPOINT_COLUMNS`` rows."""
    id_, name, kind, x, y, z, qw, qx, qy, qz, inside, facts = row
    seen_from = tuple(
        NamedPose(view, (vx, vy, vz), yaw, pitch, robot)
        for view, robot, vx, vy, vz, yaw, pitch in viewpoints
    )
    return Thing(
        id_,
        name,
        ThingKind(kind),
        tuple(aliases),
        _vector(x, y, z),
        _quaternion(qw, qx, qy, qz),
        inside,
        seen_from,
        _facts(facts),
    )


def _vector(x: float | None, y: float | None, z: float | None) -> Vec3 | None:
    return None if x is None or y is None or z is None else (x, y, z)


def _quaternion(
    w: float | None, x: float | None, y: float | None, z: float | None
) -> Quaternion | None:
    return None if w is None or x is None or y is None or z is None else (w, x, y, z)


def _covariance(text: str) -> Covariance | None:
    if not text:
        return None
    xx, xy, xz, yy, yz, zz = json.loads(text)
    return xx, xy, xz, yy, yz, zz


def _text_of(facts: Facts) -> str:
    """Return facts as JSON; words keep their template, as a list (``messages.words.tree``)."""
    return json.dumps(with_trees(facts)) if facts else ""


def _facts(text: str) -> Facts:
    read = json.loads(text).items() if text else ()
    return tuple(
        (name, from_tree(value) if isinstance(value, list) else value) for name, value in read
    )


def _renewed(facts: Facts) -> Facts:
    """Return facts with those that stood only in a sentence of 0.2.0.

    The sources of an event's evidence ("bed: load 58 kg; last seen beside bed"), that an end only
    says that its situation is unknown, and which key of a device was refused ("open is 'ajar'").
    """
    known = dict(facts)
    if "refused" in known and "refused_key" not in known:
        facts = (*facts, ("refused_key", str(known["refused"]).partition(" ")[0]))
    if "evidence" in known and "sources" not in known:
        facts = (*facts, ("sources", ",".join(_sources_in(str(known["evidence"])))))
    if known.get("because") == NOT_KNOWN and UNKNOWN not in facts:
        facts = (*facts, UNKNOWN)
    return facts


def _sources_in(evidence: str) -> tuple[str, ...]:
    heads = (part.partition(":") for part in evidence.split("; "))
    return tuple(dict.fromkeys(head for head, colon, _ in heads if colon and " " not in head))
