"""Learn the constants of a drone that nobody told us about.

Needs: MuJoCo: the extra `twin`, which `make setup` brings.
Learns: the simulated drone has hidden constants, the pilot believes others; small steps in a
    checked box tell what it is like.
Prints: how many steps were flown, then each constant with its 95 % interval beside what the pilot
    believed and what is true of the whole way from command to motion; then what to think of it.
"""

import housefly

RATES = {"control__rate_hz": 50.0, "twin__mocap_rate_hz": 30.0, "twin__seed": 3}
HIDDEN = {
    "drone__attitude_lag": 5.5,
    "drone__attitude_gain": 0.92,
    "drone__drag": 0.4,
    "drone__climb_lag": 2.0,
}
believed = housefly.load_site("bsen", **RATES)
real = housefly.load_site("bsen", **RATES, **HIDDEN)

found = housefly.identify(believed, real=real, repeats=6)
print(f"{len(found.blocks)} blocks were flown and seen")
for key, interval in found.constants.items():
    was, true = getattr(believed.site.drone, key), found.truth[key]
    value = f"{interval.value:6.3f} ({interval.low:.3f} to {interval.high:.3f})"
    print(f"{key:<14} {value}; believed {was}, true {true:.3g}")
print(found.advice)
