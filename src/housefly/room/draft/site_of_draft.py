"""What a draft describes, as the keys of a site file; and places that would suit it."""

from __future__ import annotations

from typing import Any

from housefly.config.site import Site, site_from_tree
from housefly.config.tracking import BRIDGED, TrackingConfig
from housefly.config.validation import validated
from housefly.room.draft.alignment import RigidFit, rigid_fit
from housefly.room.draft.model import DraftDrone, DraftPlace, DraftTracking, SiteDraft
from housefly.room.draft.place_names import entrance_place, named_by_furniture
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.suggestions import clearance_profile
from housefly.room.grid import build_grid
from housefly.room.spots import places_around

_PORTS = {"vicon": 801, "natnet": 1510, "vrpn": 3883}
"""Where real systems listen."""
_PORT_KEYS = {"vicon": "port", "natnet": "natnet_port", "vrpn": "vrpn_port"}


def site_tree(draft: SiteDraft, *, simulated: bool | None = None) -> dict[str, Any]:
    """Return the keys of the site file that a draft needs, by section.

    Args:
        draft: what was said.
        simulated: whether everything is simulated; None is as the draft has it.
    """
    is_real = draft.hardware if simulated is None else not simulated
    manner = clearance_profile(draft)
    name = draft.name or "my room"
    tree: dict[str, Any] = {
        # Its memory is not that of the real room.
        "name": name if is_real or not draft.hardware else f"{name[:48]} simulated",
        "room": {"model": "."},
        "map": {
            "resolution": manner.resolution,
            "flight_height": draft.flight_height,
            "tracking_bound": manner.tracking_bound,
            "margin": manner.margin,
            "virtual_obstacles": [
                {"rectangle": list(zone.rectangle), "reason": zone.reason} for zone in draft.zones
            ],
        },
        "limits": {
            "speed": manner.speed,
            "height_max": max(0.3, round(min(2.0, draft.height - 0.4), 2)),
        },
        "twin": {"enabled": not is_real, "visitor_present": False},
    }
    if is_real and draft.tracking is not None:
        fit = rigid_fit(draft.frame_points) if draft.frame_points else None
        tree["tracking"] = _tracking_tree(draft.tracking, fit)
    if draft.drone is not None:
        tree["drone"] = _drone_tree(draft.drone, is_real=is_real)
    return tree


def _drone_tree(drone: DraftDrone, *, is_real: bool) -> dict[str, str]:
    """Return the keys of ``[drone]``; a simulated one answers where the room puts it."""
    real = {"address": drone.address, "profile": drone.profile} if is_real else {}
    return {"kind": drone.model} | {key: value for key, value in real.items() if value}


def site_of_draft(draft: SiteDraft, *, simulated: bool | None = None) -> Site:
    """Return the checked site of a draft, its room unread.

    Raises:
        ConfigError: naming the key, the value and what is allowed.
    """
    tree = site_tree(draft, simulated=simulated)
    tree.get("drone", {}).pop("profile", None)  # a path from the folder that is written later
    return site_from_tree(tree)


def _tracking_tree(tracking: DraftTracking, fit: RigidFit | None = None) -> dict[str, Any]:
    """Return the keys of ``[tracking]``."""
    tree: dict[str, Any] = {
        "kind": tracking.kind,
        "address": tracking.address,
        "body": tracking.body,
    }
    if tracking.kind == "bridge":
        tree["bridge_system"] = tracking.bridge_system
    wire = BRIDGED.get(tracking.bridge_system) if tracking.kind == "bridge" else tracking.kind
    if wire is not None:
        tree[_PORT_KEYS[wire]] = tracking.port or _PORTS[wire]
    if wire == "vrpn" and tracking.vrpn_transport != "tcp":
        tree["vrpn_transport"] = tracking.vrpn_transport
    if tracking.up_axis != "auto":
        tree["up_axis"] = tracking.up_axis
    if fit is not None:
        tree |= {"x": fit.x, "y": fit.y, "z": fit.z, "yaw": fit.yaw}
    return tree


def tracking_config(tracking: DraftTracking) -> TrackingConfig:
    """Return the part of a site about tracking; raises ConfigError for the first bad key."""
    return validated(TrackingConfig, _tracking_tree(tracking), "tracking")


def suggested_places(draft: SiteDraft) -> tuple[DraftPlace, ...]:
    """Return roomy places that can be reached from the pad, with names that people would give.

    One before the door where the draft has one, a far one and one to each side: each looks at the
    furniture that is nearest, and is called by it.
    """
    room = room_of_draft(draft)
    grid = build_grid(room, site_of_draft(draft, simulated=True))
    if not grid.is_free(grid.cell_of(room.home)):
        return ()
    around = [
        DraftPlace(place.name, *place.viewpoint, place.title)
        for place in places_around(grid, room.home)
    ]
    return (*entrance_place(draft, grid, room.home), *named_by_furniture(around, draft))
