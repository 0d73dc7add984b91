"""What is known in advance of a device that measures one value: of what, and its thresholds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from housefly.config.site import Site
from housefly.wires.devices import KINDS

ON_ABOVE = 10.0
"""Whatever draws at least this is on, unless the site file says otherwise [W]."""
OFF_BELOW = 5.0
"""Whatever draws less is off; in between it stays as it was [W]."""


@dataclass(frozen=True, slots=True)
class DeviceTraits:
    """One measuring device.

    Attributes:
        thing: id of the thing that it tells about.
        kind: name of its kind, "" when the site file does not know it.
        above: on, hot or full from here [W, degrees Celsius, %]; None for no such threshold.
        below: off, cold or empty below this, likewise.
        heartbeat: longest time between two of its states [s]; 0 when only its kind says.
    """

    thing: str
    kind: str = ""
    above: float | None = None
    below: float | None = None
    heartbeat: float = 0.0

    def is_on(self, power: float, before: bool | None = None) -> bool | None:
        """Return whether what draws a power [W] is on; in between it is as before."""
        above, below = self.limits_of_power()
        if power >= above:
            return True
        return False if power < below else before

    def limits_of_power(self) -> tuple[float, float]:
        """Return the powers from which it is on and below which it is off [W]."""
        above = self.above if self.above is not None else max(ON_ABOVE, self.below or 0.0)
        below = self.below if self.below is not None else min(OFF_BELOW, above)
        return above, below


def traits_of(devices: Mapping[str, DeviceTraits], device: str) -> DeviceTraits:
    """Return what is known of a device; one that the site file does not name tells of itself."""
    return devices.get(device) or DeviceTraits(device)


def device_traits_of(site: Site) -> dict[str, DeviceTraits]:
    """Return what the site file says of each measuring device, by its id."""
    return {
        row.id: DeviceTraits(
            row.thing or row.id,
            row.kind,
            None if row.above is None else row.ours(row.above),
            None if row.below is None else row.ours(row.below),
            row.heartbeat or KINDS[row.kind].heartbeat,
        )
        for row in site.mqtt.sensors
    }
