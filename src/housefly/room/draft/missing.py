"""What a draft still lacks before it flies, each with what mends it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np

from housefly.config.validation import refusal_words
from housefly.errors import ConfigError, HouseflyError
from housefly.messages.words import Words, figure, literal, percentage
from housefly.room.distance import clearance_field, footprints
from housefly.room.draft.alignment import fit_doubts, rigid_fit
from housefly.room.draft.model import SiteDraft
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft, tracking_config
from housefly.room.draft.suggestions import PAD_CLEARANCE, suggested_pad
from housefly.room.edits import blocked_words, reached_from
from housefly.room.grid import OccupancyGrid, build_grid, inflation
from housefly.room.home_pad import HOME_PAD_RADIUS
from housefly.room.model import Room
from housefly.room.reach import Mask

_CORRECT = Words("correct that value")
_AGAIN = Words("take the points again")
CUT_OFF_MAX = 0.05
"""More of the free floor behind what no way leads around is told, as a share."""


class DraftStep(Enum):
    """The steps of a description, in the order in which they are asked."""

    ROOM = "room"
    OBJECTS = "objects"
    PAD = "pad"
    PLACES = "places"
    ZONES = "zones"
    TRACKING = "tracking"
    FRAME = "frame"
    DRONE = "drone"


@dataclass(frozen=True, slots=True)
class Missing:
    """One thing that a draft lacks.

    Attributes:
        step: where it is mended.
        words: what is missing or wrong.
        mend: what to do.
        hinders: whether the site cannot fly without it; False is advice.
    """

    step: DraftStep
    words: Words
    mend: Words
    hinders: bool = True


def missing(draft: SiteDraft) -> tuple[Missing, ...]:
    """Return what a draft lacks, in the order of the steps; none that hinders: it can fly."""
    found = [*_of_room(draft), *_of_hardware(draft)]
    order = list(DraftStep)
    return tuple(sorted(found, key=lambda item: order.index(item.step)))


def _of_room(draft: SiteDraft) -> Iterator[Missing]:
    if draft.bounds is None:
        yield Missing(
            DraftStep.ROOM,
            Words("the room has no size yet"),
            Words("give length x width x height in metres (6x4x2.5), or a file of the room"),
        )
        return
    try:
        room = room_of_draft(draft)
        site = site_of_draft(draft, simulated=True)
        grid = build_grid(room, site)
    except HouseflyError as error:
        yield Missing(DraftStep.ROOM, refusal_words(error), _CORRECT)
        return
    if draft.height < draft.flight_height + 0.4:
        yield Missing(
            DraftStep.ROOM,
            Words(
                "the ceiling ({a} m) is less than 0.4 m above the flight height ({b} m)",
                a=figure(draft.height, "g"),
                b=figure(draft.flight_height, "g"),
            ),
            Words("correct the height of the room, or lower flight_height"),
        )
    if not (draft.walls or draft.scanned):
        yield Missing(
            DraftStep.OBJECTS,
            Words("the room has no walls"),
            Words("draw them, or give the size again: a rectangle brings its four walls"),
            hinders=False,
        )
    yield from _of_pad(draft, room, grid)
    if draft.pad is not None:
        yield from _of_places(draft, room, grid)
    yield from _of_zones(draft)


def _of_pad(draft: SiteDraft, room: Room, grid: OccupancyGrid) -> Iterator[Missing]:
    suggested = suggested_pad(draft)
    if suggested is None:
        yield Missing(
            DraftStep.PAD,
            Words("the drone fits nowhere in this room"),
            Words(
                "check the unit of the file or the size: are they metres? Or take furniture and"
                " zones out"
            ),
        )
        return
    roomy_x, roomy_y = (figure(value, ".2f") for value in suggested)
    if draft.pad is None:
        yield Missing(
            DraftStep.PAD,
            Words("it is not said where the pad lies, on which the drone starts and lands"),
            Words("say where: ({x}, {y}) m is roomy", x=roomy_x, y=roomy_y),
        )
        return
    x, y = draft.pad
    move = Words("move the pad: ({x}, {y}) m is roomy", x=roomy_x, y=roomy_y)
    if not grid.is_free(grid.cell_of(draft.pad)):
        yield Missing(
            DraftStep.PAD,
            Words(
                "the drone cannot start at ({x}, {y}) m: {why}",
                x=figure(x, ".2f"),
                y=figure(y, ".2f"),
                why=blocked_words(grid, draft.pad, site_of_draft(draft, simulated=True)),
            ),
            move,
        )
        return
    standing = footprints(room.solids, 0.02, draft.flight_height)
    gap = float(clearance_field(standing, np.array([x]), np.array([y]), 5.0)[0, 0])
    if gap < PAD_CLEARANCE:
        yield Missing(
            DraftStep.PAD,
            Words(
                "something stands on the floor {a} m from the middle of the pad, and the drone"
                " starts with {b} m and more around it",
                a=figure(gap, ".2f"),
                b=figure(PAD_CLEARANCE, ".2f"),
            ),
            move,
        )


def _of_places(draft: SiteDraft, room: Room, grid: OccupancyGrid) -> Iterator[Missing]:
    others = [place for place in draft.places if place.name != "home"]
    if not others:
        yield Missing(
            DraftStep.PLACES,
            Words("there is no place to fly to"),
            Words("name one and say where it is"),
        )
    names = [place.name for place in others]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield Missing(
            DraftStep.PLACES,
            Words("two places are called {place}", place=repr(name)),
            Words("rename one"),
        )
    if not grid.is_free(grid.cell_of(room.home)):
        return
    reached = reached_from(grid, room.home)
    yield from _of_cut_off_floor(draft, grid, reached)
    for place in others:
        cell = grid.cell_of((place.x, place.y))
        if grid.contains(cell) and reached[cell]:
            continue
        why = blocked_words(grid, (place.x, place.y), site_of_draft(draft, simulated=True))
        yield Missing(
            DraftStep.PLACES,
            Words(
                "the drone cannot hover at {place}, ({x}, {y}) m: {why}",
                place=repr(place.name),
                x=figure(place.x, ".2f"),
                y=figure(place.y, ".2f"),
                why=why,
            ),
            Words("move it, or leave it out"),
        )


def _of_cut_off_floor(draft: SiteDraft, grid: OccupancyGrid, reached: Mask) -> Iterator[Missing]:
    """Yield that furniture cuts off a part of the floor; walls are meant to."""
    if not draft.furniture:
        return
    site, bare = site_of_draft(draft, simulated=True), room_of_draft(replace(draft, furniture=()))
    was_free = reached_from(build_grid(bare, site), bare.home) & (grid.clearance >= inflation(site))
    cut_off = 1.0 - (was_free & reached).sum() / max(1, int(was_free.sum()))
    if cut_off > CUT_OFF_MAX:
        yield Missing(
            DraftStep.OBJECTS,
            Words("{p} % of the free floor cannot be reached from the pad", p=percentage(cut_off)),
            Words("clear a way, or leave it so"),
            hinders=False,
        )


def _of_zones(draft: SiteDraft) -> Iterator[Missing]:
    for zone in draft.zones:
        x_min, y_min, x_max, y_max = zone.rectangle
        if draft.pad is None:
            continue
        x, y = draft.pad
        dx, dy = max(x_min - x, 0.0, x - x_max), max(y_min - y, 0.0, y - y_max)
        if dx * dx + dy * dy < HOME_PAD_RADIUS**2:
            yield Missing(
                DraftStep.ZONES,
                Words("the zone {name} covers the pad", name=repr(zone.reason)),
                Words(
                    "keep it {a} m away from ({x}, {y}) m",
                    a=figure(HOME_PAD_RADIUS, ".2f"),
                    x=figure(x, ".2f"),
                    y=figure(y, ".2f"),
                ),
            )


def _of_hardware(draft: SiteDraft) -> Iterator[Missing]:
    if not draft.hardware:
        return
    if draft.tracking is None:
        yield Missing(
            DraftStep.TRACKING,
            Words("it is not said which motion capture system sees the drone"),
            Words("say its kind and address, such as: vicon 10.0.0.5"),
        )
    else:
        try:
            tracking_config(draft.tracking)
        except ConfigError as error:
            yield Missing(DraftStep.TRACKING, refusal_words(error), _CORRECT)
    yield from _of_frame(draft)
    if draft.drone is None or not draft.drone.address:
        yield Missing(
            DraftStep.DRONE,
            Words("it is not said where the drone answers"),
            Words("say its model and its address, such as: tello 192.168.10.1"),
        )
    elif not draft.drone.profile:
        yield Missing(
            DraftStep.DRONE,
            Words(
                "the drone flies with the constants of a usual {name}",
                name=draft.drone.airframe.name,
            ),
            Words("measure yours: housefly identify (docs/identify-and-gains.md)"),
            hinders=False,
        )


def _of_frame(draft: SiteDraft) -> Iterator[Missing]:
    if not draft.frame_points:
        yield Missing(
            DraftStep.FRAME,
            Words("nobody compared the tracking frame with the map yet"),
            Words(
                "take three points here, or carry the drone: housefly preflight --frames --site"
                " SITE"
            ),
            hinders=False,
        )
        return
    try:
        fit = rigid_fit(draft.frame_points)
    except ConfigError as error:
        yield Missing(DraftStep.FRAME, literal(error.problem), _AGAIN)
        return
    for doubt in fit_doubts(fit, draft.frame_points):
        yield Missing(DraftStep.FRAME, doubt, _AGAIN, hinders=not fit.is_trusted)
