"""What a draft lacks is told in words with a mend, and what lacks nothing flies."""

from __future__ import annotations

from dataclasses import replace

import pytest
from drafts import whole_draft
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.errors import ConfigError
from housefly.room.draft.missing import DraftStep, missing
from housefly.room.draft.model import (
    DraftBox,
    DraftDrone,
    DraftPlace,
    DraftTracking,
    DraftZone,
    FramePoint,
    SiteDraft,
    with_size,
)
from housefly.room.draft.shapes import room_of_draft
from housefly.room.draft.site_of_draft import site_of_draft, suggested_places
from housefly.room.draft.suggestions import PAD_CLEARANCE, suggested_pad
from housefly.room.edits import reached_from
from housefly.room.grid import build_grid


def steps(draft: SiteDraft, *, hinders: bool = True) -> list[DraftStep]:
    return [item.step for item in missing(draft) if item.hinders or not hinders]


def words(draft: SiteDraft) -> str:
    return " ".join(f"{item.words} {item.mend}" for item in missing(draft))


@settings(max_examples=30)
@given(
    st.floats(2.5, 12.0),
    st.floats(2.5, 12.0),
    st.lists(
        st.builds(
            DraftBox, st.just("box"), st.floats(0.0, 12.0), st.floats(0.0, 12.0),
            st.floats(0.1, 3.0), st.floats(0.1, 3.0), st.floats(0.1, 2.4), yaw=st.floats(-3.1, 3.1),
        ),
        max_size=5,
    ),
)  # fmt: skip
def test_whatever_is_suggested_lacks_nothing(
    length: float, width: float, boxes: list[DraftBox]
) -> None:
    draft = replace(with_size(SiteDraft("lab"), length, width), furniture=tuple(boxes))
    pad = suggested_pad(draft)
    if pad is None:
        assert DraftStep.PAD in steps(draft)
        return
    draft = replace(draft, pad=pad)
    draft = replace(draft, places=suggested_places(draft))
    assert set(steps(draft)) <= {DraftStep.PLACES}  # a room may be too small for a place
    room, site = room_of_draft(draft), site_of_draft(draft)
    grid = build_grid(room, site)
    reached = reached_from(grid, room.home)
    assert grid.is_free(grid.cell_of(room.home))
    for place in room.places:
        assert reached[grid.cell_of(place.viewpoint)]


def test_an_empty_draft_asks_for_the_room_first() -> None:
    assert steps(SiteDraft()) == [DraftStep.ROOM]
    assert "6x4x2.5" in words(SiteDraft())


def test_a_whole_rectangle_lacks_nothing() -> None:
    assert missing(whole_draft()) == ()


def test_a_pad_on_low_furniture_is_refused_though_the_drone_flies_over_it() -> None:
    draft = whole_draft()
    assert draft.pad is not None
    bed = DraftBox("bed", *draft.pad, 2.0, 1.0, 0.5)
    assert steps(replace(draft, furniture=(bed,))) == [DraftStep.PAD]
    pad = suggested_pad(replace(draft, furniture=(bed,)))
    assert pad is not None
    gap_x, gap_y = abs(pad[0] - bed.x) - 1.0, abs(pad[1] - bed.y) - 0.5
    assert max(gap_x, gap_y) >= PAD_CLEARANCE - 0.01


def test_a_room_full_of_low_things_has_no_spot_for_a_pad() -> None:
    beds = DraftBox("beds", 3.0, 2.0, 6.0, 4.0, 0.5)
    draft = replace(with_size(SiteDraft("lab"), 6.0, 4.0), furniture=(beds,))
    assert suggested_pad(draft) is None
    assert steps(draft)[0] is DraftStep.PAD


def test_a_pad_in_a_wall_or_outside_is_told_with_a_better_one() -> None:
    for pad in ((0.1, 2.0), (9.0, 9.0)):
        assert DraftStep.PAD in steps(replace(whole_draft(), pad=pad))
        assert "is roomy" in words(replace(whole_draft(), pad=pad))


def test_a_place_that_cannot_be_reached_is_named() -> None:
    draft = replace(whole_draft(), places=(DraftPlace("corner", 0.1, 0.1),))
    assert steps(draft) == [DraftStep.PLACES]
    assert "corner" in words(draft)


def test_two_places_of_one_name_are_told() -> None:
    spot = whole_draft().places[0]
    assert steps(replace(whole_draft(), places=(spot, spot))) == [DraftStep.PLACES]


def test_a_zone_over_the_pad_is_told() -> None:
    draft = whole_draft()
    assert draft.pad is not None
    x, y = draft.pad
    zone = DraftZone((x - 0.3, y - 0.3, x + 0.3, y + 0.3), "children play here")
    assert DraftStep.ZONES in steps(replace(draft, zones=(zone,)))


def test_a_zone_without_area_is_told_and_not_a_crash() -> None:
    draft = replace(whole_draft(), zones=(DraftZone((2.0, 2.0, 2.0, 2.0), "nothing"),))
    assert DraftStep.ROOM in steps(draft) or DraftStep.ZONES in steps(draft)


def test_a_room_in_millimetres_that_nobody_could_fly_in_is_told() -> None:
    draft = replace(SiteDraft("lab"), bounds=(0.0, 0.0, 0.006, 0.004))
    assert steps(draft)
    assert "metres" in words(draft)


def test_a_ceiling_below_the_flight_height_is_told() -> None:
    assert DraftStep.ROOM in steps(replace(whole_draft(), height=1.2))


def test_real_hardware_needs_tracking_and_drone_and_advises_on_the_frame() -> None:
    draft = replace(whole_draft(), hardware=True)
    assert steps(draft) == [DraftStep.TRACKING, DraftStep.DRONE]
    draft = replace(
        draft, tracking=DraftTracking("vicon", "10.0.0.5"), drone=DraftDrone("10.0.0.7")
    )
    assert steps(replace(draft, drone=DraftDrone())) == [DraftStep.DRONE]
    assert steps(draft) == []
    assert steps(draft, hinders=False) == [DraftStep.FRAME, DraftStep.DRONE]
    assert "preflight --frames" in words(draft)


def test_points_of_the_frame_that_disagree_hinder() -> None:
    points = tuple(
        FramePoint(name, (x, y, 0.05), (x + off, y, 0.05))
        for name, x, y, off in (("a", 1.0, 1.0, 0.0), ("b", 5.0, 1.0, 0.5), ("c", 1.0, 3.0, 0.0))
    )
    draft = replace(
        whole_draft(), hardware=True, tracking=DraftTracking("vicon", "10.0.0.5"),
        drone=DraftDrone("10.0.0.7"), frame_points=points,
    )  # fmt: skip
    assert steps(draft) == [DraftStep.FRAME]


def test_sizes_that_no_room_has_are_refused() -> None:
    for length in (0.0, -1.0, 1e6, float("nan")):
        with pytest.raises(ConfigError, match="allowed"):
            with_size(SiteDraft(), length, 4.0)
