"""Which unit a file without one is in: the one in which it is most like a room."""

from __future__ import annotations

from collections.abc import Iterable
from math import log

from housefly.errors import RoomError
from housefly.messages.words import Words, figure
from housefly.room.draft.imports.contracts import USUAL_UNITS, ImportHints
from housefly.room.draft.imports.drawing import PlanDrawing

_SIDE, _HEIGHT = 7.0, 2.6
"""Of a usual room that is flown in [m]; a hall and a cupboard are as far from it as each other."""
_HEIGHT_WEIGHT = 2.0
"""Heights of rooms differ less than their sides."""
_RARE = {0.0254: 1.0, 0.3048: 1.0}
"""Plans and scans in inches and feet are rarer than those in metric units."""

_PLAN_SIDES = (2.0, 80.0)
"""Of a plan whose unit is guessed [m]."""
_SAID_SIDES = (1.0, 200.0)
"""Of a plan whose unit was said, by somebody or by the file [m]."""
_SCALES = (10, 20, 25, 50, 100, 200)
"""At which plans are drawn on paper."""


def likely_units(
    units: Iterable[float],
    sides: tuple[float, float],
    allowed: tuple[float, float],
    height: float | None = None,
    heights: tuple[float, float] = (0.0, 0.0),
) -> tuple[float, ...]:
    """Return the units in which something may be a room, the likeliest first.

    Args:
        units: metres per unit that come into question.
        sides: length and width in the unit of the file.
        allowed: shortest and longest side [m].
        height: in the unit of the file, None where it has none.
        heights: lowest and highest [m].
    """

    def unlikeness(unit: float) -> float:
        flat = abs(log((sides[0] * sides[1]) ** 0.5 * unit / _SIDE)) + _RARE.get(unit, 0.0)
        return flat if height is None else flat + _HEIGHT_WEIGHT * abs(log(height * unit / _HEIGHT))

    fitting = [
        unit
        for unit in units
        if all(allowed[0] <= unit * side <= allowed[1] for side in sides)
        and (height is None or heights[0] <= unit * height <= heights[1])
    ]
    return tuple(sorted(fitting, key=unlikeness))


def plan_unit(
    sides: tuple[float, float], name: str, hints: ImportHints, drawing: PlanDrawing
) -> tuple[float, Words]:
    """Return metres per unit, and why: as somebody said, as the file says, as rooms are."""
    length, width = (figure(side, ".4g") for side in sides)
    if hints.unit is not None:
        said = [hints.unit * side for side in sides]
        if not all(_SAID_SIDES[0] <= side <= _SAID_SIDES[1] for side in said):
            raise RoomError(
                Words(
                    "{name} is {a} m x {b} m with unit={c}; allowed: {d} to {e} m: say another"
                    " unit",
                    name=name,
                    a=figure(said[0], ".4g"),
                    b=figure(said[1], ".4g"),
                    c=figure(hints.unit, "g"),
                    d=figure(_SAID_SIDES[0], "g"),
                    e=figure(_SAID_SIDES[1], "g"),
                )
            )
        return hints.unit, Words("one unit is {a} m, as you said", a=figure(hints.unit, "g"))
    declared = drawing.unit
    if declared and all(_SAID_SIDES[0] <= declared * side <= _SAID_SIDES[1] for side in sides):
        return declared, Words(
            "its numbers ({a} x {b}) are {words}: measure one wall, and say the unit if it is not"
            " so long",
            a=length,
            b=width,
            words=drawing.unit_words,
        )
    drawn = {declared * one: _drawn_at(one) for one in _SCALES} if declared else {}
    words = drawn | {u: Words("taken for {words}", words=n) for u, n in USUAL_UNITS.items()}
    choices = likely_units(words, sides, _PLAN_SIDES)
    if not choices:
        raise RoomError(
            Words(
                "{name} measures {a} x {b}: no room in any usual unit; say how many metres one"
                " unit is",
                name=name,
                a=length,
                b=width,
            )
        )
    unit = 1.0 if 1.0 in choices and not declared else choices[0]
    long, wide = (figure(unit * side, ".3g") for side in sides)
    if not declared:
        return unit, Words(
            "its numbers ({a} x {b}) are {words}, a room of {c} m x {d} m: measure one wall, and"
            " say the unit if it is not so long",
            a=length,
            b=width,
            words=words[unit],
            c=long,
            d=wide,
        )
    return unit, Words(
        "its numbers ({a} x {b}) cannot be {words}, and were {then}, a room of {c} m x {d} m:"
        " measure one wall, and say the unit if it is not so long",
        a=length,
        b=width,
        words=drawing.unit_words,
        then=words[unit],
        c=long,
        d=wide,
    )


def _drawn_at(scale: int) -> Words:
    return Words("drawn at 1:{n}", n=figure(scale))
