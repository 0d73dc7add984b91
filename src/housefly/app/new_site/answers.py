"""Turns what somebody typed into a changed draft; refuses in words what cannot be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Literal, get_args

from housefly.app.new_site.ros2_map import ROS2_MAP, hear_map, map_topic
from housefly.app.new_site.typed import (
    SIZE,
    after_word,
    split_keys,
    typed_angle,
    typed_number,
    typed_numbers,
    typed_pair,
    unknown_words,
    unquoted,
)
from housefly.config.airframe import airframe_named, airframe_names, is_model
from housefly.config.profile import load_profile
from housefly.config.text import did_you_mean, expanded
from housefly.config.tracking import DRONE_BODY, AddressedTracking
from housefly.errors import ConfigError
from housefly.room.draft.codec import draft_from_json, draft_to_json
from housefly.room.draft.imports.contracts import ImportHints
from housefly.room.draft.imports.imported import imported, imported_ros_map
from housefly.room.draft.missing import DraftStep
from housefly.room.draft.model import (
    DraftBox,
    DraftDrone,
    DraftPlace,
    DraftTracking,
    DraftWall,
    DraftZone,
    FramePoint,
    SiteDraft,
    with_size,
    without_scanned,
)
from housefly.room.draft.site_of_draft import suggested_places

Answer = tuple[SiteDraft, tuple[str, ...]]
"""The changed draft, and what there is to say about it."""

BODY_HEIGHT = 0.05
"""Where tracking sees a drone that stands on the floor [m]."""
_UP_AXES: dict[str, Literal["auto", "y", "z"]] = {"auto": "auto", "y": "y", "z": "z"}
_UNEXPLORED: dict[str, Literal["wall", "free"]] = {"wall": "wall", "free": "free"}


def answered(draft: SiteDraft, step: DraftStep, text: str, folder: Path) -> Answer:
    """Return a draft as an answer changes it, every value checked.

    Args:
        draft: what is known.
        step: what was asked.
        text: what was typed; not empty.
        folder: that file names are relative to.

    Raises:
        ConfigError, RoomError, MissingPartError: saying what is wrong and what is allowed.
    """
    if not text.strip():
        raise ConfigError(step.value, "is empty; type help to see what is allowed")
    changed, words = _ANSWERS[step](draft, text.strip(), folder)
    return draft_from_json(draft_to_json(changed)), words


def _room(draft: SiteDraft, text: str, folder: Path) -> Answer:
    size = SIZE.fullmatch(text)
    if size:
        length, width, height = (float(part) if part else 2.5 for part in size.groups())
        return with_size(draft, length, width, height), ()
    if text.startswith(ROS2_MAP):
        return _room_of_ros2(draft, text)
    name, keys = split_keys(text, ("unit", "up", "layers", "unexplored"))
    if not Path(name).suffix[1:2].isalpha():
        raise ConfigError(
            "room",
            f"is {name!r}; allowed: a size such as 6x4x2.5 (metres, decimal points), a file, or"
            " ros2:/map",
        )
    up = keys.get("up", "auto")
    if up not in _UP_AXES:
        raise ConfigError("up", f"is {up!r}; allowed: y, z")
    hints = ImportHints(
        unit=typed_number(keys["unit"], "unit") if "unit" in keys else None,
        up=_UP_AXES[up],
        layers=tuple(part for part in keys.get("layers", "").split(",") if part),
        unexplored=_unexplored(keys),
    )
    path = expanded(name, "room")
    found = imported(draft, path if path.is_absolute() else folder / path, hints)
    return found.draft, found.notes


def _room_of_ros2(draft: SiteDraft, text: str) -> Answer:
    """Return the draft with the room of a map that a ROS node publishes now."""
    source, keys = split_keys(text, ("domain", "discovery", "unexplored"))
    topic, hints = map_topic(source, keys), ImportHints(unexplored=_unexplored(keys))
    found = imported_ros_map(draft, hear_map(topic), topic.source, hints)
    return found.draft, found.notes


def _unexplored(keys: dict[str, str]) -> Literal["wall", "free"]:
    said = keys.get("unexplored", "wall")
    if said not in _UNEXPLORED:
        raise ConfigError("unexplored", f"is {said!r}; allowed: wall, free")
    return _UNEXPLORED[said]


def _objects(draft: SiteDraft, text: str, _: Path) -> Answer:
    if name := after_word("remove", text):
        kept = tuple(box for box in draft.furniture if box.name != name)
        if kept == draft.furniture:
            raise ConfigError("remove", unknown_words(name, [box.name for box in draft.furniture]))
        return replace(draft, furniture=kept), ()
    if corners := after_word("erase", text):
        x0, y0, x1, y1 = typed_numbers(corners, 4, "erase", "x_min,y_min,x_max,y_max")
        changed = without_scanned(draft, (x0, y0, x1, y1))
        return changed, (f"{len(draft.scanned) - len(changed.scanned)} boxes erased",)
    if line := after_word("wall", text):
        parts = line.split()
        if len(parts) == 2 and all("," in part for part in parts):
            start, end = (typed_pair(part, "wall") for part in parts)
            return replace(draft, walls=(*draft.walls, DraftWall(start, end))), ()
    rest, keys = split_keys(text, ("from", "turn"))
    words = rest.split()
    if len(words) < 3 or not SIZE.fullmatch(words[-1]):
        raise ConfigError(
            "furniture", f"is {text!r}; allowed: NAME X,Y LENGTHxWIDTHxHEIGHT, in metres"
        )
    size = SIZE.fullmatch(words[-1])
    assert size is not None
    if size.group(3) is None:
        raise ConfigError("furniture", "say its height, too: LENGTHxWIDTHxHEIGHT, in metres")
    length, width, height = (float(part) for part in size.groups())
    (x, y), name = typed_pair(words[-2], "furniture"), " ".join(words[:-2])
    bottom = typed_number(keys["from"], "from") if "from" in keys else 0.0
    yaw = typed_angle(keys["turn"]) if "turn" in keys else 0.0
    box = DraftBox(name, x, y, length, width, round(bottom + height, 4), bottom, yaw)
    others = tuple(other for other in draft.furniture if other.name != name)
    return replace(draft, furniture=(*others, box)), ()


def _pad(draft: SiteDraft, text: str, _: Path) -> Answer:
    words = text.replace(", ", ",").split()
    pad = typed_pair(words[0], "pad")
    yaw = typed_angle(words[1]) if len(words) > 1 else draft.pad_yaw
    return replace(draft, pad=pad, pad_yaw=yaw), ()


def _places(draft: SiteDraft, text: str, _: Path) -> Answer:
    if text == "auto":
        places = suggested_places(draft)
        told = ", ".join(f"{place.name} {place.x:g},{place.y:g}" for place in places)
        return replace(draft, places=places), (f"places: {told or 'none fits'}",)
    if name := after_word("remove", text):
        kept = tuple(place for place in draft.places if place.name != name)
        if kept == draft.places:
            raise ConfigError("remove", unknown_words(name, [place.name for place in draft.places]))
        return replace(draft, places=kept), ()
    rest, keys = split_keys(text, ("look",))
    words = rest.split()
    if len(words) < 2:
        raise ConfigError("place", f"is {text!r}; allowed: NAME X,Y in metres")
    name, (x, y) = " ".join(words[:-1]).lower(), typed_pair(words[-1], "place")
    look_at = None
    if "look" in keys:
        a, b, c = typed_numbers(keys["look"], 3, "look", "x,y,z")
        look_at = (a, b, c)
    if name == "home":
        raise ConfigError("place", "home is the pad's own name; choose another")
    others = tuple(place for place in draft.places if place.name != name)
    return replace(draft, places=(*others, DraftPlace(name, x, y, "", look_at))), ()


def _zones(draft: SiteDraft, text: str, _: Path) -> Answer:
    if reason := after_word("remove", text):
        kept = tuple(zone for zone in draft.zones if zone.reason != reason)
        if kept == draft.zones:
            raise ConfigError(
                "remove", unknown_words(reason, [zone.reason for zone in draft.zones])
            )
        return replace(draft, zones=kept), ()
    corners, _space, reason = text.partition(" ")
    x0, y0, x1, y1 = typed_numbers(corners, 4, "zone", "x_min,y_min,x_max,y_max REASON")
    if not reason.strip():
        raise ConfigError("zone", "say why, behind the four numbers: the map shows it")
    low, high = (min(x0, x1), min(y0, y1)), (max(x0, x1), max(y0, y1))
    return replace(draft, zones=(*draft.zones, DraftZone((*low, *high), reason.strip()))), ()


def _tracking(draft: SiteDraft, text: str, _: Path) -> Answer:
    if text == "simulated":
        return replace(draft, hardware=False), ()
    rest, keys = split_keys(text, ("up", "transport"))
    words = rest.split(maxsplit=2)  # a body's name may have spaces: Motive's own is "Rigid Body 1"
    kind, _colon, system = words[0].partition(":")
    if kind not in get_args(AddressedTracking) or len(words) < 2:
        kinds = ", ".join(get_args(AddressedTracking))
        raise ConfigError(
            "tracking",
            f"is {text!r}; allowed: simulated, or KIND ADDRESS BODY, KIND one of {kinds}, BODY the"
            " drone's name in that software",
        )
    address, _colon, port = words[1].partition(":")
    if port and not port.isdigit():
        raise ConfigError("port", f"is {port!r}; allowed: a number from 1 to 65535")
    plain = {
        "kind": kind,
        "address": address,
        "port": int(port) if port else None,
        "body": unquoted(words[2]) if len(words) == 3 else DRONE_BODY,
    }
    plain |= {"bridge_system": system} if system else {}
    plain |= {"up_axis": keys["up"]} if "up" in keys else {}
    plain |= {"vrpn_transport": keys["transport"]} if "transport" in keys else {}
    tracking = DraftTracking(**plain)  # type: ignore[arg-type]
    moved = draft.tracking != tracking
    points = () if moved else draft.frame_points
    return replace(draft, hardware=True, tracking=tracking, frame_points=points), ()


def _frame(draft: SiteDraft, text: str, _: Path) -> Answer:
    if text == "again":
        return replace(draft, frame_points=()), ("the points are forgotten",)
    where, _equals, seen = text.partition("=")
    x, y = place_of_point(draft, where.strip())
    a, b, c = typed_numbers(seen.strip(), 3, "point", "X,Y = X,Y,Z as tracking sees it")
    return with_frame_point(draft, (x, y), (a, b, c)), ()


def place_of_point(draft: SiteDraft, text: str) -> tuple[float, float]:
    """Return where on the map a point for the tracking frame is [m]; raises ConfigError."""
    if text == "pad":
        if draft.pad is None:
            raise ConfigError("point", "the pad's place is not known yet; type x,y")
        return draft.pad
    return typed_pair(text, "point")


def with_frame_point(
    draft: SiteDraft, on_map: tuple[float, float], seen: tuple[float, float, float]
) -> SiteDraft:
    """Return the draft with one more point for the tracking frame; the same place replaces."""
    others = tuple(point for point in draft.frame_points if point.on_map[:2] != on_map)
    point = FramePoint(f"({on_map[0]:g}, {on_map[1]:g})", (*on_map, BODY_HEIGHT), seen)
    return replace(draft, frame_points=(*others, point))


def _drone(draft: SiteDraft, text: str, folder: Path) -> Answer:
    rest, keys = split_keys(text, ("profile",))
    known = draft.drone or DraftDrone()
    model, address = _model_and_address(rest, known.model)
    is_same = model == known.model
    profile = keys.get("profile", known.profile if is_same else "")
    if profile:
        path = (folder / expanded(profile, "profile")).resolve()
        load_profile(path)
        profile = str(path)
    there = known.address if is_same else airframe_named(model).usual_address
    return replace(draft, drone=DraftDrone(address or there, profile, model)), ()


def _model_and_address(text: str, known: str) -> tuple[str, str]:
    """Return the model that was typed, or the known one, and the address, "" for none."""
    model, sign, address = text.partition("://")
    if sign and is_model(model):
        return model, address
    words = text.split()
    if len(words) == 2 and is_model(words[0]):
        return words[0], words[1]
    if len(words) == 1 and is_model(text):
        return text, ""
    if len(words) == 1 and (not text.isidentifier() or "." in text):
        return known, text
    models = airframe_names()
    meant = did_you_mean(words[0], models) if words else ""
    allowed = f"MODEL ADDRESS, as tello 192.168.10.1, MODEL one of {', '.join(models)}"
    raise ConfigError("drone", f"is {text!r}{meant or f'; allowed: {allowed}'}")


_ANSWERS: dict[DraftStep, Callable[[SiteDraft, str, Path], Answer]] = {
    DraftStep.ROOM: _room,
    DraftStep.OBJECTS: _objects,
    DraftStep.PAD: _pad,
    DraftStep.PLACES: _places,
    DraftStep.ZONES: _zones,
    DraftStep.TRACKING: _tracking,
    DraftStep.FRAME: _frame,
    DraftStep.DRONE: _drone,
}
