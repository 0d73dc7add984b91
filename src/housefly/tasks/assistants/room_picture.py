"""The room's map for assistants: letters on a picture, and what they stand for beside it.

Names of the room are nowhere in the picture: whoever reads pictures cannot tell them from words of
ours.
"""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping
from string import ascii_uppercase

from PIL import Image, ImageDraw

from housefly.geometry import Vec2
from housefly.hub.api.answers import PictureAnswer
from housefly.hub.api.pilot_queries import RoomView
from housefly.theme import LIGHT

_PIXELS_PER_METRE = 70.0
_LARGEST = 1600
"""Longer sides are drawn at a smaller scale [pixels]."""
_COLUMNS = 75
_CELLS = {
    ".": LIGHT.paper,
    "#": LIGHT.wall,
    "v": LIGHT.virtual,
    "i": LIGHT.margin,
    "x": LIGHT.outside,
}
_RANK = "x.ivh#"
"""Of several cells in one letter of the text, the last in this order is shown."""
_PLACE, _THING, _PERSON, _DRONE = LIGHT.good, LIGHT.ink, LIGHT.danger, LIGHT.accent
_DOT, _LETTER, _LETTER_SIZE = 7.0, 10.0, 17
_MAX_MARKS = 200
_FIRST, _LEFT_OUT = frozenset({"person", "robot"}), frozenset({"sensor", "place", "space"})
"""Kinds of things whose marks come first, and those that have none."""


def marked_places(view: RoomView, picture: PictureAnswer | None) -> dict[str, tuple[str, Vec2]]:
    """Return what is drawn: by mark its name in the room and where it is, world xy [m]."""
    named = [(place.name, place.viewpoint) for place in view.places]
    places = {place.name for place in view.places}
    things = sorted(picture.things, key=lambda thing: thing.kind not in _FIRST) if picture else ()
    for thing in things:
        is_new = thing.thing not in places and thing.kind not in _LEFT_OUT
        if thing.position is not None and is_new:
            named.append((thing.thing, (thing.position[0], thing.position[1])))
    return dict(zip(_marks(), named[:_MAX_MARKS], strict=False))


def map_png(view: RoomView, picture: PictureAnswer | None) -> bytes:
    """Return the map as a PNG: cells, places, things, people and live obstacles; y is up."""
    x_min, y_min, x_max, y_max = view.bounds
    scale = min(_PIXELS_PER_METRE, _LARGEST / max(x_max - x_min, y_max - y_min, 1e-3))
    size = (max(1, round((x_max - x_min) * scale)), max(1, round((y_max - y_min) * scale)))
    image = Image.new("RGB", size, _CELLS["x"])
    pen = ImageDraw.Draw(image)

    def pixel(point: Vec2) -> tuple[float, float]:
        return (point[0] - x_min) * scale, size[1] - (point[1] - y_min) * scale

    _draw_cells(pen, view, scale, pixel(view.grid.origin))
    for outline in view.outlines:
        pen.polygon([pixel(corner) for corner in outline.corners], outline=LIGHT.thing_edge)
    for obstacle in picture.obstacles if picture else ():
        x, y = pixel((obstacle.x, obstacle.y))
        radius = max(2.0, obstacle.radius * scale)
        pen.ellipse((x - radius, y - radius, x + radius, y + radius), outline=LIGHT.second, width=2)
    kinds = {thing.thing: thing.kind for thing in picture.things} if picture else {}
    colours = {"person": _PERSON, "robot": _DRONE}
    places = {place.name for place in view.places}
    for mark, (name, point) in marked_places(view, picture).items():
        colour = _PLACE if name in places else colours.get(kinds.get(name, ""), _THING)
        x, y = pixel(point)
        pen.ellipse((x - _DOT, y - _DOT, x + _DOT, y + _DOT), fill=colour)
        pen.text((x + _LETTER, y - _LETTER), mark, fill=colour, font_size=_LETTER_SIZE)
    written = io.BytesIO()
    image.save(written, "PNG")
    return written.getvalue()


def map_text(view: RoomView, picture: PictureAnswer | None) -> str:
    """Return the map as text, y up: # solid, v and i too close, . free, letters are marks."""
    grid = view.grid
    step = max(1, -(-grid.width // _COLUMNS))
    canvas = [
        [_worst(_block(grid.rows[j : j + 2 * step], i, step)) for i in range(0, grid.width, step)]
        for j in range(0, grid.height, 2 * step)
    ]
    for mark, (_, point) in reversed(marked_places(view, picture).items()):
        i = int((point[0] - grid.origin[0]) / grid.resolution / step)
        j = int((point[1] - grid.origin[1]) / grid.resolution / (2 * step))
        if len(mark) == 1 and 0 <= j < len(canvas) and 0 <= i < len(canvas[j]):
            canvas[j][i] = mark
    rows = ["".join(row).rstrip() for row in reversed(canvas)]
    scale = f"one letter: {step * grid.resolution:g} m across, {2 * step * grid.resolution:g} m up"
    return "\n".join([*rows, scale])


def _draw_cells(
    pen: ImageDraw.ImageDraw, view: RoomView, scale: float, corner: tuple[float, float]
) -> None:
    edge = view.grid.resolution * scale
    for j, row in enumerate(view.grid.rows):
        bottom = corner[1] - j * edge
        begin = 0
        while begin < len(row):
            end = begin + 1
            while end < len(row) and row[end] == row[begin]:
                end += 1
            left, right = corner[0] + begin * edge, corner[0] + end * edge
            colour = _CELLS.get(row[begin], _CELLS["x"])
            pen.rectangle((left, bottom - edge, right, bottom), fill=colour)
            begin = end


def _marks() -> Iterable[str]:
    yield from ascii_uppercase
    yield from (f"{letter}{number}" for number in range(1, 10) for letter in ascii_uppercase)


def _block(rows: Iterable[str], begin: int, step: int) -> str:
    return "".join(row[begin : begin + step] for row in rows)


def _worst(letters: str) -> str:
    return max(letters, key=_RANK.find, default=" ").replace("x", " ")


def map_legend(marks: Mapping[str, tuple[str, Vec2]]) -> dict[str, dict[str, object]]:
    """Return what the marks stand for: names of the room, and where [m]."""
    return {
        mark: {"name": name, "x": round(point[0], 2), "y": round(point[1], 2)}
        for mark, (name, point) in marks.items()
    }
