"""What an identification found, in words."""

from __future__ import annotations

import time

from housefly.app.terminal import console, new_table
from housefly.config.profile import CONSTANTS
from housefly.lab.identification.result import Identified
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.command_delay import sending_delay


def print_constants(found: Identified, loaded: LoadedSite) -> None:
    """Print the constants beside the simulated ones, or beside those of the site."""
    beside = "simulated" if found.truth else "the site has"
    table = new_table(("constant", "value", "95 % interval", "unit", beside))
    for key, interval in found.constants.items():
        known = CONSTANTS[key]
        present = found.truth.get(key, getattr(loaded.site.drone, key))
        inside = "" if interval.low <= present <= interval.high else " (outside)"
        span = f"{interval.low:.3g} to {interval.high:.3g}"
        table.add_row(key, f"{interval.value:.3g}", span, known.unit, f"{present:.3g}{inside}")
    console.print(table)
    assert found.tilt is not None
    site = loaded.site
    sending = sending_delay(site.control.rate_hz, site.drone.airframe.link)
    console.print(
        f"left over: {1000 * found.tilt.angle_noise:.1f} mrad in angle,"
        f" {1000 * found.tilt.place_noise:.1f} mm in position; in the delay, "
        f"{1000 * sending:.0f} ms are waiting for a datagram"
    )


def measurement_notes(found: Identified, loaded: LoadedSite) -> dict[str, str]:
    """Return how and when the constants were measured, for the profile."""
    assert found.tilt is not None
    kinds = ", ".join(
        f"{sum(b.block.axis is axis for b in found.blocks)} {axis.value}"
        for axis in dict.fromkeys(b.block.axis for b in found.blocks)
    )
    rate = sum(block.at.size for block in found.blocks) / sum(
        block.block.duration for block in found.blocks
    )
    return {
        "when": time.strftime("%Y-%m-%d %H:%M"),
        "site": loaded.site.name,
        "drone": "simulated" if loaded.site.twin.enabled else loaded.site.drone.kind,
        "blocks": kinds,
        "tracking": f"{rate:.0f} frames per second",
        "left_over": (
            f"{1000 * found.tilt.angle_noise:.2f} mrad, {1000 * found.tilt.place_noise:.2f} mm"
        ),
    }
