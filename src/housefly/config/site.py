"""One typed tree from the site's TOML file; every value is checked for type, range, unit and
combination.

A site names the room, the drone, the tracking system and the limits. All numbers are SI; a key
whose unit is not SI says so in its name. ``docs/site.md`` lists every key, made from this file.
"""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any, Literal, Self

from pydantic import Field, ValidationError, model_validator

from housefly.config.depth import DepthCameraConfig, check_depth_cameras
from housefly.config.devices import MqttConfig
from housefly.config.edits import Edits
from housefly.config.furniture import FurnitureConfig, check_furniture
from housefly.config.hub import HubConfig
from housefly.config.laser import LaserConfig, check_lasers
from housefly.config.profile import load_profile
from housefly.config.section import Section as Section
from housefly.config.section import explain as explain
from housefly.config.section import is_multicast_group
from housefly.config.section import port_number as port_number
from housefly.config.section import quantity as quantity
from housefly.config.tracking import BRIDGED as BRIDGED
from housefly.config.tracking import MocapWire as MocapWire
from housefly.config.tracking import TrackingConfig as TrackingConfig
from housefly.config.tracking import TrackingKind as TrackingKind
from housefly.errors import ConfigError


class RoomConfig(Section):
    """Which room the drone flies in."""

    model: str = Field(
        default="bsen",
        description="a built-in room (bsen) or the path of a room directory, relative to this file",
    )


Rectangle = tuple[float, float, float, float]


def _check_rectangle(rectangle: Rectangle) -> None:
    x_min, y_min, x_max, y_max = rectangle
    if not (x_min < x_max and y_min < y_max):
        raise ValueError(
            "a rectangle is x_min, y_min, x_max, y_max [m] with x_min < x_max and y_min < y_max"
        )


class VirtualObstacle(Section):
    """A part of the floor plan that the drone must not enter although nothing stands there."""

    rectangle: Rectangle = Field(description="x_min, y_min, x_max, y_max [m]")
    reason: str = Field(default="", description="shown on the map")

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        _check_rectangle(self.rectangle)
        return self


class MapConfig(Section):
    """The occupancy grid and how obstacles grow on it."""

    resolution: float = quantity(0.1, 0.02, 1.0, "m", "edge of a grid cell")
    flight_height: float = quantity(
        1.1, 0.3, 2.5, "m", "height that the grid is cut at and that the drone flies at"
    )
    half_band: float = quantity(
        0.25, 0.0, 1.0, "m", "obstacles within flight_height plus or minus this count"
    )
    tracking_bound: float = quantity(0.10, 0.0, 1.0, "m", "largest expected distance from the path")
    margin: float = quantity(0.05, 0.0, 1.0, "m", "extra distance kept from everything")
    paper_rectangle: Rectangle = Field(
        default=(2.3, 0.5, 14.8, 5.0),
        description=(
            "part of the room that mode paper's 25 x 9 grid covers: x_min, y_min, x_max, y_max [m]"
        ),
    )
    paper_resolution: float = quantity(0.5, 0.1, 1.0, "m", "edge of a grid cell in mode paper")
    virtual_obstacles: tuple[VirtualObstacle, ...] = Field(
        default=(), description="places kept free by order"
    )
    paper_virtual_obstacles: tuple[VirtualObstacle, ...] = Field(
        default=(), description="the same, in mode paper"
    )

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        _check_rectangle(self.paper_rectangle)
        return self


