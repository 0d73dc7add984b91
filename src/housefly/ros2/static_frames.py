"""Frames that stand still in another: pads, sensors and cameras, all in one message."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from housefly.config.site import Site
from housefly.geometry import Quaternion, Vec3, quaternion_from_euler, quaternion_product
from housefly.record.ros_messages import about_z, header, message, transform
from housefly.record.ros_topics import topic_part
from housefly.room.model import Room
from housefly.ros2.drone_messages import RosFrames
from housefly.sites.loaded_site import LoadedSite

_OPTICAL: Quaternion = (0.5, -0.5, 0.5, -0.5)
"""From a camera that looks forward to its optical frame: z ahead, x right, y down (REP-103)."""


@dataclass(frozen=True, slots=True)
class StaticFrame:
    """A frame in another.

    Attributes:
        parent: name of the other.
        child: its own name.
        position: of its origin in the other [m].
        orientation: (w, x, y, z), from its axes to those of the other.
    """

    parent: str
    child: str
    position: Vec3
    orientation: Quaternion


def static_frames(loaded: LoadedSite) -> tuple[StaticFrame, ...]:
    """Return all frames of a site that stand still.

    What looks has an optical frame: z ahead, x right, y down. A scanner's x is its front. A depth
    camera's place is known in the simulated room only: a real one tells it with each image.
    """
    site, room = loaded.site, loaded.room
    return (
        *_of_drones(site, room),
        *(
            StaticFrame(
                site.ros2.frame,
                f"lasers/{topic_part(laser.name)}",
                (laser.x, laser.y, laser.z),
                about_z(laser.yaw),
            )
            for laser in site.lasers
        ),
        *(_depth_cameras(site) if site.twin.enabled else ()),
        *(
            StaticFrame(
                site.ros2.frame,
                f"tracking_cameras/{topic_part(camera.name)}_optical_frame",
                camera.position,
                camera.orientation,
            )
            for camera in room.cameras
        ),
    )


def static_transforms(at: float, frames: Iterable[StaticFrame]) -> Any:
    """Return tf2_msgs/TFMessage of all of them: of a latched topic only the newest is kept."""
    stamped = [
        message(
            "geometry_msgs/msg/TransformStamped",
            header(at, frame.parent),
            frame.child,
            transform(frame.position, frame.orientation),
        )
        for frame in frames
    ]
    return message("tf2_msgs/msg/TFMessage", stamped)


def _of_drones(site: Site, room: Room) -> Iterator[StaticFrame]:
    for drone in site.all_drones:
        if not drone.enabled:
            continue
        name = topic_part(drone.name)
        frames = RosFrames.of(site.ros2.frame, name)
        x, y, yaw = drone.pad or (*room.home, room.home_yaw)
        yield StaticFrame(frames.world, f"{name}/pad", (x, y, 0.0), about_z(yaw))
        camera = drone.airframe.capabilities.camera
        if camera is not None:
            yield StaticFrame(frames.body, frames.optical, (camera.ahead, 0.0, 0.0), _OPTICAL)


def _depth_cameras(site: Site) -> Iterator[StaticFrame]:
    for camera in site.depth_cameras:
        looks = quaternion_from_euler(0.0, camera.pitch, camera.yaw)
        yield StaticFrame(
            site.ros2.frame,
            f"depth_cameras/{topic_part(camera.name)}_optical_frame",
            (camera.x, camera.y, camera.z),
            quaternion_product(looks, _OPTICAL),
        )
