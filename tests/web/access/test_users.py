from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from housefly.errors import ConfigError
from housefly.web.access.passwords import matches
from housefly.web.access.roles import Role
from housefly.web.access.users import UserBook

PASSWORD = "correct horse battery"


@pytest.fixture
def file(tmp_path: Path, cheap_passwords: None) -> Path:
    return tmp_path / "state" / "users.json"


def test_a_user_is_kept_hashed_in_a_file_of_this_user_alone(file: Path) -> None:
    UserBook(file).put("anna", Role.FLY, PASSWORD)
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(file.parent.stat().st_mode) == 0o700
    assert PASSWORD not in file.read_text()
    found = UserBook(file).find("anna")
    assert found is not None and found.role is Role.FLY
    assert matches(PASSWORD, found.password_hash)
    assert UserBook(file).find("ben") is None


def test_a_change_by_another_process_counts_at_the_next_look(file: Path) -> None:
    mine, theirs = UserBook(file), UserBook(file)
    assert mine.find("anna") is None
    theirs.put("anna", Role.WATCH, PASSWORD)
    before = mine.find("anna")
    theirs.put("anna", Role.ADMIN, PASSWORD)
    after = mine.find("anna")
    assert before is not None and after is not None
    assert (before.role, after.role) == (Role.WATCH, Role.ADMIN)
    assert before.fingerprint != after.fingerprint
    theirs.remove("anna")
    assert mine.find("anna") is None


@pytest.mark.parametrize("name", ["", "Anna", "1st", "a" * 25, "a.b", "a:b", "~a", "a\n", "../a"])
def test_a_name_that_is_none_is_refused_in_words(file: Path, name: str) -> None:
    with pytest.raises(ConfigError, match="NAME"):
        UserBook(file).put(name, Role.WATCH, PASSWORD)
    assert not file.exists()


def test_nobody_unknown_is_removed(file: Path) -> None:
    book = UserBook(file)
    book.put("anna", Role.WATCH, PASSWORD)
    with pytest.raises(ConfigError, match="known: anna"):
        book.remove("ben")


def test_a_file_that_others_may_read_lets_nobody_in(file: Path) -> None:
    book = UserBook(file)
    book.put("anna", Role.ADMIN, PASSWORD)
    assert book.find("anna") is not None
    file.chmod(0o644)
    assert book.find("anna") is None
    with pytest.raises(ConfigError, match="chmod 600"):
        book.all()


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can give a file away")
def test_a_file_of_another_user_lets_nobody_in(file: Path) -> None:
    book = UserBook(file)
    book.put("anna", Role.ADMIN, PASSWORD)
    os.chown(file, 65534, 65534)
    assert book.find("anna") is None


def test_a_link_in_its_place_lets_nobody_in(file: Path, tmp_path: Path) -> None:
    UserBook(tmp_path / "theirs").put("anna", Role.ADMIN, PASSWORD)
    file.parent.mkdir()
    file.symlink_to(tmp_path / "theirs")
    assert UserBook(file).find("anna") is None


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{}",
        "[]",
        '{"users": 1}',
        '{"users": [{}]}',
        '{"users": [{"name": "anna", "role": "god", "password": "x"}]}',
        '{"users": [{"name": "anna", "role": "admin", "password": "x"}]}',
        "[" * 5000,
    ],
)
def test_a_damaged_file_lets_nobody_in_and_says_so(file: Path, text: str) -> None:
    file.parent.mkdir()
    file.write_text(text)
    file.chmod(0o600)
    book = UserBook(file)
    assert book.find("anna") is None
    with pytest.raises(ConfigError, match="damaged"):
        book.all()
