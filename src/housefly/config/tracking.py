"""The part of a site file about the motion capture system."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from housefly.config.section import Section, port_number, quantity

AddressedTracking = Literal["vicon", "natnet", "vrpn", "bridge"]
"""What answers at an address."""
TrackingKind = Literal[AddressedTracking, "ros2"]
MocapWire = Literal["vicon", "natnet", "vrpn"]
BRIDGED: dict[str, MocapWire] = {"vicon": "vicon", "optitrack": "natnet", "vrpn": "vrpn"}
"""Types of PyPI motioncapture whose protocol the twin serves."""

DRONE_BODY = "ardrone"
"""What the drone is called among the tracked bodies unless a site says otherwise."""


class TrackingConfig(Section):
    """The motion capture system and where it answers."""

    enabled: bool = Field(
        default=True, description="whether there is a tracking system; a drone needs one"
    )
    kind: TrackingKind = Field(
        default="vicon",
        description=(
            "driver; bridge is PyPI motioncapture (extra mocap), for all others; ros2 is poses on"
            " ROS 2 topics"
        ),
    )
    address: str = Field(default="127.0.0.1", description="IP address")
    port: int = port_number(8010, "TCP port of Vicon; a real one listens on 801")
    natnet_port: int = port_number(1510, "UDP port of NatNet commands (Motive)")
    vrpn_port: int = port_number(3883, "UDP and TCP port of VRPN")
    vrpn_transport: Literal["tcp", "udp"] = Field(
        default="tcp",
        description="how a VRPN connection begins: tcp, or udp (the server connects back to us)",
    )
    up_axis: Literal["auto", "y", "z"] = Field(
        default="auto",
        description=(
            "the axis that points up where the system does not say it; auto: y for natnet, else z"
        ),
    )
    bridge_system: str = Field(
        default="qualisys",
        pattern="^[a-z_]{1,40}$",
        description="type that motioncapture is asked for when kind is bridge",
    )
    ros_topic: str = Field(
        default="/{body}/pose",
        max_length=200,
        pattern=r"^/[A-Za-z0-9_/]*(\{body\})?[A-Za-z0-9_/]*$",
        description=(
            "topics of ROS 2 with poses, when kind is ros2: PoseStamped, Odometry, TransformStamped"
            " or PoseWithCovarianceStamped; {body} is the name of the body; or /tf"
        ),
    )
    ros_domain: int | None = Field(
        default=None,
        ge=0,
        le=232,
        description="ROS domain; left out: ROS_DOMAIN_ID, or 0",
        json_schema_extra={"unit": "1"},
    )
    ros_discovery: Literal["localhost", "subnet"] = Field(
        default="localhost", description="where the ROS nodes that tell poses run"
    )
    body: str = Field(default=DRONE_BODY, description="name of the drone among the tracked bodies")
    visitor: str = Field(
        default="visitor", description="name of the person at the door among the tracked bodies"
    )
    latency: float = quantity(
        0.02, 0.0, 0.5, "s", "from exposure to arrival, where the system does not say it"
    )
    x: float = quantity(0.0, -1000.0, 1000.0, "m", "where its origin is on the map")
    y: float = quantity(0.0, -1000.0, 1000.0, "m", "likewise")
    z: float = quantity(0.0, -100.0, 100.0, "m", "height of its origin above the floor")
    yaw: float = quantity(0.0, -3.1416, 3.1416, "rad", "heading of its x axis on the map")
    body_yaw: float = quantity(
        0.0, -3.1416, 3.1416, "rad", "heading of the drone's nose in its body as defined"
    )

    @property
    def is_moved(self) -> bool:
        """Whether poses have to be moved or turned to be those of the map."""
        return any((self.x, self.y, self.z, self.yaw, self.body_yaw))

    @property
    def wire(self) -> MocapWire | None:
        """The protocol that arrives here, or None for one that only a bridge speaks."""
        if self.kind == "ros2":
            return None
        return BRIDGED.get(self.bridge_system) if self.kind == "bridge" else self.kind

    @property
    def y_up(self) -> bool:
        """Whether poses come with y up."""
        return self.up_axis == "y" or (self.up_axis == "auto" and self.wire == "natnet")

    def port_of(self, wire: MocapWire) -> int:
        """Return the port of a protocol."""
        return {"vicon": self.port, "natnet": self.natnet_port, "vrpn": self.vrpn_port}[wire]
