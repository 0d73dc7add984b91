"""Plan a path in B-sen.

Needs: nothing beside Housefly itself.
Learns: a site names a room, the room becomes an occupancy grid, the planner answers with a path or
    with a reason.
Prints: the way from the pad to the entrance, and why there is none into the sofa, with the nearest
    place that works.
"""

import housefly

site = housefly.load_site("bsen")
columns, rows = site.grid.shape
print(f"{site.room.name}: {columns} x {rows} cells of {site.grid.resolution} m")

answer = site.plan("entrance")
path = answer.path
assert path is not None
words = f"{path.length:.2f} m, {answer.duration:.0f} s, clearance {path.clearance:.2f} m"
print(f"to the entrance: {words}")
print(" -> ".join(f"({x:.2f}, {y:.2f})" for x, y in path.waypoints))

refused = site.plan((12.2, 2.5))
print(f"into the sofa: {refused.reason}; nearest place that works: {refused.suggestion}")
