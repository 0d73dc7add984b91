"""What a run writes tells who was where: nobody else may read it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from housefly.cli import main


@pytest.fixture(autouse=True)
def usual_umask() -> Iterator[None]:
    before = os.umask(0o022)
    yield
    assert os.umask(before) == 0o022, "a command changed the umask for good"


@pytest.mark.slow
def test_a_recorded_flight_is_for_its_user_alone(tmp_path: Path) -> None:
    out, site = tmp_path / "flights" / "one", tmp_path / "quick.toml"
    site.write_text("[control]\nrate_hz = 25\n[twin]\nmocap_rate_hz = 25\n")
    line = ["fly", "tv", "--lockstep", "--headless", "--look", "0", "--site", str(site)]
    assert main([*line, "--out", str(out)]) == 0
    found = [out.parent, out, *out.rglob("*")]
    assert len(found) > 4
    for path in found:
        assert path.stat().st_mode & 0o077 == 0, path
