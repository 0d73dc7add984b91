"""The console's port, held by one process and served by others."""

from __future__ import annotations

import os
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from housefly.app.new_runtime import new_runtime
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.web.console_port import ConsolePort, inherited_listener, listening

pytestmark = pytest.mark.wire


@pytest.fixture
def port(loopback: str) -> Iterator[ConsolePort]:
    held = ConsolePort(loopback, 0)
    yield held
    held.close()


def test_who_inherits_the_socket_accepts_who_came_before(port: ConsolePort, loopback: str) -> None:
    with socket.create_connection((loopback, port.number)) as early:
        with inherited_listener(os.dup(port.descriptor)) as one:
            assert one.getsockname() == (loopback, port.number)
            assert one.proto == socket.IPPROTO_TCP, "else asyncio leaves Nagle on"
            assert not one.get_inheritable()
            connection, address = socket.socket.accept(one)
            connection.close()
        assert address == early.getsockname()


def test_the_port_stays_taken_when_who_inherited_it_is_gone(
    port: ConsolePort, loopback: str
) -> None:
    inherited_listener(os.dup(port.descriptor)).close()
    with pytest.raises(ConfigError, match=r"web\.port.*choose another port"):
        listening(loopback, port.number)
    port.close()
    listening(loopback, port.number).close()


def test_no_child_gets_the_socket_by_itself(port: ConsolePort) -> None:
    assert not os.get_inheritable(port.descriptor)


def test_a_run_with_a_console_holds_its_port_and_one_without_does_not(
    loopback: str, tmp_path: Path
) -> None:
    site = changed(Site(), web__host=loopback, web__port=0)
    runtime = new_runtime(site, tmp_path, web=True)
    taken = runtime.site().web.port
    assert taken
    with pytest.raises(ConfigError, match=f"{loopback} port {taken}"):
        listening(loopback, taken)
    del runtime
    listening(loopback, taken).close()
    free = new_runtime(site, tmp_path).site().web.port
    listening(loopback, free).close()


def test_what_does_not_listen_is_no_console_port(tmp_path: Path) -> None:
    with socket.socket() as deaf, (tmp_path / "file").open("w") as file:
        for descriptor in (deaf.fileno(), file.fileno(), 9999, -1, 10**12):
            with pytest.raises(ConfigError, match=f"descriptor {descriptor} is no socket"):
                inherited_listener(descriptor)
        deaf.getsockname()
