"""From a refused address to a console on the network, by the commands that the refusal names."""

from __future__ import annotations

import io
import re
import stat
from pathlib import Path

import pytest

from housefly.app import launcher
from housefly.cli import main
from housefly.config.state import users_file
from housefly.sites.loaded_site import read_site
from housefly.web.access.exposure import checked_exposure


@pytest.fixture(autouse=True)
def own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "run"))
    monkeypatch.setattr("housefly.web.access.passwords.COST_LOG2", 4)


def typed(monkeypatch: pytest.MonkeyPatch, text: str, *line: str) -> int:
    monkeypatch.setattr("sys.stdin", io.StringIO(text))
    return main(list(line))


@pytest.mark.parametrize(
    "command", [("run",), ("demo",), ("demo", "--empty"), ("fly", "entrance")], ids=" ".join
)
@pytest.mark.parametrize("host", ["0.0.0.0", "192.168.77.77"])
def test_an_open_address_is_refused_in_words_before_anything_starts(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    command: tuple[str, ...],
    host: str,
) -> None:
    def started(*_: object) -> None:
        raise AssertionError("something was started")

    monkeypatch.setattr(launcher.Launcher, "__enter__", started)
    monkeypatch.setattr("housefly.app.compiling.compile_once", started)
    site = tmp_path / "site.toml"
    site.write_text(f'[web]\nhost = "{host}"\n')
    out = [f"--out={tmp_path / 'out'}"] if command[0] == "fly" else []
    assert main([*command, f"--site={site}", *out]) == 2
    told = capsys.readouterr().err
    assert told.startswith(f"housefly: web.host: is '{host}'") and "housefly cert" in told
    assert not (tmp_path / "out").exists() and not list((tmp_path).glob("run/housefly/running/*"))


@pytest.mark.parametrize("command", ["run", "demo"])
def test_the_network_is_refused_without_a_certificate_before_anything_starts(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], command: str
) -> None:
    def started(*_: object) -> None:
        raise AssertionError("something was started")

    monkeypatch.setattr(launcher.Launcher, "__enter__", started)
    monkeypatch.setattr("housefly.app.compiling.compile_once", started)
    assert main([command, "--lan"]) == 2
    told = capsys.readouterr().err
    assert told.startswith("housefly: --lan: needs a certificate")
    assert "`housefly cert --site bsen`" in told
    assert main(["cert"]) == 0
    printed = capsys.readouterr().out
    assert "`housefly run --lan`" in printed and "authority.crt" in printed
    assert re.search(r"SHA-256 fingerprint is\s+(?:[0-9A-F]{2} ){31}[0-9A-F]{2}", printed)
    with pytest.raises(AssertionError, match="something was started"):
        main([command, "--lan"])


def test_what_the_refusal_says_mends_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["cert", "--name=lab.local"]) == 0
    printed = capsys.readouterr().out
    lines = re.findall(r"^(?:\[web\]|host = .*|tls_\w+ = .*)$", printed, flags=re.MULTILINE)
    assert len(lines) == 4
    site = tmp_path / "site.toml"
    site.write_text("\n".join(lines))
    assert typed(monkeypatch, "correct horse\n", "user", "add", "anna", "--role=fly") == 0
    exposure = checked_exposure(read_site(str(site)))
    assert exposure.certificate is not None and "lab.local" in exposure.names
    file = users_file(read_site(str(site)))
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert "correct horse" not in file.read_text()


def test_users_are_listed_changed_and_removed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert typed(monkeypatch, "correct horse\n", "user", "add", "anna", "--role=fly") == 0
    assert typed(monkeypatch, "", "user", "role", "anna", "--role=watch") == 0
    capsys.readouterr()
    assert main(["user", "list"]) == 0
    assert re.search(r"anna\s+watch", capsys.readouterr().out)
    assert main(["user", "remove", "anna"]) == 0
    assert main(["user", "remove", "anna"]) == 2
    assert "who is no user; known: nobody" in capsys.readouterr().err


@pytest.mark.parametrize("password", ["", "\n", "short\n"])
def test_a_password_that_is_too_short_is_refused_in_words(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], password: str
) -> None:
    assert typed(monkeypatch, password, "user", "add", "anna", "--role=admin") == 2
    assert "10 to 256" in capsys.readouterr().err


def test_a_password_typed_differently_the_second_time_changes_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    answers = iter(["correct horse", "correct house"])
    monkeypatch.setattr("sys.stdin", Terminal())
    monkeypatch.setattr("housefly.app.commands.user.getpass", lambda prompt: next(answers))
    assert main(["user", "add", "anna", "--role=admin"]) == 2
    assert "differently" in capsys.readouterr().err
    assert main(["user", "list"]) == 0
