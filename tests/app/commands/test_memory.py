"""ROS-TMS's database goes into a site's memory and comes out again, by command."""

from __future__ import annotations

from pathlib import Path

import pytest

from housefly.cli import main
from housefly.errors import HouseflyError

DUMP = Path(__file__).resolve().parents[2] / "hub" / "store" / "data" / "bsen_now.json"


@pytest.fixture(autouse=True)
def _own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))


@pytest.mark.slow
def test_b_sens_own_dump_is_read_asked_and_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["memory", "import-tms", str(DUMP)]) == 0
    assert "things" in capsys.readouterr().out
    assert main(["where", "ardrone"]) == 0
    out = tmp_path / "out.json"
    assert main(["memory", "export-tms", str(out)]) == 0
    assert len(out.read_text().splitlines()) >= len(DUMP.read_text().splitlines()) // 2
    capsys.readouterr()
    assert main(["memory", "import-tms", str(out)]) == 0


def test_a_file_that_is_none_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    try:
        code = main(["memory", "import-tms", str(tmp_path / "nothing.json")])
    except HouseflyError as error:  # main may print it and return
        code = 1 if "nothing.json" in str(error) else 0
    assert code != 0