class DroneConfig(Section):
    """The drone and where it answers."""

    kind: Literal["ardrone"] = Field(default="ardrone", description="driver")
    address: str = Field(
        default="127.0.0.1", description="IP address; a real AR.Drone 2.0 is 192.168.1.1"
    )
    hull_length: float = quantity(0.517, 0.05, 2.0, "m", "longer side of the hull")
    hull_width: float = quantity(0.451, 0.05, 2.0, "m", "shorter side of the hull")
    attitude_lag: float = quantity(
        7.0, 0.5, 50.0, "1/s", "lambda of paper eq. (22): pole of the attitude response"
    )
    attitude_gain: float = quantity(
        1.0, 0.2, 2.0, "1", "c / lambda of paper eq. (22): achieved over commanded angle"
    )
    drag: float = quantity(0.58, 0.0, 5.0, "1/s", "linear drag over mass")
    command_delay: float = quantity(0.06, 0.0, 0.5, "s", "from command to first reaction")
    climb_lag: float = quantity(1.4, 0.2, 50.0, "1/s", "pole of the climb rate response")
    yaw_lag: float = quantity(25.0, 0.2, 50.0, "1/s", "pole of the yaw rate response")
    profile: str = Field(
        default="",
        description=(
            "drone profile of housefly identify, relative to this file; gives the constants"
        ),
    )
    has_video: bool = Field(default=True, description="whether to open the camera stream")


class LimitsConfig(Section):
    """What the drone may do."""

    tilt_max: float = quantity(0.21, 0.02, 0.5, "rad", "largest pitch or roll (paper: 0.21)")
    vertical_speed_max: float = quantity(0.7, 0.05, 2.0, "m/s", "largest climb or sink rate")
    yaw_rate_max: float = quantity(1.75, 0.1, 6.2, "rad/s", "largest yaw rate")
    speed: float = quantity(0.5, 0.05, 2.0, "m/s", "cruise speed along a path")
    height_min: float = quantity(0.3, 0.1, 3.0, "m", "lowest height to fly at")
    height_max: float = quantity(2.0, 0.3, 10.0, "m", "highest height to fly at")
    battery_floor: float = quantity(
        0.15, 0.05, 0.9, "1", "land below this charge; no take-off below it plus 0.05"
    )
    pose_age_level: float = quantity(0.25, 0.05, 2.0, "s", "level the drone when the pose is older")
    pose_age_land: float = quantity(2.0, 0.3, 10.0, "s", "land when the pose is older")
    telemetry_age: float = quantity(
        1.0, 0.1, 10.0, "s", "land when the drone's own report is older"
    )
    fence_margin: float = quantity(
        1.0, 0.2, 5.0, "m", "land when further outside the map than this"
    )
    take_off_timeout: float = quantity(
        10.0, 2.0, 60.0, "s", "give up a take-off that is not acknowledged"
    )
    landing_timeout: float = quantity(
        15.0, 2.0, 60.0, "s", "report a landing that is not acknowledged"
    )

    @model_validator(mode="after")
    def _combinations(self) -> Self:
        if self.height_min >= self.height_max:
            raise ValueError(
                f"height_min ({self.height_min} m) must be below height_max ({self.height_max} m)"
            )
        if self.pose_age_level >= self.pose_age_land:
            raise ValueError(
                f"pose_age_level ({self.pose_age_level} s) must be below pose_age_land"
                f" ({self.pose_age_land} s)"
            )
        return self


class ControlConfig(Section):
    """Gains of paper eqs. (20)-(21) in the consistent sign convention, and of the P laws."""

    alpha: float = quantity(
        3.6, 0.1, 20.0, "1/s", "damping gain: a = alpha * velocity error + beta * position error"
    )
    beta: float = quantity(3.24, 0.05, 50.0, "1/s^2", "stiffness gain")
    yaw_gain: float = quantity(1.5, 0.1, 10.0, "1/s", "K1: yaw rate per yaw error")
    height_gain: float = quantity(1.2, 0.1, 10.0, "1/s", "K2: climb rate per height error")
    epsilon_height: float = quantity(0.2, 0.01, 1.0, "m", "eps1 of the finite state acceptor")
    epsilon_yaw: float = quantity(
        0.35, 0.001, 1.5, "rad", "eps2; mode paper uses the printed 0.2 deg"
    )
    epsilon_position: float = quantity(
        0.15, 0.02, 1.0, "m", "eps3; mode paper uses the printed 0.4 m"
    )
    dwell: float = quantity(
        0.3, 0.0, 5.0, "s", "shortest stay in a state of the acceptor (mode default)"
    )
    rate_hz: float = quantity(100.0, 20.0, 200.0, "Hz", "pilot loop frequency")
    acceleration_noise: float = quantity(
        0.4, 0.01, 20.0, "m/s^2", "Kalman filter: one-sigma unmodelled acceleration"
    )
    position_noise: float = quantity(
        0.003, 0.0001, 1.0, "m", "Kalman filter: one-sigma tracking noise"
    )


