"""One typed tree from the site's TOML file; every value and combination is checked.

A site names the room, the drone, the tracking system and the limits. All numbers are SI; a key
whose unit is not SI says so in its name. ``docs/site.md`` lists every key, made from these types.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, Self

from pydantic import Field, model_validator

from housefly.config.control import ControlConfig
from housefly.config.depth import DepthCameraConfig, check_depth_cameras
from housefly.config.devices import MqttConfig
from housefly.config.drone import REAL_ODOMETRY_ERROR, TWIN_ODOMETRY_ERROR, DroneConfig
from housefly.config.drones import (
    DroneModelConfig,
    NamedDroneConfig,
    check_apart,
    check_names,
    drone_of,
    resolved,
)
from housefly.config.edits import Edits
from housefly.config.estimation import EstimationConfig
from housefly.config.faults import FaultConfig
from housefly.config.foxglove import FoxgloveConfig
from housefly.config.furniture import FurnitureConfig, check_furniture
from housefly.config.homeassistant import HomeAssistantConfig
from housefly.config.hub import HubConfig
from housefly.config.laser import LaserConfig, check_lasers
from housefly.config.limits import LimitsConfig
from housefly.config.map import MapConfig, RoomConfig
from housefly.config.people import PeopleConfig
from housefly.config.profile import CONSTANTS, load_profile
from housefly.config.ros2 import Ros2Config, RosbridgeConfig
from housefly.config.section import Section
from housefly.config.tasks import TasksConfig
from housefly.config.text import did_you_mean, refuse_odd_values, shortened
from housefly.config.toml import read_toml
from housefly.config.tracking import BRIDGED, MocapWire, TrackingConfig
from housefly.config.twin import TwinConfig
from housefly.config.validation import validated
from housefly.config.volumes import VolumeConfig
from housefly.config.web import WebConfig
from housefly.errors import ConfigError
from housefly.messages.words import Words, figure

Mode = Literal["default", "paper"]

NOISE_RATIO_MAX = 5000.0
"""Largest ``acceleration_noise / position_noise`` [1/s^2]."""
_PAPER_LIMITS = {"climb_command_max": 0.0, "landing_height": 0.45, "landing_lead": 0.0}
"""What mode paper flies with, whatever the site says: loads and draughts are not its own."""


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
    models: dict[str, DroneModelConfig] = Field(
        default={}, max_length=40, description="what the drones of a model have, by its name"
    )
    drones: tuple[NamedDroneConfig, ...] = Field(
        default=(),
        max_length=20,
        description="several drones; without this table [drone] is the only one",
    )
    tracking: TrackingConfig = TrackingConfig()
    limits: LimitsConfig = LimitsConfig()
    people: PeopleConfig = PeopleConfig()
    control: ControlConfig = ControlConfig()
    estimation: EstimationConfig = EstimationConfig()
    lasers: tuple[LaserConfig, ...] = Field(
        default=(), description="scanning range finders on the wall"
    )
    depth_cameras: tuple[DepthCameraConfig, ...] = Field(default=(), description="RGB-D cameras")
    furniture: tuple[FurnitureConfig, ...] = Field(
        default=(), description="things that the tracking system sees"
    )
    volumes: tuple[VolumeConfig, ...] = Field(
        default=(), max_length=40, description="to keep out of, to keep in, to fly slowly in"
    )
    twin: TwinConfig = TwinConfig()
    faults: tuple[FaultConfig, ...] = Field(
        default=(), max_length=100, description="what fails in the simulated room"
    )
    web: WebConfig = WebConfig()
    mqtt: MqttConfig = MqttConfig()
    foxglove: FoxgloveConfig = FoxgloveConfig()
    hub: HubConfig = HubConfig()
    tasks: TasksConfig = TasksConfig()
    ros2: Ros2Config = Ros2Config()
    rosbridge: RosbridgeConfig = RosbridgeConfig()
    homeassistant: HomeAssistantConfig = HomeAssistantConfig()
    edits: Edits = Edits()

    def __hash__(self) -> int:
        """A table by name has no hash of its own; what the drones have of it is enough."""
        return hash(tuple(value for key, value in self.__dict__.items() if key != "models"))

    @property
    def served_wires(self) -> tuple[MocapWire, ...]:
        """The protocols of the twin's tracking system; that of ``tracking.kind`` is the first."""
        return tuple(
            dict.fromkeys(
                wire for wire in (self.tracking.wire, *self.twin.mocap_wires) if wire is not None
            )
        )

    @property
    def odometry_error(self) -> float:
        """Share of a way by which the drone's own odometry may misjudge it."""
        if self.drone.odometry_error is not None:
            return self.drone.odometry_error
        return TWIN_ODOMETRY_ERROR if self.twin.enabled else REAL_ODOMETRY_ERROR

    @property
    def drone_names(self) -> tuple[str, ...]:
        """The drones that are flown, in the order of the site; the one of ``[drone]``, or none."""
        flown = self.all_drones if self.drones else (self.drone,)
        return tuple(drone.name for drone in flown if drone.enabled)

    @property
    def all_drones(self) -> tuple[DroneConfig, ...]:
        """Each drone with all that it has, flown or not, in the order of the site."""
        if not self.drones:
            return (self.drone,)
        return tuple(drone_of(own, self.models, self.drone) for own in self.drones)

    @property
    def drone_bodies(self) -> tuple[str, ...]:
        """The names of the drones among the tracked bodies, flown or not."""
        if not self.drones:
            return (self.tracking.body,)
        return tuple(own.tracked_body for own in self.drones)

    def for_drone(self, name: str) -> Site:
        """Return the site as the chain of one drone sees it: its drone, its body, its pad.

        The others stay in ``drones``, each with all that it has. A site without ``[[drones]]`` is
        that of its one drone.

        Raises:
            ConfigError: there is no drone of this name.
        """
        if not self.drones and name == self.drone.name:
            return self
        whole = tuple(resolved(own, self.models, self.drone) for own in self.drones)
        for own in whole:
            if own.name == name:
                parts = own.model_dump(exclude={"model", "body"})
                changes = {
                    "drone": DroneConfig(**parts),
                    "tracking": self.tracking.model_copy(update={"body": own.tracked_body}),
                }
                return self.model_copy(update=changes | {"drones": whole, "models": {}})
        known = [drone.name for drone in self.all_drones]
        raise ConfigError(
            "drone",
            f"there is none called {shortened(name, 40)!r}{did_you_mean(name, known)} (there is:"
            f" {', '.join(known)})",
        )

    @property
    def sees_people(self) -> bool:
        """Whether a sensor looks for people who wear no markers."""
        return bool(self.lasers or self.depth_cameras)

    @property
    def has_picture(self) -> bool:
        """Whether the drone shows what it sees; of several that have not one in focus, any."""
        ours = [drone for drone in self.all_drones if drone.name == self.drone.name]
        shown = self.twin.video or not self.twin.enabled
        return shown and any(one.has_video and one.has_camera for one in ours or self.all_drones)

    @property
    def has_camera(self) -> bool:
        """Whether a drone that is flown has a camera."""
        return any(drone.has_camera for drone in self.all_drones)

    @property
    def flies_in_space(self) -> bool:
        """Whether smooth trajectories are flown; the paper's chain flies its own grid."""
        return self.map.planner == "space" and self.mode != "paper"

    @model_validator(mode="before")
    @classmethod
    def _as_printed(cls, tree: Any) -> Any:
        """Give mode paper the limits that it has always had."""
        if not isinstance(tree, dict) or tree.get("mode") != "paper":
            return tree
        limits = tree.get("limits", {})
        limits = limits.model_dump() if isinstance(limits, LimitsConfig) else limits
        return tree | {"limits": limits | _PAPER_LIMITS} if isinstance(limits, dict) else tree

    @model_validator(mode="after")
    def _combinations(self) -> Self:
        low, high = self.limits.height_min, self.limits.height_max
        if not low <= self.map.flight_height <= high:
            raise ValueError(
                Words(
                    "map.flight_height ({a} m) must lie in limits.height_min..height_max"
                    " ({b} .. {c} m)",
                    a=figure(self.map.flight_height),
                    b=figure(low),
                    c=figure(high),
                )
            )
        self._check_volumes()
        check_lasers(self.lasers)
        check_depth_cameras(self.depth_cameras)
        check_furniture(self.furniture, (*self.drone_bodies, self.tracking.visitor))
        self._check_drones()
        if self.twin.enabled and not self.served_wires:
            if self.tracking.kind == "ros2":
                raise ValueError(
                    'tracking.kind is "ros2", and the simulated room has no ROS of its own; name'
                    ' what it serves (twin.mocap_wires = ["vicon"], for a node that reads that), or'
                    " set twin.enabled = false"
                )
            raise ValueError(
                f"tracking.bridge_system ({self.tracking.bridge_system}) is none that the twin"
                f" poses as ({', '.join(BRIDGED)}); choose one of these, or set twin.enabled ="
                " false"
            )
        if self.faults and not self.twin.enabled:
            raise ValueError(
                f"faults: {self.faults[0].fault!r} is for the simulated room only, and twin.enabled"
                " is false; take the faults out, or set twin.enabled = true"
            )
        for lag in [drone.attitude_lag for drone in self.all_drones]:
            if self.control.beta >= lag * self.control.alpha:
                raise ValueError(
                    f"control.beta ({self.control.beta} 1/s^2) must be below drone.attitude_lag *"
                    f" control.alpha ({lag * self.control.alpha:.3g} 1/s^2): the loop would be"
                    " unstable"
                )
        if self.drone_names and not self.tracking.enabled:
            raise ValueError(
                "tracking.enabled is false, and a drone flies by tracking; allowed: true, or"
                " drone.enabled = false"
            )
        self._check_filter()
        self._check_who_flies_over_mqtt()
        self._check_home_assistant()
        return self

    def _check_drones(self) -> None:
        """Raise ValueError for drones that cannot be told apart."""
        others = {self.tracking.visitor, *self.people.bodies}
        others |= {text for piece in self.furniture for text in (piece.body, piece.name)}
        check_names(self.drones, self.models, others, self.drone.name)
        if self.drones:
            check_apart(self.all_drones, self.people.min_distance)

    def _check_filter(self) -> None:
        """Raise ValueError for a filter that takes each millimetre of tracking noise as motion."""
        control = self.control
        highest = NOISE_RATIO_MAX * control.position_noise
        if self.mode != "paper" and control.acceleration_noise > highest:
            raise ValueError(
                f"control.acceleration_noise ({control.acceleration_noise:g} m/s^2) must not be"
                f" above {NOISE_RATIO_MAX:g} 1/s^2 * control.position_noise ({highest:.3g} m/s^2):"
                " noise of 1 mm would be taken as motion, and the drone land as if touched"
            )

    def _check_who_flies_over_mqtt(self) -> None:
        """Raise ValueError where whoever reaches the broker could fly without a person's yes."""
        mqtt = self.mqtt
        if self.tasks.mqtt_requests == "auto" and mqtt.broker and (mqtt.start or not mqtt.username):
            which = "mqtt.start = true" if mqtt.start else 'mqtt.username = ""'
            raise ValueError(
                f'tasks.mqtt_requests = "auto" with {which}: such a broker asks nobody who they'
                " are, so whoever reaches it flies without a person's yes; allowed: mqtt.start ="
                " false with a broker that guards the topics of tasks.mqtt_clients and asks for"
                ' mqtt.username, or tasks.mqtt_requests = "ask"'
            )

    def _check_home_assistant(self) -> None:
        """Raise ValueError where it has no broker, or flies through one that asks nobody."""
        mqtt, home = self.mqtt, self.homeassistant
        if not home.enabled:
            return
        if not mqtt.broker:
            raise ValueError(
                "homeassistant.enabled = true without mqtt.broker; allowed: with the broker that"
                " Home Assistant uses, too"
            )
        given = {'requests = "auto"': home.requests == "auto", "answers = true": home.answers}
        flies = next((words for words, holds in given.items() if holds), "")
        if flies and (mqtt.start or not mqtt.username):
            which = "mqtt.start = true" if mqtt.start else 'mqtt.username = ""'
            raise ValueError(
                f"homeassistant.{flies} with {which}: whoever reaches such a broker flies without a"
                " person's yes; allowed: mqtt.start = false with a broker that asks for"
                ' mqtt.username, or requests = "ask" and answers = false'
            )

    def _check_volumes(self) -> None:
        """Raise ValueError for what only a flight in space can do."""
        slow = [volume.reason for volume in self.volumes if volume.kind == "slow"]
        if slow and not self.flies_in_space:
            raise ValueError(
                f"volumes: {slow[0]!r} is of kind slow, and corners are flown; allowed:"
                ' map.planner = "space" and mode = "default", or another kind'
            )


