"""The folder of a reproduction: what is complete and of the same inputs counts, nothing else."""

from __future__ import annotations

from pathlib import Path

from housefly.app.reproduction_store import ReproductionStore


def kept(folder: Path, inputs: str = "inputs") -> ReproductionStore:
    store = ReproductionStore(folder, inputs)
    store.begin("paper").mkdir(parents=True, exist_ok=True)
    store.keep("paper", 6)
    return store


def test_a_flight_counts_from_when_it_is_complete(tmp_path: Path) -> None:
    store = ReproductionStore(tmp_path, "inputs")
    store.begin("paper").mkdir(parents=True)
    assert not store.is_kept("paper", 6)
    store.keep("paper", 6)
    assert store.is_kept("paper", 6) and ReproductionStore(tmp_path, "inputs").is_kept("paper", 6)
    store.begin("paper")
    assert not store.is_kept("paper", 6)


def test_other_inputs_or_settings_do_not_count(tmp_path: Path) -> None:
    kept(tmp_path)
    assert not ReproductionStore(tmp_path, "another seed").is_kept("paper", 6)
    assert not ReproductionStore(tmp_path, "inputs").is_kept("paper", 4)


def test_a_damaged_mark_does_not_count(tmp_path: Path) -> None:
    store = kept(tmp_path)
    (store.flight_folder("paper") / "made_from.json").write_text("{")
    assert not store.is_kept("paper", 6)


def test_fresh_throws_away_flights_and_batches_and_nothing_else(tmp_path: Path) -> None:
    kept(tmp_path)
    (tmp_path / "batch").mkdir()
    (tmp_path / "reproduction.html").write_text("the last page")
    store = ReproductionStore(tmp_path, "inputs", fresh=True)
    assert not store.is_kept("paper", 6)
    assert [path.name for path in tmp_path.iterdir()] == ["reproduction.html"]
