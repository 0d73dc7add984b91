"""What we export as a rosbag2 is read back as the same flight."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from housefly.app.flight_logs.read_log import read_flight_log
from housefly.record.mcap_log import McapLog
from housefly.record.replay import read_steps
from housefly.record.ros_topics import StepTopics
from housefly.record.rosbag import write_rosbag

RECORDED = Path(__file__).parents[2] / "record" / "data" / "default"


def test_a_flight_of_ours_comes_back_from_its_rosbag2(tmp_path: Path) -> None:
    log, topics = McapLog(tmp_path / "flight.mcap", {}), StepTopics(1.1)
    steps = list(read_steps(RECORDED))
    for step in steps:
        for sample in topics.of(step):
            log.add(*sample)
    log.close()
    write_rosbag(tmp_path, tmp_path / "bag")
    told = read_flight_log(tmp_path / "bag")
    known = [step.outputs.estimate for step in steps if step.outputs.estimate is not None]
    assert np.array_equal(told.position, [one.position for one in known])
    assert np.allclose(told.velocity, [one.velocity for one in known], atol=1e-9)
    assert told.sources["position"] == "/odom" and told.sources["battery"] == "/battery"
    events = [event.text for step in steps for event in step.outputs.events]
    assert [event.text for event in told.events] == events