def site_from_file(path: Path) -> Site:
    """Read and check a site file (TOML; JSON when it ends in ``.json``).

    Constants of the drone that the site does not give come from the drone's profile, if it has one.
    A site as it was flown gives all of them, and can be read where the profile is not.

    Raises:
        ConfigError: naming the key, the value and the allowed range.
    """
    tree = read_toml(path, "site file")
    if "drone" in tree:
        tree["drone"] = _with_profile(tree["drone"], path.parent)
    if isinstance(models := tree.get("models"), dict):
        tree["models"] = {name: _findable(own, path.parent) for name, own in models.items()}
    if isinstance(drones := tree.get("drones"), list):
        tree["drones"] = [_findable(own, path.parent) for own in drones]
    return site_from_tree(tree, str(path))


def _with_profile(drone: Any, folder: Path) -> Any:
    """Return a table of a drone with the constants of its profile that it does not give."""
    if not isinstance(drone, dict) or CONSTANTS.keys() <= drone.keys():
        return drone
    profile = drone.get("profile")
    if not isinstance(profile, str) or not profile:
        return drone
    return load_profile(folder / profile) | drone


def _findable(drone: Any, folder: Path) -> Any:
    """Return a table that gives some constants only, with a profile that is found from anywhere."""
    whole = _with_profile(drone, folder)
    return (
        whole
        if whole is drone
        else whole | {"profile": str((folder / drone["profile"]).absolute())}
    )


def site_from_tree(tree: dict[str, Any], source: str = "") -> Site:
    """Return plain values as a site; raises ConfigError for the first bad key."""
    refuse_odd_values(tree, source)
    return validated(Site, tree, "site", source)


def changed(site: Site, **values: Any) -> Site:
    """Return the site with dotted keys (written with two underscores) replaced and checked again.

    Constants that nobody gave a drone are those of its airframe, of another one too.

    >>> changed(Site(), twin__seed=7).twin.seed
    7
    >>> changed(Site(), drone__kind="tello").drone.attitude_lag
    4.0
    """
    tree = site.model_dump()
    tree["drone"] = site.drone.model_dump(exclude_unset=True)
    tree["drones"] = tuple(drone.model_dump(exclude_unset=True) for drone in site.drones)
    for key, value in values.items():
        *parents, leaf = key.split("__")
        branch: Any = tree
        for parent in parents:
            branch = branch.get(parent)
            if not isinstance(branch, dict):
                raise ConfigError(key.replace("__", "."), "is not a known key")
        branch[leaf] = value
    return site_from_tree(tree)
