"""Make a room of a ROS map and fly in it.

Learns: a picture and four lines of YAML, as ROS mapping tools write them, are enough; walls are
    extruded, home and places chosen.
Prints: the imported room as text, and the outcome of a service in it. The same from the shell:

    housefly room import map.yaml --out myroom
    housefly fly far --headless --lockstep --site myroom
"""

import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

from housefly.app.loaded_site import open_site, read_site
from housefly.app.lockstep import fly_lockstep
from housefly.messages import Order, OrderKind
from housefly.room.draw import text_map
from housefly.room.ros_map import import_ros_map

WALL, FREE = 0, 254

with tempfile.TemporaryDirectory() as folder:
    picture = np.full((100, 160), FREE, dtype=np.uint8)  # 8 m x 5 m at 5 cm a pixel
    picture[:2], picture[-2:], picture[:, :2], picture[:, -2:] = WALL, WALL, WALL, WALL
    picture[:55, 78:82] = WALL
    Image.fromarray(picture).save(Path(folder) / "map.png")
    lines = ("image: map.png", "resolution: 0.05", "origin: [0.0, 0.0, 0.0]", "negate: 0")
    (Path(folder) / "map.yaml").write_text(
        "\n".join((*lines, "occupied_thresh: 0.65", "free_thresh: 0.196"))
    )

    out = Path(folder) / "myroom"
    room = import_ros_map(Path(folder) / "map.yaml", out)
    loaded = open_site(read_site(str(out)))
    print(text_map(loaded.room, loaded.grid))

    place = next(place.name for place in room.places if place.name != "home")
    outcome = fly_lockstep(
        loaded, Order(OrderKind.SERVICE, place=place, look_s=1.0), lambda step: None
    )
    print(f"to {place!r} and back: {outcome}")
