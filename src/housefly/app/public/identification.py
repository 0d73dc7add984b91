"""Learns a simulated drone's constants from a test flight on a stepped clock."""

from __future__ import annotations

from housefly.app.identification_flight import (
    BLOCK_TIMEOUT,
    IdentificationFlight,
    box_reach,
    fly_identification_lockstep,
)
from housefly.config.site import changed
from housefly.errors import ConfigError, LinkError
from housefly.lab.identification.box import find_box
from housefly.lab.identification.maneuver import IdentificationManeuver
from housefly.lab.identification.pattern import blocks
from housefly.lab.identification.result import Identified, Limits, fit_constants
from housefly.lab.identification.samples import samples_of
from housefly.lab.identification.truth import simulated_truth
from housefly.messages import PilotStep
from housefly.sites.loaded_site import LoadedSite, open_site
from housefly.twin.world import SimulatedWorld

_MIN_REPEATS, _MAX_REPEATS = 4, 40


def identify(loaded: LoadedSite, *, real: LoadedSite | None = None, repeats: int = 6) -> Identified:
    """Fly small steps in a checked box, on a stepped clock, and fit the drone's constants to them.

    The steps are the same that ``housefly identify`` flies with a real drone.

    Args:
        loaded: where to fly, and what the pilot believes of the drone.
        real: site of the drone that flies; None for the one that the pilot believes in.
        repeats: blocks of each kind, 4 to 40; more give smaller intervals.

    Raises:
        ConfigError: ``repeats`` is out of range.
        RoomError: there is no free box that is large enough.
        LinkError: the flight was given up; the message says why.
    """
    if not _MIN_REPEATS <= repeats <= _MAX_REPEATS:
        allowed = f"a number from {_MIN_REPEATS} to {_MAX_REPEATS}"
        raise ConfigError("repeats", f"is {repeats}; allowed: {allowed}")
    if loaded.site.mode != "default":
        loaded = open_site(changed(loaded.site, mode="default"))
    site, flying = loaded.site, real or loaded
    plan = blocks(repeats, site.limits.tilt_max)
    reach = box_reach(plan, site.drone)
    box = find_box(loaded.grid, loaded.room.home, reach, site.map.flight_height)
    maneuver, steps = IdentificationManeuver(plan, box), list[PilotStep]()
    outcome = fly_identification_lockstep(
        loaded,
        SimulatedWorld(flying.site, flying.room),
        IdentificationFlight(box, maneuver, 120.0 + BLOCK_TIMEOUT * len(plan)),
        steps.append,
    )
    if outcome != "completed":
        raise LinkError(f"the identification flight was given up: {outcome}")
    limits = Limits(site.limits.tilt_max, site.limits.vertical_speed_max, site.limits.yaw_rate_max)
    samples = samples_of(steps, tuple(maneuver.flown), site.tracking.body)
    return fit_constants(samples, limits, truth=simulated_truth(flying.site))
