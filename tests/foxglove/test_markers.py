"""What is drawn in space stands where the room, the tracking system and the sensors say."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.interfaces import type_store
from housefly.config.furniture import FurnitureConfig
from housefly.foxglove.markers import obstacle_markers, solid_markers, tracked_markers
from housefly.messages import Obstacle, ObstacleKind, Pose, Sighting
from housefly.room.bsen import bsen

ROOM = bsen()
PLACES = st.tuples(st.floats(-9.0, 9.0), st.floats(-9.0, 9.0))


@given(
    st.builds(
        Obstacle,
        id=st.text(max_size=10),
        position=PLACES,
        radius=st.floats(0.0, 1.0),
        size=st.tuples(st.floats(0.0, 2.0), st.floats(0.0, 2.0)),
        yaw=st.floats(-3.1, 3.1),
        top=st.floats(0.0, 3.0),
        confidence=st.sampled_from((0.0, 0.4, 1.0)),
        source=st.sampled_from(("", "laser-1")),
        kind=st.sampled_from(ObstacleKind),
    )
)
def test_an_obstacle_is_one_marker_at_its_place_and_is_taken_away_when_it_is_gone(
    obstacle: Obstacle,
) -> None:
    told = obstacle_markers(1e9, obstacle)
    data = type_store().serialize_cdr(told, told.__msgtype__)
    (marker,) = type_store().deserialize_cdr(data, told.__msgtype__).markers
    assert (marker.pose.position.x, marker.pose.position.y) == obstacle.position
    assert marker.scale.x >= 2.0 * obstacle.radius
    assert (marker.action == 2) == (obstacle.confidence == 0.0)
    assert marker.lifetime.sec > 0
    assert obstacle_markers(2e9, obstacle).markers[0].id == marker.id


def test_the_walls_and_the_furniture_are_the_rooms_and_stay() -> None:
    markers = solid_markers(1e9, ROOM).markers
    solids = markers[: len(ROOM.solids)]
    assert [one.ns for one in solids] == [solid.thing for solid in ROOM.solids]
    assert len({(one.ns, one.id) for one in markers}) == len(markers)
    assert all(one.lifetime.sec == 0 for one in markers)
    named = {place.title or place.name for place in ROOM.places}
    assert {one.text for one in markers if one.text} == named


@given(PLACES, st.floats(-3.0, 3.0))
def test_only_furniture_and_people_that_the_site_names_are_drawn(
    at: tuple[float, float], height: float
) -> None:
    seen = [Sighting(name, Pose((*at, height)), 1.0, 1.0) for name in ("chair", "kim", "drone")]
    chair = FurnitureConfig(name="chair", body="chair")
    told = tracked_markers(1e9, seen, {"chair": chair}, {"kim": 0.25}).markers
    assert [one.ns for one in told] == ["furniture", "people"]
    assert all((one.pose.position.x, one.pose.position.y) == at for one in told)
