"""Make a room of a ROS map and fly in it.

Needs: MuJoCo: the extra `twin`, which `make setup` brings.
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

import housefly

WALL, FREE = 0, 254
MAP = """\
image: map.png
resolution: 0.05
origin: [0.0, 0.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""

with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    picture = np.full((100, 160), FREE, dtype=np.uint8)  # 8 m x 5 m at 5 cm a pixel
    picture[:2], picture[-2:], picture[:, :2], picture[:, -2:] = WALL, WALL, WALL, WALL
    picture[:55, 78:82] = WALL
    Image.fromarray(picture).save(folder / "map.png")
    (folder / "map.yaml").write_text(MAP)

    room = housefly.import_ros_map(folder / "map.yaml", folder / "myroom")
    site = housefly.load_site(str(folder / "myroom"))
    print(housefly.text_map(site.room, site.grid))

    place = next(place.name for place in room.places if place.name != "home")
    flight = housefly.fly(place, site, look_s=1.0)
    print(f"to {place!r} and back: {flight.outcome}")
