"""The address of the console: said when it answers, and how a phone comes in."""

from __future__ import annotations

import re
import socket
import ssl
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest

from housefly.app.certificates import make_certificate
from housefly.app.console_addresses import ConsoleAddresses
from housefly.app.console_answer import console_answers
from housefly.app.new_runtime import new_runtime
from housefly.app.runtime import Runtime
from housefly.clock import RealClock
from housefly.config.site import Site, changed
from housefly.web.access.invitations import Invitations
from housefly.web.access.roles import Role


class Silent(BaseHTTPRequestHandler):
    def do_HEAD(self) -> None:
        self.send_response(403)
        self.end_headers()

    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture
def listener(loopback: str) -> Iterator[socket.socket]:
    with socket.create_server((loopback, 0)) as one:
        yield one


def site_at(listener: socket.socket) -> Site:
    host, port = listener.getsockname()
    return changed(Site(), web__host=host, web__port=port)


def test_a_port_that_is_open_is_no_console_that_answers(listener: socket.socket) -> None:
    assert not console_answers(site_at(listener)), "nobody accepts there"
    closed = site_at(listener)
    listener.close()
    assert not console_answers(closed)


@pytest.mark.parametrize("encrypted", [False, True])
def test_whoever_answers_answers_whatever_he_says(
    loopback: str, tmp_path: Path, encrypted: bool
) -> None:
    server = HTTPServer((loopback, 0), Silent)
    site = site_at(server.socket)
    if encrypted:
        files, _ = make_certificate(tmp_path, ("lab.local",))
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        context.load_cert_chain(files.certificate, files.key)
        server.socket = context.wrap_socket(server.socket, server_side=True)
        web = {"certificate": str(files.certificate), "key": str(files.key)}
        site = changed(site, **{f"web__tls_{key}": value for key, value in web.items()})
    threading.Thread(target=server.serve_forever, daemon=True).start()
    assert console_answers(site)
    server.shutdown()
    server.server_close()


@pytest.fixture
def runtime(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Runtime:
    """A run for the network, that nobody started."""
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    monkeypatch.setattr("housefly.web.access.exposure.lan_addresses", lambda: ("192.168.4.4",))
    files, _ = make_certificate(tmp_path / "tls", ("192.168.4.4",))
    site = changed(
        Site(),
        web__host="0.0.0.0",
        web__tls_certificate=str(files.certificate),
        web__tls_key=str(files.key),
    )
    return new_runtime(site, tmp_path)


def test_a_phone_gets_a_link_of_its_own_that_flies_and_does_not_open_everything(
    runtime: Runtime, capsys: pytest.CaptureFixture[str]
) -> None:
    ConsoleAddresses(runtime).print_address()
    printed = capsys.readouterr().out.replace("\n", "")
    first = re.search(r"console: +https://192\.168\.4\.4:8080/\?token=([\w-]+)", printed)
    phone = re.search(r"phone: +https://192\.168\.4\.4:8080/\?token=([\w-]{44})", printed)
    assert first is not None and first[1] == runtime.token
    assert phone is not None
    found = Invitations(runtime.secret, RealClock()).redeemed(phone[1])
    assert found is not None and found.role is Role.FLY


def test_where_no_phone_gets_in_nothing_is_said_of_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    door = ConsoleAddresses(new_runtime(Site(), tmp_path))
    door.print_address()
    door.print_asked_invitation()
    assert "phone" not in capsys.readouterr().out
