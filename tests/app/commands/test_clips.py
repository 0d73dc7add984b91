"""Clips from the command line, whether the site runs or not."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from clip_rows import DAY, added, clip
from filming import video
from PIL import Image

from housefly.cli import main
from housefly.config.state import clips_folder, edits_folder
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_writer import ClipWriter
from housefly.sites.loaded_site import read_site

Capture = pytest.CaptureFixture[str]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return clips_folder(read_site("bsen"))


@pytest.fixture
def index(folder: Path) -> Iterator[ClipIndex]:
    made = ClipIndex(folder, read_site("bsen").tasks)
    yield made
    made.close()


def filmed(index: ClipIndex, folder: Path, **known: object) -> str:
    """Add a clip that plays."""
    row = clip(time.time() - 60.0, **known)
    writer = ClipWriter(folder / row.file_name)
    for frame in video(1.0):
        writer.add(frame)
    written = writer.finish()
    assert written is not None
    index.finish(replace(row, size=written.size, duration=written.duration))
    return row.id


def test_clips_are_listed_by_what_they_show(
    index: ClipIndex, folder: Path, capsys: Capture
) -> None:
    known = {"place": "entrance", "people": ("anna",), "drone": "kestrel"}
    name = filmed(index, folder, cut_off=True, **known)
    added(index, folder, clip(time.time() - 30.0, "snapshot", thing="cup"))
    assert main(["clips", "list"]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 2
    assert main(["clips", "list", "--person", "Anna", "--since", "1h"]) == 0
    (line,) = capsys.readouterr().out.splitlines()
    assert line.startswith(name)
    assert "clip, 1 s: anna, entrance  (look, task 3, kestrel; until" in line
    assert "cut off" in line
    assert main(["clips", "list", "--thing", "book"]) == 0
    assert (
        capsys.readouterr().out
        == "no such clip: the camera records only while a task asks for it\n"
    )
    assert main(["clips", "list", "--limit", "0"]) == 2
    assert "limit" in capsys.readouterr().err


def test_an_export_has_the_clip_a_picture_and_what_is_known_and_is_in_the_audit_log(
    index: ClipIndex, folder: Path, tmp_path: Path, capsys: Capture
) -> None:
    name = filmed(index, folder, place="entrance")
    index.log_access(name, "anna")
    out = tmp_path / "out"
    assert main(["clips", "export", name, "--out", str(out)]) == 0
    assert str(out / f"{name}.mp4") in capsys.readouterr().out
    assert Image.open(out / f"{name}.jpg").size[0] > 100
    (known,) = json.loads((out / "clips.json").read_text())
    assert (known["place"], known["task"], known["cause"]) == ("entrance", 3, "event-1")
    assert [view["what"] for view in known["views"]] == ["watched", "exported"]
    assert known["views"][0]["who"] == "anna"
    log = edits_folder(read_site("bsen")).with_name("commands.jsonl")
    (line,) = map(json.loads, log.read_text().splitlines())
    assert line["what"] == f"exported the clips {name} to {out}"
    assert line["who"].endswith("at the terminal")
    assert main(["clips", "export", "nothing", "--out", str(out)]) == 2
    assert "there is no clip" in capsys.readouterr().err


def test_tidying_by_hand_deletes_what_is_too_old_and_believes_a_person(
    index: ClipIndex, folder: Path, capsys: Capture
) -> None:
    old = added(index, folder, clip(time.time() - 50 * DAY))
    assert main(["clips", "tidy"]) == 0
    out = capsys.readouterr().out
    assert "the clock went on by 50 days at once" in out and "nothing was deleted" in out
    assert main(["clips", "tidy", "--clock-is-right"]) == 0
    assert capsys.readouterr().out == f"deleted: {old}\n"
    assert not (folder / f"{old}.mp4").exists()
