"""One run to one memory."""

from __future__ import annotations

from pathlib import Path

import pytest
from store_holder import held_elsewhere

from housefly.config.site import Site, changed
from housefly.errors import SharedStoreError, StoreError
from housefly.hub.store.lock import locked_store, refuse_shared_store, reserved_store


def test_a_memory_that_another_process_holds_is_refused_until_it_is_gone(tmp_path: Path) -> None:
    store = str(tmp_path / "room.db")
    site = changed(Site(), hub__store=store)
    with held_elsewhere(store) as other:
        with pytest.raises(StoreError, match=f"process {other}.*room.db.*hub.store"):
            refuse_shared_store(site)
        with pytest.raises(StoreError), locked_store(site):
            pass
    refuse_shared_store(site)
    with locked_store(site):
        pass


def test_of_two_runs_that_begin_at_once_only_one_gets_the_memory(tmp_path: Path) -> None:
    site = changed(Site(), hub__store=str(tmp_path / "room.db"))
    with reserved_store(site):  # its hub has not opened it yet
        with pytest.raises(SharedStoreError, match="another run"), reserved_store(site):
            pass
        with locked_store(site):  # the hub of the first
            pass
    with reserved_store(site):
        pass


def test_who_has_no_file_needs_no_lock(tmp_path: Path) -> None:
    server = "postgresql://room@192.0.2.1/db"
    for changes in ({"hub__enabled": False}, {"hub__enabled": False, "hub__store": server}):
        site = changed(Site(), **changes)
        with locked_store(site):
            refuse_shared_store(site)


def test_a_folder_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with (
        pytest.raises(StoreError, match="cannot be written"),
        locked_store(changed(Site(), hub__store=str(tmp_path / "file" / "room.db"))),
    ):
        pass


def test_a_memory_that_cannot_be_written_keeps_no_run_from_its_start(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with reserved_store(changed(Site(), hub__store=str(tmp_path / "file" / "room.db"))):
        pass
