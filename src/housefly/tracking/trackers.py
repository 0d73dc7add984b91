"""The client of each tracking system."""

from __future__ import annotations

from collections.abc import Callable

from housefly.clock import Clock
from housefly.config.tracking import TrackingConfig, TrackingKind
from housefly.tracking.bridge import BridgeTracker
from housefly.tracking.contracts import Tracker
from housefly.tracking.map_frame import MapFrameTracker
from housefly.tracking.natnet import NatNetTracker
from housefly.tracking.ros2 import Ros2Tracker
from housefly.tracking.vicon import ViconTracker
from housefly.tracking.vrpn import VrpnTracker

TRACKERS: dict[TrackingKind, Callable[[TrackingConfig, Clock], Tracker]] = {
    "vicon": ViconTracker,
    "natnet": NatNetTracker,
    "vrpn": VrpnTracker,
    "bridge": BridgeTracker,
    "ros2": Ros2Tracker,
}
"""The client of each ``tracking.kind``."""


def tracker_of(config: TrackingConfig, clock: Clock) -> Tracker:
    """Return the client of a site's tracking system, whose poses are those of the map."""
    tracker = TRACKERS[config.kind](config, clock)
    return MapFrameTracker(tracker, config) if config.is_moved else tracker
