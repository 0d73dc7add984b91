"""Results on disk: kept as they land, proved whole, never mixed."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.parquet as pq
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.errors import ConfigError, RecordingError
from housefly.lab.campaigns.folder import DESCRIPTION_FILE, CampaignFolder
from housefly.lab.campaigns.plan import Chunk, Plan
from housefly.lab.campaigns.provenance import versions
from housefly.lab.campaigns.runner import LocalFleet, fly_chunks
from housefly.lab.experiments.cases import CASE, PARAMETERS
from housefly.lab.experiments.engine import Progress, fly_many
from housefly.lab.experiments.outcomes import MEASURES, OUTCOME, Outcomes


class StoppedFleet(LocalFleet):
    """Gives up after some chunks."""

    def __init__(self, after: int) -> None:
        super().__init__(1)
        self.after = after

    def fly(
        self, plan: Plan, chunks: tuple[Chunk, ...], on_landed: Progress
    ) -> Iterator[tuple[Chunk, Outcomes]]:
        yield from super().fly(plan, chunks[: self.after], on_landed)
        raise KeyboardInterrupt


def fly(plan: Plan, path: Path, threads: int = 1) -> bytes:
    with CampaignFolder(path, plan) as folder:
        fly_chunks(plan, folder.missing(), folder, LocalFleet(threads))
        return folder.finish().read_bytes()


def missing(plan: Plan, path: Path) -> list[int]:
    with CampaignFolder(path, plan) as folder:
        return [chunk.number for chunk in folder.missing()]


def part(path: Path, number: int) -> Path:
    return path / "parts" / f"part-{number:06d}.parquet"


def test_every_column_and_measure_of_every_drone_is_kept_with_its_unit(
    small: Any, tmp_path: Path
) -> None:
    plan = small()
    fly(plan, tmp_path)
    table = pq.read_table(tmp_path / "results.parquet")
    flown = [
        fly_many(plan.cases_of(chunk)[0], plan.groups[chunk.group].mission, threads=2)
        for chunk in plan.chunks
    ]
    cases = np.concatenate([plan.cases_of(chunk)[0] for chunk in plan.chunks])
    for name in CASE.names or ():
        assert table[name].to_numpy().tobytes() == np.ascontiguousarray(cases[name]).tobytes(), name
    for name in OUTCOME.names or ():
        assert (
            table[name].to_numpy().tobytes()
            == np.concatenate([rows[name] for rows in flown]).tobytes()
        ), name
    for known in (*PARAMETERS, *MEASURES):
        assert table.schema.field(known.name).metadata[b"unit"] == known.unit.encode()


@pytest.mark.parametrize("after", [0, 1, 3])
def test_a_campaign_that_was_stopped_ends_with_the_same_bytes(
    small: Any, tmp_path: Path, after: int
) -> None:
    plan = small()
    whole = fly(plan, tmp_path / "whole", threads=2)
    with CampaignFolder(tmp_path / "stopped", plan) as folder, pytest.raises(KeyboardInterrupt):
        fly_chunks(plan, folder.missing(), folder, StoppedFleet(after))
    assert len(missing(plan, tmp_path / "stopped")) == len(plan.chunks) - after
    kept = {file: file.stat().st_mtime_ns for file in (tmp_path / "stopped" / "parts").iterdir()}
    assert fly(plan, tmp_path / "stopped") == whole
    assert {file: file.stat().st_mtime_ns for file in kept} == kept


def test_one_thread_and_four_give_the_same_bytes(small: Any, tmp_path: Path) -> None:
    assert fly(small(), tmp_path / "one", threads=1) == fly(small(), tmp_path / "four", threads=4)


def test_torn_exchanged_and_absent_parts_are_flown_anew(small: Any, tmp_path: Path) -> None:
    plan = small()
    whole = fly(plan, tmp_path)
    torn, exchanged, absent, empty = (part(tmp_path, number) for number in range(4))
    torn.write_bytes(torn.read_bytes()[:-100])
    shutil.copy(part(tmp_path, 4), exchanged)
    absent.unlink()
    empty.write_bytes(b"")
    assert missing(plan, tmp_path) == [0, 1, 2, 3]
    assert fly(plan, tmp_path) == whole


@settings(
    max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(share=st.floats(0.0, 1.0, exclude_max=True), bit=st.integers(0, 7))
def test_no_bit_that_flips_on_the_disk_reaches_the_results(
    small: Any, tmp_path: Path, share: float, bit: int
) -> None:
    plan = small()
    with CampaignFolder(tmp_path, plan) as folder:
        fly_chunks(plan, folder.missing(), folder, LocalFleet(1))
        whole = folder.finish().read_bytes()
        file = part(tmp_path, 3)
        content = bytearray(file.read_bytes())
        content[int(share * len(content))] ^= 1 << bit
        file.write_bytes(content)
        found = [chunk.number for chunk in folder.missing()]
        assert found in ([], [3])
        if not found:
            assert folder.finish().read_bytes() == whole


def test_a_part_of_another_campaign_is_flown_anew(small: Any, tmp_path: Path) -> None:
    fly(small(first_seed=1000), tmp_path / "other")
    whole = fly(small(), tmp_path / "own")
    shutil.copy(part(tmp_path / "other", 2), part(tmp_path / "own", 2))
    assert missing(small(), tmp_path / "own") == [2]
    assert fly(small(), tmp_path / "own") == whole


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ({"seeds": 31}, "spec.seeds: there 30, here 31"),
        ({"fixed": {"alpha": 2.0}}, "spec.fixed.alpha: there nothing, here 2.0"),
        (
            {"draw": {"lag": {"normal": [7.0, 2.0]}}},
            "spec.draw.lag.normal: there [7.0, 1.0], here [7.0, 2.0]",
        ),
        ({"site": changed(Site(), control__alpha=3.0)}, "drone.default.alpha: there 3.6, here 3.0"),
        ({"chunk": 26}, "chunk: there 25, here 26"),
    ],
)
def test_the_folder_of_another_campaign_is_refused_by_key(
    small: Any, tmp_path: Path, keys: dict[str, Any], words: str
) -> None:
    before = fly(small(), tmp_path)
    with pytest.raises(ConfigError) as caught:
        CampaignFolder(tmp_path, small(**keys))
    assert words in caught.value.problem
    assert "--fresh" in caught.value.problem
    assert (tmp_path / "results.parquet").read_bytes() == before
    with CampaignFolder(tmp_path, small(**keys), fresh=True) as folder:
        assert len(folder.missing()) == len(small(**keys).chunks)


def test_numbers_of_other_code_are_not_mixed_in(
    small: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fly(small(), tmp_path)
    other = versions() | {"code": "0123456789abcdef"}
    monkeypatch.setattr("housefly.lab.campaigns.provenance.versions", lambda: other)
    with pytest.raises(ConfigError, match=r"made_by\.code"):
        CampaignFolder(tmp_path, small())


def test_what_is_only_said_or_drawn_flies_nothing_anew(small: Any, tmp_path: Path) -> None:
    fly(small(), tmp_path)
    assert missing(small(name="other words", plot=["overshoot"]), tmp_path) == []


def test_a_description_that_cannot_be_read_is_refused(small: Any, tmp_path: Path) -> None:
    (tmp_path / DESCRIPTION_FILE).write_text("{")
    with pytest.raises(ConfigError, match="cannot be read"):
        CampaignFolder(tmp_path, small())


def test_fresh_removes_nothing_where_no_campaign_is(small: Any, tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("years of work")
    with pytest.raises(ConfigError, match="nothing was removed"):
        CampaignFolder(tmp_path, small(), fresh=True)
    assert [file.name for file in tmp_path.iterdir()] == ["thesis.tex"]


def test_two_processes_do_not_share_a_folder(small: Any, tmp_path: Path) -> None:
    with CampaignFolder(tmp_path, small()), pytest.raises(ConfigError, match="another process"):
        CampaignFolder(tmp_path, small())
    CampaignFolder(tmp_path, small()).close()


def test_a_folder_that_cannot_be_is_named(small: Any, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RecordingError, match="file/a cannot be written"):
        CampaignFolder(tmp_path / "file" / "a", small())


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
def test_a_full_disk_is_told_and_what_has_landed_stays(small: Any, tmp_path: Path) -> None:
    plan = small()
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / f"{part(tmp_path, 2).name}.writing").symlink_to("/dev/full")
    with (
        CampaignFolder(tmp_path, plan) as folder,
        pytest.raises(RecordingError, match=r"No space left.*run the same again"),
    ):
        fly_chunks(plan, folder.missing(), folder, LocalFleet(1))
    assert missing(plan, tmp_path) == [2, 3, 4, 5]
