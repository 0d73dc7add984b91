"""The volumes of a site: its no-fly areas and those that people drew in the console."""

from __future__ import annotations

from math import inf

from housefly.config.edits import NoFlyZone
from housefly.config.map import VirtualObstacle
from housefly.config.rectangle import Rectangle
from housefly.config.site import Site
from housefly.config.volumes import VolumeConfig
from housefly.pilot.planning.space.volumes import Volume, VolumeKind


def site_volumes(site: Site) -> tuple[Volume, ...]:
    """Return every volume of a site; a rectangle without heights is closed at every height."""
    drawn: tuple[VirtualObstacle | NoFlyZone, ...] = (
        *site.map.virtual_obstacles,
        *site.edits.zones,
    )
    return (
        *(_closed(area.rectangle, area.reason) for area in drawn),
        *(_of(volume) for volume in site.volumes),
    )


def _of(volume: VolumeConfig) -> Volume:
    return Volume(
        VolumeKind[volume.kind.upper()],
        volume.polygon,
        volume.bottom,
        volume.top,
        inf if volume.speed is None else volume.speed,
        volume.reason,
    )


def _closed(rectangle: Rectangle, reason: str) -> Volume:
    x_min, y_min, x_max, y_max = rectangle
    corners = ((x_min, y_min), (x_max, y_min), (x_max, y_max), (x_min, y_max))
    return Volume(VolumeKind.KEEP_OUT, corners, reason=reason)
