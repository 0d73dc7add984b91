from __future__ import annotations

from pathlib import Path

import pytest

from housefly.lab.safety_case.wired_flight import WiredKey, fly_wired


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.interop
@pytest.mark.timeout(300)
def test_a_child_whom_only_raw_ultrasound_shows_is_not_landed_on(tmp_path: Path) -> None:
    """By the altitude that the drone itself flies by nobody is there: it was landed on."""
    flown = fly_wired(WiredKey("F44/unscanned_child", 0), tmp_path, 9)
    assert flown.violations == ()
    assert "stand below" in flown.outcome
