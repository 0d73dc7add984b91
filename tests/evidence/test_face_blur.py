"""A blurred face cannot be recognised; the rest of the picture stays."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from housefly.evidence.face_blur import with_blurred_boxes

SIDE = st.floats(-50, 400)


@given(st.lists(st.tuples(SIDE, SIDE, SIDE, SIDE), max_size=4))
def test_any_box_is_blurred_and_nothing_far_beside_it(
    boxes: list[tuple[float, float, float, float]],
) -> None:
    picture = np.random.default_rng(1).integers(0, 255, (180, 320, 3), dtype=np.uint8)
    shown = with_blurred_boxes(picture, boxes)
    assert shown.shape == picture.shape
    touched = np.zeros((180, 320), dtype=bool)
    for left, top, right, bottom in boxes:
        if left > right or top > bottom:
            continue
        wide, high = 0.3 * (right - left) + 1, 0.3 * (bottom - top) + 1
        touched[
            max(0, int(top - high)) : max(0, int(bottom + high) + 2),
            max(0, int(left - wide)) : max(0, int(right + wide) + 2),
        ] = True
        face = shown[max(0, int(top)) : max(0, int(bottom)), max(0, int(left)) : max(0, int(right))]
        if min(face.shape[:2], default=0) >= 16:
            assert face.astype(float).std() < 20, "noise of a deviation of 74 is gone"
    assert (shown[~touched] == picture[~touched]).all()
