"""``housefly campaign`` as a person types it."""

from __future__ import annotations

import contextlib
import csv
import signal
import subprocess
import sys
import time
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from housefly.cli import main

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]

SMALL = """
name = "two rates"
seeds = 20
plot = ["stable", "rms_error"]
[mission]
waypoints = [[0, 0], [1, 0]]
task = "step"
duration_s = 5
[grid]
mocap_rate_hz = [10, 100]
mode = ["default", "paper"]
[draw]
lag = {normal = [7.0, 1.0]}
"""
LARGE = SMALL.replace("seeds = 20", "seeds = 600").replace("duration_s = 5", "duration_s = 4")


def command(folder: Path, *words: str, code: str = "from housefly.cli import main") -> list[str]:
    return [
        sys.executable,
        "-c",
        f"import sys; {code}; sys.exit(main(sys.argv[1:]))",
        "campaign",
        str(folder / "a.toml"),
        *words,
    ]


def run(
    folder: Path, *words: str, code: str = "from housefly.cli import main"
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command(folder, *words, code=code),
        capture_output=True,
        text=True,
        cwd=folder,
        timeout=100,
        check=False,
    )


def write(folder: Path, text: str = SMALL) -> None:
    (folder / "a.toml").write_text(text)


def run_here(folder: Path, *words: str) -> int:
    """Run the command in this process: one process less that imports everything anew."""
    with contextlib.chdir(folder):
        return main(["campaign", str(folder / "a.toml"), *words])


def test_a_campaign_leaves_results_summary_and_pictures(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(tmp_path)
    done = run(tmp_path)
    assert done.returncode == 0, done.stderr
    assert "4 points x 20 seeds = 80 drones, 400 drone-seconds" in done.stdout
    out = tmp_path / "campaigns" / "two_rates"
    assert pq.read_table(out / "results.parquet").num_rows == 80
    with (out / "summary.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [(row["mocap_rate_hz"], row["mode"]) for row in rows] == [
        ("10", "default"),
        ("10", "paper"),
        ("100", "default"),
        ("100", "paper"),
    ]
    for measure in ("stable", "rms_error"):
        assert (out / f"{measure}.png").read_bytes().startswith(b"\x89PNG")
        assert "<svg" in (out / f"{measure}.svg").read_text()
    assert "mocap rate hz [Hz]" in done.stdout and "rms error [m]" in done.stdout
    assert run_here(tmp_path) == 0
    assert "80 drones are there from an earlier run" in capsys.readouterr().out


def test_a_dry_run_says_how_long_and_writes_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(tmp_path, LARGE)
    assert run_here(tmp_path, "--dry-run") == 0
    said = capsys.readouterr().out
    assert "2,400 drones, 9,600 drone-seconds" in said
    assert " s here, in 10 chunks" in said
    assert [file.name for file in tmp_path.iterdir()] == ["a.toml"]


def test_ctrl_c_keeps_what_has_landed_and_the_next_run_ends_with_the_same_bytes(
    tmp_path: Path,
) -> None:
    write(tmp_path, LARGE)
    parts = tmp_path / "stopped" / "parts"
    with subprocess.Popen(
        command(tmp_path, "--out", "stopped"), stdout=subprocess.PIPE, text=True, cwd=tmp_path
    ) as flying:
        deadline = time.monotonic() + 60.0
        while len(list(parts.glob("*.parquet")) if parts.is_dir() else ()) < 2:
            assert time.monotonic() < deadline and flying.poll() is None
            time.sleep(0.005)
        flying.send_signal(signal.SIGINT)
        output, _ = flying.communicate(timeout=60.0)
    assert flying.returncode == 130
    assert "of 2,400 drones are kept in stopped: run the same again to go on" in output
    assert 2 <= len(list(parts.glob("*.parquet"))) < 10
    assert run_here(tmp_path, "--out", "stopped") == 0
    assert run_here(tmp_path, "--out", "whole", "--threads", "2") == 0
    results = [(tmp_path / out / "results.parquet").read_bytes() for out in ("stopped", "whole")]
    assert results[0] == results[1]


@pytest.mark.parametrize(
    ("text", "words", "told"),
    [
        (SMALL.replace("lag =", "lagg ="), (), "draw.lagg: is no column"),
        (
            SMALL.replace("[10, 100]", "[0, 100]"),
            (),
            "grid.mocap_rate_hz: is 0; allowed: a number from 1 to 400 Hz",
        ),
        (SMALL.replace("seeds = 20", 'seeds = 20\nsite = "nowhere"'), (), "no file 'nowhere'"),
        (SMALL, ("--threads", "0"), "--threads: is 0; allowed: a number from 1 to 1024"),
        (SMALL, ("--out", "a.toml/b"), "a.toml/b cannot be written"),
        (SMALL, ("--cluster", "tcp://127.0.0.1:9"), "no scheduler answers at tcp://127.0.0.1:9"),
    ],
)
def test_what_is_wrong_is_told_in_one_line(
    tmp_path: Path,
    text: str,
    words: tuple[str, ...],
    told: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    write(tmp_path, text)
    assert run_here(tmp_path, *words) == 2
    said = capsys.readouterr().err
    assert told in said
    assert len(said.splitlines()) == 1


@pytest.mark.parametrize(
    ("part", "extra"), [("pyarrow", "lab"), ("scipy", "lab"), ("distributed", "cluster")]
)
def test_a_missing_part_is_named_with_what_installs_it(
    tmp_path: Path, part: str, extra: str
) -> None:
    write(tmp_path)
    words = ("--cluster", "tcp://127.0.0.1:9") if part == "distributed" else ()
    done = run(
        tmp_path, *words, code=f"sys.modules[{part!r}] = None; from housefly.cli import main"
    )
    assert done.returncode == 2
    assert (
        done.stderr.startswith(f"housefly: {part} (")
        and f"pip install 'housefly[{extra}]'" in done.stderr
    )
