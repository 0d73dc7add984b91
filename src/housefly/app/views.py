"""The room as the console draws it."""

from __future__ import annotations

from housefly.hub.api.grid_view import grid_view
from housefly.hub.api.pilot_queries import OutlineView, PlaceView, RoomView
from housefly.room.model import Solid
from housefly.room.outline import outline
from housefly.room.tracked import untracked, untracked_grid
from housefly.sites.loaded_site import LoadedSite


def room_view(loaded: LoadedSite) -> RoomView:
    """Return everything static that the console draws."""
    site, room = loaded.site, loaded.room
    limits = site.limits
    standing = frozenset(solid.name for solid in untracked(room, site).solids)
    return RoomView(
        site=site.name,
        mode=site.mode,
        bounds=room.bounds,
        grid=grid_view(untracked_grid(room, site, loaded.grid)),
        outlines=tuple(_outline(solid, solid.name not in standing) for solid in room.solids),
        places=tuple(
            PlaceView(p.name, p.title or p.name.capitalize(), p.viewpoint, p.look_at)
            for p in room.places
        ),
        home=room.home,
        flight_height=site.map.flight_height,
        visitor=room.visitor,
        limits={
            "speed": limits.speed,
            "height_max": limits.height_max,
            "battery_floor": limits.battery_floor,
            "pose_age_level": limits.pose_age_level,
            "pose_age_land": limits.pose_age_land,
            "telemetry_age": limits.telemetry_age,
            "hold_timeout": limits.hold_timeout,
            "nudge_speed": limits.nudge_speed if site.flies_in_space else 0.0,
        },
    )


def _outline(solid: Solid, tracked: bool) -> OutlineView:
    red, green, blue, _ = solid.colour
    colour = f"#{round(red * 255):02x}{round(green * 255):02x}{round(blue * 255):02x}"
    return OutlineView(
        solid.thing, outline(solid), solid.position[2] + solid.size[2] / 2, colour, tracked
    )
