"""What the pilot answers about the room is read again as it was meant."""

from __future__ import annotations

import pytest

from housefly.app.pilot_queries import PilotQueryServer
from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.hub.api.pilot_queries import PlanRequest
from housefly.hub.api.pilot_queries_json import from_json, to_json
from housefly.messages import PlanAnswer
from housefly.sites.loaded_site import load_site

TOPICS = DroneTopics()


@pytest.mark.parametrize("planner", ["space", "grid"])
def test_a_way_is_told_before_anyone_flies_it(planner: str) -> None:
    bus = LocalBus()
    PilotQueryServer(load_site("bsen", hub__enabled=False, map__planner=planner), bus)
    text = bus.ask(TOPICS.plan, to_json(PlanRequest(place="entrance")))
    answer = from_json(PlanAnswer, text)
    assert answer.path is not None and len(answer.path.waypoints) > 2 and answer.duration > 5.0
