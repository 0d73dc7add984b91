"""What a viewer sees of the camera is what may be seen, in whole groups of pictures."""

from __future__ import annotations

from filming import video
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.house_mode import HouseMode
from housefly.config.tasks import PrivacyZone, TasksConfig
from housefly.evidence.live_blanker import LiveBlanker
from housefly.evidence.picture_filter import PictureFilter

ZONE = PrivacyZone(name="bed", polygon=((5, -2), (7, -2), (7, 2), (5, 2)), z_min=0.0, z_max=1.0)
FRAMES = tuple(video(3.0))


@given(st.lists(st.booleans(), min_size=len(FRAMES), max_size=len(FRAMES)))
def test_a_picture_goes_out_only_while_it_may_and_never_without_its_key_frame(
    allowed: list[bool],
) -> None:
    now = iter(allowed)
    picture = PictureFilter(LiveBlanker(TasksConfig(), None), lambda: (next(now), HouseMode.HOME))
    can_be_decoded = False
    for frame, may in zip(FRAMES, allowed, strict=True):
        shown = picture.shown(frame)
        can_be_decoded = may and (frame.keyframe or can_be_decoded)
        assert (shown is frame) == can_be_decoded
        assert shown is None or shown is frame


def test_where_there_are_zones_no_picture_of_the_drone_goes_out_as_it_came() -> None:
    blanker = LiveBlanker(TasksConfig(privacy_zones=(ZONE,)), None)
    picture = PictureFilter(blanker, lambda: (True, None))
    shown = [picture.shown(frame) for frame in FRAMES[:5]]
    originals = {frame.data for frame in FRAMES}
    assert any(shown)
    assert all(frame is None or frame.data not in originals for frame in shown)
