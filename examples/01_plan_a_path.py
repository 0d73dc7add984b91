"""Plan a path in B-sen.

Learns: a site names a room, the room becomes an occupancy grid, the planner answers with a path or
    with a reason.
Prints: the way from the pad to the entrance, and why there is none into the sofa, with the nearest
    place that works.
"""

from housefly.app.loaded_site import open_site, read_site
from housefly.pilot.planning.planner import plan
from housefly.room.grid import inflation

loaded = open_site(read_site("bsen"))
room, grid = loaded.room, loaded.grid
print(f"{room.name}: {grid.shape[0]} x {grid.shape[1]} cells of {grid.resolution} m")
print(f"the drone's middle keeps {inflation(loaded.site):.2f} m from everything")

answer = plan(
    grid, room.home, room.place("entrance").viewpoint, loaded.site.limits.speed, shortcut=True
)
assert answer.path is not None
print(
    f"to the entrance: {answer.path.length:.2f} m, {answer.duration:.0f} s, clearance"
    f" {answer.path.clearance:.2f} m"
)
print(" -> ".join(f"({x:.2f}, {y:.2f})" for x, y in answer.path.waypoints))

refused = plan(grid, room.home, (12.2, 2.5), loaded.site.limits.speed)
print(f"into the sofa: {refused.reason}; nearest place that works: {refused.suggestion}")