class TwinConfig(Section):
    """The simulated drone and the simulated tracking system."""

    enabled: bool = Field(default=True, description="start the twin; false with real hardware")
    seed: int = Field(
        default=1,
        ge=0,
        le=2**31 - 1,
        description="seed of all noise",
        json_schema_extra={"unit": "1"},
    )
    mocap_rate_hz: float = quantity(
        100.0, 1.0, 200.0, "Hz", "frames per second of the tracking system"
    )
    mocap_latency: float = quantity(0.02, 0.0, 0.5, "s", "from exposure to sending")
    mocap_noise: float = quantity(0.001, 0.0, 0.1, "m", "one-sigma position noise")
    mocap_dropout: float = quantity(0.0, 0.0, 1.0, "1", "share of frames lost")
    mocap_wires: tuple[MocapWire, ...] = Field(
        default=(),
        description=(
            "systems that the twin poses as beside that of tracking.kind: vicon, natnet, vrpn"
        ),
    )
    natnet_version: Literal["3.1", "4.1"] = Field(
        default="3.1", description="protocol version of the twin's NatNet server"
    )
    natnet_data_port: int = port_number(1511, "UDP port of the twin's NatNet multicast")
    natnet_group: str = Field(
        default="", description='multicast group of the twin, as 239.255.42.99; "" serves unicast'
    )
    command_delay: float = quantity(
        0.06, 0.0, 0.5, "s", "from command to first reaction of the drone"
    )
    battery: float = quantity(1.0, 0.0, 1.0, "1", "charge at the start")
    visitor_present: bool = Field(default=True, description="whether someone stands at the door")
    scene: str = Field(
        default="",
        description=(
            'people and things that move: "bsen", or a file relative to this one; "" for none'
        ),
    )
    video: bool = Field(default=True, description="whether the drone's camera is simulated")
    video_rate_hz: float = quantity(30.0, 1.0, 60.0, "Hz", "pictures per second")
    laser_noise: float = quantity(0.01, 0.0, 0.2, "m", "one-sigma noise of a scanner's distances")
    laser_dropout: float = quantity(
        0.002, 0.0, 1.0, "1", "share of a scanner's beams that come back empty"
    )

    @model_validator(mode="after")
    def _group(self) -> Self:
        if self.natnet_group and not is_multicast_group(self.natnet_group):
            raise ValueError(
                f"natnet_group ({self.natnet_group}) must be an IPv4 multicast address, 224.0.0.0"
                " to 239.255.255.255"
            )
        return self


class WebConfig(Section):
    """Where the console listens."""

    host: str = Field(
        default="127.0.0.1", description="address to listen on; only loopback is safe"
    )
    port: int = Field(
        default=8080,
        ge=0,
        le=65535,
        description="TCP port; 0 chooses a free one",
        json_schema_extra={"unit": "1"},
    )


Mode = Literal["default", "paper"]


