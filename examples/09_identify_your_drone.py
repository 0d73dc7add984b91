"""Learn the constants of a drone that nobody told us about.

Learns: the simulated drone has hidden constants, the pilot believes others; small steps in a
    checked box tell what it is like.
Prints: the box, then each constant with its 95 % interval beside what the pilot believed and what
    is true.
"""

from housefly.app.identification_flight import IdentificationFlight, fly_identification_lockstep
from housefly.app.loaded_site import open_site, read_site
from housefly.lab.identification.box import find_box
from housefly.lab.identification.maneuver import IdentificationManeuver
from housefly.lab.identification.pattern import blocks
from housefly.lab.identification.result import Limits, fit_constants
from housefly.lab.identification.samples import samples_of
from housefly.messages import PilotStep
from housefly.twin.world import SimulatedWorld

tracking = {"twin__mocap_rate_hz": 30.0, "twin__seed": 3}
hidden = {
    "drone__attitude_lag": 5.5,
    "drone__attitude_gain": 0.92,
    "drone__drag": 0.4,
    "drone__climb_lag": 2.0,
}
believed = open_site(read_site("bsen", **tracking))
real = open_site(read_site("bsen", **tracking, **hidden))

plan = blocks(6, believed.site.limits.tilt_max)
box = find_box(believed.grid, believed.room.home, 0.65, believed.site.map.flight_height)
print(
    f"{len(plan)} blocks in a box of {2 * box.reach:.1f} m around ({box.centre[0]:.1f},"
    f" {box.centre[1]:.1f})"
)

maneuver = IdentificationManeuver(plan, box)
steps: list[PilotStep] = []
print(
    fly_identification_lockstep(
        believed, SimulatedWorld(real.site, real.room), IdentificationFlight(box, maneuver, 400.0), steps.append
    )
)

limits = believed.site.limits
bounds = Limits(limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max)
found = fit_constants(samples_of(steps, tuple(maneuver.flown), believed.site.tracking.body), bounds)
for key, interval in found.constants.items():
    was, true = getattr(believed.site.drone, key), getattr(real.site.drone, key)
    print(
        f"{key:<14} {interval.value:6.3f} ({interval.low:.3f} to {interval.high:.3f}); believed"
        f" {was}, true {true}"
    )
print("; ".join(found.problems) or "the profile may be written")
