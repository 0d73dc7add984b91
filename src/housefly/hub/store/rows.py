"""Values as rows of the tables, and back."""

from __future__ import annotations

import json
from collections.abc import Sequence
from math import isfinite

from housefly.geometry import Quaternion, Vec3
from housefly.hub.store.database import Row
from housefly.hub.things.thing import Kind, Thing, Viewpoint
from housefly.messages import Covariance, Facts, Happening, Observation

NOWHERE: Row = (None, None, None)
UNTURNED: Row = (None, None, None, None)

POSE = "x, y, z, qw, qx, qy, qz"
SAMPLE = f"received_at, {POSE}, covariance, inside, facts"
THING = f"id, name, kind, {POSE}, inside, facts"
EVENT = "at, kind, thing, source, cause, confidence, facts"
VIEWPOINT = "name, robot, x, y, z, yaw, pitch"


def row_of_sample(sample: Observation) -> Row:
    """Return the columns ``SAMPLE``; a position that is no number is no position."""
    return (
        sample.received_at,
        *(sample.position if is_placed(sample) else NOWHERE),  # type: ignore[misc]
        *(sample.orientation or UNTURNED),
        json.dumps(sample.covariance) if sample.covariance else "",
        sample.inside,
        _text_of(sample.facts),
    )


def sample_of(row: Row) -> Observation:
    """Return a sample from the columns thing, source, captured_at, valid and ``SAMPLE``."""
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
        facts=_facts(facts),
    )


def is_placed(sample: Observation) -> bool:
    """Tell whether a sample has a position of finite numbers."""
    return sample.position is not None and all(map(isfinite, sample.position))


def is_valid(sample: Observation) -> bool:
    """Tell whether a sample is kept as valid: its source stands by it, and a position is one of
    finite numbers.
    """
    return sample.valid and (sample.position is None or is_placed(sample))


def row_of_happening(happening: Happening) -> Row:
    """Return the columns ``EVENT``."""
    h = happening
    return h.at, h.kind, h.thing, h.source, h.cause, h.confidence, _text_of(h.facts)


def happening_of(row: Row) -> Happening:
    """Return what happened from the columns ``EVENT``."""
    at, kind, thing, source, cause, confidence, facts = row
    return Happening(kind, thing, at, source, cause, confidence, _facts(facts))


def row_of_thing(thing: Thing) -> Row:
    """Return the columns ``THING``."""
    pose = (*(thing.position or NOWHERE), *(thing.orientation or UNTURNED))
    return thing.id, thing.name, thing.kind.value, *pose, thing.inside, _text_of(thing.facts)


def row_of_viewpoint(viewpoint: Viewpoint) -> Row:
    """Return the columns ``VIEWPOINT``."""
    return viewpoint.name, viewpoint.robot, *viewpoint.position, viewpoint.yaw, viewpoint.pitch


def thing_of(row: Row, aliases: Sequence[str], viewpoints: Sequence[Row]) -> Thing:
    """Return a thing from the columns ``THING``, its other names and its ``VIEWPOINT`` rows."""
    id_, name, kind, x, y, z, qw, qx, qy, qz, inside, facts = row
    seen_from = tuple(
        Viewpoint(view, (vx, vy, vz), yaw, pitch, robot)
        for view, robot, vx, vy, vz, yaw, pitch in viewpoints
    )
    return Thing(
        id_,
        name,
        Kind(kind),
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
    return json.dumps(dict(facts)) if facts else ""


def _facts(text: str) -> Facts:
    return tuple(json.loads(text).items()) if text else ()