class Site(Section):
    """Everything that differs between two places where Housefly flies."""

    name: str = Field(
        default="B-sen", min_length=1, max_length=60, description="shown in the console"
    )
    mode: Mode = Field(
        default="default",
        description="default, or paper: the paper's chain with its traps, as the baseline",
    )
    room: RoomConfig = RoomConfig()
    map: MapConfig = MapConfig()
    drone: DroneConfig = DroneConfig()
    tracking: TrackingConfig = TrackingConfig()
    limits: LimitsConfig = LimitsConfig()
    control: ControlConfig = ControlConfig()
    lasers: tuple[LaserConfig, ...] = Field(
        default=(), description="scanning range finders on the wall"
    )
    depth_cameras: tuple[DepthCameraConfig, ...] = Field(default=(), description="RGB-D cameras")
    furniture: tuple[FurnitureConfig, ...] = Field(
        default=(), description="things that the tracking system sees"
    )
    twin: TwinConfig = TwinConfig()
    web: WebConfig = WebConfig()
    mqtt: MqttConfig = MqttConfig()
    hub: HubConfig = HubConfig()
    edits: Edits = Edits()

    @property
    def served_wires(self) -> tuple[MocapWire, ...]:
        """What the twin's tracking system speaks: the protocol of ``tracking.kind`` and those asked
        for beside it.
        """
        return tuple(
            dict.fromkeys(
                wire for wire in (self.tracking.wire, *self.twin.mocap_wires) if wire is not None
            )
        )

    @model_validator(mode="after")
    def _combinations(self) -> Self:
        low, high = self.limits.height_min, self.limits.height_max
        if not low <= self.map.flight_height <= high:
            raise ValueError(
                f"map.flight_height ({self.map.flight_height} m) must lie in"
                f" limits.height_min..height_max ({low} .. {high} m)"
            )
        check_lasers(self.lasers)
        check_depth_cameras(self.depth_cameras)
        check_furniture(self.furniture, (self.tracking.body, self.tracking.visitor))
        if self.twin.enabled and not self.served_wires:
            raise ValueError(
                f"tracking.bridge_system ({self.tracking.bridge_system}) is none that the twin"
                f" poses as ({', '.join(BRIDGED)}); choose one of these, or set twin.enabled ="
                " false"
            )
        lag = self.drone.attitude_lag
        if self.control.beta >= lag * self.control.alpha:
            raise ValueError(
                f"control.beta ({self.control.beta} 1/s^2) must be below drone.attitude_lag *"
                f" control.alpha ({lag * self.control.alpha:.3g} 1/s^2): the loop would be unstable"
            )
        return self


def load_site(path: Path) -> Site:
    """Read and check a site file (TOML; JSON when it ends in ``.json``).

    Constants of the drone come from its profile, where the site names one and does not give them
    itself.

    Raises:
        ConfigError: naming the key, the value and the allowed range.
    """
    try:
        text = path.read_text(encoding="utf-8")
        tree = json.loads(text) if path.suffix == ".json" else tomllib.loads(text)
    except OSError as error:
        raise ConfigError("site file", f"cannot be read ({error.strerror})", str(path)) from error
    except ValueError as error:
        raise ConfigError("site file", f"cannot be parsed: {error}", str(path)) from error
    profile = tree.get("drone", {}).get("profile") if isinstance(tree.get("drone"), dict) else None
    if isinstance(profile, str) and profile:
        tree["drone"] = load_profile(path.parent / profile) | tree["drone"]
    return site_from_tree(tree, str(path))


def site_from_tree(tree: dict[str, Any], source: str = "") -> Site:
    """Check a tree of plain values and return the site; raises ConfigError for the first bad key."""
    try:
        return Site.model_validate(tree)
    except ValidationError as error:
        first = error.errors()[0]
        key = ".".join(str(part) for part in first["loc"]) or "site"
        raise ConfigError(key, explain(first, Site), source) from error


def changed(site: Site, **values: Any) -> Site:
    """Return the site with dotted keys (written with two underscores) replaced and checked again.

    >>> changed(Site(), twin__seed=7).twin.seed
    7
    """
    tree = site.model_dump()
    for key, value in values.items():
        *parents, leaf = key.split("__")
        branch = tree
        for parent in parents:
            branch = branch[parent]
        branch[leaf] = value
    return site_from_tree(tree)
