"""What the page shows of a draft."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from housefly.room.draft.model import DraftBox, FramePoint, SiteDraft, with_size
from housefly.web.new_site.draft_view import fit_view, flyable, scan_view

ROOM = with_size(SiteDraft(), 4.0, 3.0)


def letter_at(draft: SiteDraft, x: float, y: float) -> str:
    scan = scan_view(draft)
    assert scan is not None
    return scan.rows[int((y - scan.origin[1]) / scan.resolution)][
        int((x - scan.origin[0]) / scan.resolution)
    ]


def test_a_scan_tells_what_is_tall_what_is_low_and_what_nobody_saw() -> None:
    boxes = (
        DraftBox("sofa", 1.0, 1.0, 0.5, 0.5, top=0.4),
        DraftBox("lamp", 1.0, 1.0, 0.1, 0.1, top=1.8),
        DraftBox("dark", 3.0, 2.0, 1.0, 1.0, top=2.5, thing="unexplored"),
    )
    draft = replace(ROOM, scanned=boxes)
    assert [letter_at(draft, *at) for at in ((1.0, 1.0), (0.8, 0.8), (3.0, 2.0), (2.0, 2.0))] == [
        *("#", "l", "u"),
        ".",
    ]
    assert scan_view(ROOM) is None and flyable(SiteDraft()) is None


@given(
    x=st.floats(-900.0, 900.0),
    y=st.floats(-900.0, 900.0),
    length=st.floats(0.01, 900.0),
    yaw=st.floats(-6.3, 6.3),
    side=st.floats(1.0, 200.0),
)
def test_a_box_wherever_it_is_leaves_the_picture_as_large_as_the_floor(
    x: float, y: float, length: float, yaw: float, side: float
) -> None:
    draft = replace(
        with_size(SiteDraft(), side, 3.0), scanned=(DraftBox("b", x, y, length, 0.3, 1.0, yaw=yaw),)
    )
    scan = scan_view(draft)
    assert scan is not None and len(scan.rows) == scan.height and scan.width <= 401
    assert {len(row) for row in scan.rows} == {scan.width}
    assert scan.width * scan.resolution >= side - 1e-9


def test_points_that_cannot_be_fitted_say_why_and_are_not_trusted() -> None:
    point = FramePoint("a", (1.0, 1.0, 0.0), (0.0, 0.0, 0.0))
    assert fit_view(replace(ROOM, frame_points=(point,))) is None
    found = fit_view(replace(ROOM, frame_points=(point, point)))
    assert found is not None and not found.trusted and "0.00 m of each other" in found.words[0]
