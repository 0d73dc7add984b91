"""A store of each kind: an SQLite file, and a real PostgreSQL server that the tests start."""

from __future__ import annotations

import itertools
import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from housefly.hub.store.open import open_store
from housefly.hub.store.sql_store import SqlStore

SUPERUSER = "postgres"
_numbers = itertools.count(1)


def postgres_programs() -> Path:
    """Return the folder of the newest server's programs, or skip."""
    folders = sorted(
        Path("/usr/lib/postgresql").glob("*/bin"), key=lambda folder: int(folder.parent.name)
    )
    programs = [folder for folder in folders if (folder / "initdb").is_file()]
    if not programs:
        pytest.skip("the PostgreSQL server is not installed (Debian package postgresql)")
    return programs[-1]


class Server:
    """A PostgreSQL server in a folder of its own, reached by its socket there."""

    def __init__(self, folder: Path) -> None:
        self.programs = postgres_programs()
        self.folder = folder
        self.user = SUPERUSER if os.getuid() == 0 else None  # the server refuses to run as root
        if self.user:
            shutil.chown(folder, self.user)
        self.run(
            "initdb",
            "-D",
            f"{folder}/data",
            "-U",
            SUPERUSER,
            "-A",
            "trust",
            "-E",
            "UTF8",
            "--no-locale",
            "--no-sync",
        )

    def run(self, program: str, *arguments: str) -> None:
        command = [str(self.programs / program), *arguments]
        done = subprocess.run(
            command,
            user=self.user,
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            timeout=60,
        )
        assert done.returncode == 0, done.stderr.decode()

    def start(self) -> None:
        options = f"-c listen_addresses='' -c unix_socket_directories={self.folder} -c fsync=off"
        self.run(
            "pg_ctl",
            "start",
            "-w",
            "-D",
            f"{self.folder}/data",
            "-l",
            f"{self.folder}/log",
            "-o",
            options,
        )

    def stop(self) -> None:
        self.run("pg_ctl", "stop", "-w", "-m", "immediate", "-D", f"{self.folder}/data")

    def url(self, database: str = "postgres") -> str:
        return f"postgresql://{SUPERUSER}@/{database}?host={self.folder}"

    def new_database(self) -> str:
        name = f"house_{next(_numbers)}"
        self.run("createdb", "-h", str(self.folder), "-U", SUPERUSER, name)
        return self.url(name)


@contextmanager
def running_server() -> Iterator[Server]:
    pytest.importorskip(
        "psycopg", reason="psycopg is not installed: pip install 'housefly[postgres]'"
    )
    postgres_programs()
    with tempfile.TemporaryDirectory(
        prefix="housefly-postgres-", dir="/tmp"
    ) as folder:  # a socket's path must be short
        started = Server(Path(folder))
        started.start()
        try:
            yield started
        finally:
            started.stop()


@pytest.fixture(scope="session")
def server() -> Iterator[Server]:
    with running_server() as started:
        yield started


@pytest.fixture
def own_server() -> Iterator[Server]:
    """Return a server that the test may stop and start."""
    with running_server() as started:
        yield started


@pytest.fixture(params=["sqlite", pytest.param("postgres", marks=pytest.mark.wire)])
def address(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """Return the address of an empty store, of each sort in turn."""
    if request.param == "sqlite":
        return str(tmp_path / "house.db")
    started: Server = request.getfixturevalue("server")
    return started.new_database()


@pytest.fixture
def store(address: str) -> Iterator[SqlStore]:
    opened = open_store(address)
    yield opened
    opened.close()
