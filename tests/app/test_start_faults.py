"""A start that cannot succeed ends or gives up, with the cause in words, and never loops."""

from __future__ import annotations

import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from housefly.app.restart_policy import START_ATTEMPTS
from housefly.app.run_folder import new_run_folder
from housefly.bus.endpoint import endpoint_in
from housefly.cli import main
from housefly.hub import process
from housefly.hub.store.open import open_store

_NOT_HERE = "192.0.2.1"
"""An address of documentation (RFC 5737): no machine has it."""


def newer(database: Path) -> None:
    store = open_store(database)
    store._database.query("INSERT INTO schema (version) VALUES (99)")
    store.close()


def read_only_disk(folder: Path, command: list[str], **options: Any) -> subprocess.Popen[str]:
    """Run a command for which a folder is on a disk that may only be read."""
    mount = f"mount --bind {folder} {folder} && mount -o remount,bind,ro {folder}"
    return in_own_mounts(mount, command, **options)


def in_own_mounts(mount: str, command: list[str], **options: Any) -> subprocess.Popen[str]:
    """Run a command that sees mounts which nobody else sees, or skip."""
    if shutil.which("unshare") is None:
        pytest.skip("unshare is not installed (Debian package util-linux)")
    own = ["unshare", "--map-root-user", "--mount", "sh", "-c"]
    tried = subprocess.run([*own, mount], capture_output=True, text=True)
    if tried.returncode != 0:
        pytest.skip(f"this system lets no user mount anything: {tried.stderr.strip()}")
    ends = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    line = [*own, f'{mount} && exec "$@"', "sh", *command]
    return subprocess.Popen(line, **{**ends, **options})


def hub_line(site: Path) -> list[str]:
    return ["--site", str(site), "--bus", endpoint_in(new_run_folder())]


def site_with(folder: Path, database: Path) -> Path:
    site = folder / "site.toml"
    site.write_text(f'[hub]\nstore = "{database}"\n')
    return site


@pytest.mark.wire
def test_a_memory_of_a_newer_version_ends_the_hub_with_the_cause(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    newer(tmp_path / "room.db")
    assert process.main(hub_line(site_with(tmp_path, tmp_path / "room.db"))) == 1
    told = capsys.readouterr().err
    assert told.startswith("hub: the database is of version 99") and "install the newer" in told


@pytest.mark.wire
@pytest.mark.timeout(60)
def test_a_memory_that_another_program_holds_ends_the_hub_with_the_cause(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    database = tmp_path / "room.db"
    open_store(database).close()
    with closing(sqlite3.connect(database, isolation_level=None)) as other:
        other.execute("PRAGMA locking_mode = EXCLUSIVE")
        other.execute("CREATE TABLE held (x)")
        assert process.main(hub_line(site_with(tmp_path, database))) == 1
    told = capsys.readouterr().err
    assert told.startswith(f"hub: another process holds the database; database {database}")


@pytest.mark.wire
def test_a_memory_on_a_disk_that_may_only_be_read_ends_the_hub_with_the_cause(
    tmp_path: Path,
) -> None:
    kept = tmp_path / "kept"
    kept.mkdir()
    open_store(kept / "room.db").close()
    line = [sys.executable, "-m", "housefly.hub.process"]
    line += hub_line(site_with(tmp_path, kept / "room.db"))
    with read_only_disk(kept, line) as hub:
        told = hub.communicate(timeout=60.0)[0]
    assert hub.returncode == 1, told
    assert f"hub: {kept}/room.db.lock cannot be written: Read-only file system" in told
    assert "another hub.store" in told and "Traceback" not in told


def test_an_address_that_this_machine_does_not_have_is_refused_with_the_key(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], loopback: str
) -> None:
    site = tmp_path / "site.toml"
    text = f'[drone]\naddress = "{loopback}"\n[tracking]\naddress = "{_NOT_HERE}"\n'
    site.write_text(f"{text}[web]\nport = 0\n[hub]\nenabled = false\n")
    assert main(["run", "--site", str(site)]) == 2
    told = " ".join(capsys.readouterr().err.split())
    assert f"simulated tracking system: nothing can listen at {_NOT_HERE}" in told
    assert "Cannot assign requested address" in told and "tracking.address" in told


def test_a_console_whose_port_is_taken_is_refused_with_the_key(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], loopback: str
) -> None:
    site = tmp_path / "site.toml"
    text = f'[drone]\naddress = "{loopback}"\n[tracking]\naddress = "{loopback}"\n'
    with socket.create_server((loopback, 0)) as other:
        port = other.getsockname()[1]
        site.write_text(f'{text}[web]\nhost = "{loopback}"\nport = {port}\n')
        assert main(["run", "--site", str(site)]) == 2
    told = capsys.readouterr().err
    assert f"console: TCP {port} at {loopback} is taken" in told and "web.port" in told


@pytest.mark.wire
@pytest.mark.slow
def test_a_run_without_room_for_its_own_files_ends_with_the_cause(
    tmp_path: Path, write_site: Callable[..., Path]
) -> None:
    small = tmp_path / "small"
    small.mkdir()
    # Two files fit: of a folder that takes none, Python makes no use at all.
    fill = f"mount -t tmpfs -o size=64k,nr_inodes=3 none {small}"
    command = ["env", f"TMPDIR={small}", sys.executable, "-m", "housefly.cli"]
    with in_own_mounts(fill, [*command, "run", "--site", str(write_site())]) as run:
        try:
            told = run.communicate(timeout=60.0)[0]
        finally:
            run.send_signal(signal.SIGINT)
    assert run.returncode == 2, told
    assert "No space left on device; free some space, or set TMPDIR" in told
    assert "Traceback" not in told


@pytest.mark.wire
@pytest.mark.realtime
@pytest.mark.interop
@pytest.mark.slow
@pytest.mark.timeout(180)
def test_a_run_whose_memory_cannot_start_gives_it_up_with_the_cause_on_the_screen(
    tmp_path: Path, write_site: Callable[..., Path]
) -> None:
    site = write_site()
    newer(tmp_path / "room1.db")
    log = tmp_path / "run.log"
    command = [sys.executable, "-m", "housefly.cli", "run", "--site", str(site)]
    with log.open("wb") as out:
        run = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT)
    try:
        told = wait_for_words(log, "hub cannot start and is not tried again", run)
        assert "is of version 99" in told and "install the newer Housefly" in told
        time.sleep(6.0)  # longer than the longest pause before a new start
        told = words_of_log(log)
        assert told.count("hub died and was started again") == START_ATTEMPTS - 1
        assert told.count("hub cannot start") == 1
    finally:
        run.send_signal(signal.SIGINT)
        assert run.wait(60.0) == 0


def words_of_log(log: Path) -> str:
    return " ".join(log.read_text(errors="replace").split())


def wait_for_words(log: Path, words: str, run: subprocess.Popen[bytes]) -> str:
    deadline = time.monotonic() + 90.0
    while words not in (told := words_of_log(log)):
        assert run.poll() is None and time.monotonic() < deadline, told
        time.sleep(0.1)
    return told
