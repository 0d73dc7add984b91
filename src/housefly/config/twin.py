"""The simulated drone, tracking system, camera and scanners."""

from __future__ import annotations

from typing import Literal, Self

from pydantic import Field, model_validator

from housefly.config.section import Section, is_multicast_group, port_number, quantity
from housefly.config.tracking import MocapWire

INNER_LOOP_DELAY = 0.005
"""What the simulated drone adds to it [s]: half of its control period, for which a datagram waits
on average, and its rate loop.
"""
RATE_POLE = 150.0
"""Pole of the simulated drone's body rate loop, behind its tilt but not its turning [1/s]."""


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
    command_delay: float | None = Field(
        default=None,
        ge=0.0,
        le=0.5,
        allow_inf_nan=False,
        description=(
            "from a datagram to the simulated drone's obeying it; left out: with drone.profile what"
            " makes the whole delay the profile's (sending adds 10 ms at 100 Hz, the inner loops"
            " 5 ms), else its airframe's"
        ),
        json_schema_extra={"unit": "s"},
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
