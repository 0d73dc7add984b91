"""How well tracking agrees with what the drone itself feels."""

from __future__ import annotations

from dataclasses import dataclass
from math import nan


@dataclass(frozen=True, slots=True)
class TrackingConsistency:
    """Tracking held against the drone's own report; nan where nothing can be said yet.

    Attributes:
        drift: how far the tracked way has left the onboard one since both agreed last [m].
        frame_error: angle between the tracked body frame and the one that the drone flies in [rad].
        mirrored: tracked motion or turns are the mirror image of onboard ones.
        height_error: tracked height minus onboard height [m].
        height_drift: the same in the air, less the steps of the floor since it was seen last [m].
        latency_error: how much older the poses are than their stamps say [s].
        refused_for: how long poses have been refused because onboard motion disagrees [s].
        flow_untold: in the air the drone does not tell its speed, or the same to the last bit.
        flow_wrong: that speed is neither what tracking sees nor how the drone leans.
    """

    drift: float = nan
    frame_error: float = nan
    mirrored: bool = False
    height_error: float = nan
    height_drift: float = nan
    latency_error: float = nan
    refused_for: float = 0.0
    flow_untold: bool = False
    flow_wrong: bool = False

    @property
    def flow_believed(self) -> bool:
        """Whether the drone's own hover, which flies by optical flow, can be left to itself."""
        return not (self.flow_untold or self.flow_wrong)


NOTHING_KNOWN = TrackingConsistency()
