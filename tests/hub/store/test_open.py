"""A store is opened by its address, or refused in words."""

from __future__ import annotations

import sqlite3
import sys
from contextlib import closing
from pathlib import Path

import pytest

from housefly.errors import MissingPartError, StoreError
from housefly.hub.store.open import open_store


def test_a_path_opens_a_file_and_an_older_one_again(tmp_path: Path) -> None:
    for _ in range(2):
        store = open_store(tmp_path / "house.db")
        assert store.notices == ()
        store.close()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"my diary\n" * 500, "is no database of Housefly, or its beginning is damaged"),
        (b"\0" * 4096, "is no database of Housefly, or its beginning is damaged"),
        (None, r"is another program's database \(it holds photos\)"),
    ],
)
def test_a_file_that_is_not_ours_is_refused_and_left_as_it_is(
    tmp_path: Path, content: bytes | None, words: str
) -> None:
    path = tmp_path / "other.db"
    if content is None:
        with closing(sqlite3.connect(path)) as other:
            other.execute("CREATE TABLE photos (id INTEGER)")
            other.commit()
        content = path.read_bytes()
    else:
        path.write_bytes(content)
    with pytest.raises(StoreError, match=f"{words}; it stays as it is: move it away"):
        open_store(path)
    assert path.read_bytes() == content
    assert [file.name for file in tmp_path.iterdir()] == ["other.db"]


def test_a_server_that_does_not_answer_is_said_in_words(tmp_path: Path) -> None:
    pytest.importorskip("psycopg")
    with pytest.raises(
        StoreError, match="the database server does not answer; connection"
    ) as refused:
        open_store(f"postgresql://nobody@/house?host={tmp_path}")
    assert refused.value.reason == "the database server does not answer"


@pytest.mark.wire
def test_a_database_that_is_not_there_is_said_in_words(server: object) -> None:
    with pytest.raises(
        StoreError, match=r'the database server refuses; .*database "nothing" does not exist'
    ):
        open_store(server.url("nothing"))  # type: ignore[attr-defined]


def test_without_its_driver_postgresql_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(sys.modules, "housefly.hub.store.postgres", raising=False)
    monkeypatch.setitem(sys.modules, "psycopg", None)
    with pytest.raises(MissingPartError, match=r"pip install 'housefly\[postgres\]'"):
        open_store("postgresql://nobody@localhost/house")


def test_a_file_that_may_only_be_read_is_said_in_words(tmp_path: Path) -> None:
    address = tmp_path / "house.db"
    open_store(address).close()
    store = open_store(address)
    store._database.query("PRAGMA query_only = ON")
    with pytest.raises(StoreError, match="the database may only be read"):
        store.put_things([])
        store._database.query("DELETE FROM thing")
    store.close()
