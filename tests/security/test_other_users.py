"""Another user of the machine reaches neither bus nor memory of a run, and takes no port of it."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import stat
import subprocess
import tempfile
import time
from contextlib import closing
from functools import partial
from pathlib import Path

import pytest

from housefly.app.certificates import make_certificate
from housefly.app.console_answer import console_answers
from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import discovery_entry, new_runtime
from housefly.app.run_folder import new_run_folder, temporary_run_folder
from housefly.app.runtime import Runtime
from housefly.bus.endpoint import endpoint_in
from housefly.bus.stop import StopListener
from housefly.bus.stop_sender import StopSender
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site, changed
from housefly.errors import LinkError
from housefly.hub.client.discovery import announced, folder
from housefly.hub.query_server import QueryServer

pytestmark = pytest.mark.wire
NOBODY = 65534
CONNECT = (
    "import socket, sys\n"
    "link = socket.socket(socket.AF_UNIX)\n"
    "try:\n"
    "    link.connect(sys.argv[1])\n"
    "except OSError as error:\n"
    "    sys.exit(type(error).__name__)\n"
)
as_root = pytest.mark.skipif(os.geteuid() != 0, reason="only root can become another user")


@pytest.fixture
def runtime(tmp_path: Path) -> Runtime:
    return new_runtime(Site(), tmp_path)


def bus_file(runtime: Runtime) -> Path:
    return Path(runtime.bus.removeprefix("unixsock-stream/"))


def connected_as_nobody(path: Path) -> str:
    """Return "" when another user could connect, else the name of the error."""
    return as_nobody(CONNECT, str(path))


def as_nobody(program: str, *arguments: str) -> str:
    """Run a program as another user; return what it says is wrong."""
    done = subprocess.run(
        ["/usr/bin/env", "python3", "-S", "-c", program, *arguments],
        user=NOBODY,
        group=NOBODY,
        extra_groups=(),
        cwd="/",
        capture_output=True,
        text=True,
    )
    return done.stderr.strip()


@as_root
def test_another_user_cannot_connect_to_the_bus_nor_to_the_memory(runtime: Runtime) -> None:
    with (
        ZenohBus(listen=runtime.bus),
        closing(QueryServer(lambda text: text, "key", runtime.room_socket)),
    ):
        assert connected_as_nobody(bus_file(runtime)) == "PermissionError"
        assert connected_as_nobody(runtime.room_socket) == "PermissionError"


@as_root
def test_the_attack_itself_works_where_the_folder_is_open(runtime: Runtime) -> None:
    place = runtime.room_socket.parent
    with socket.socket(socket.AF_UNIX) as open_door:
        open_door.bind(str(place / "open"))
        open_door.listen()
        place.chmod(0o755)
        (place / "open").chmod(0o777)
        assert connected_as_nobody(place / "open") == ""


TAKE = (
    "import socket, sys\n"
    "kind, host, port, *options = sys.argv[1:]\n"
    "family = socket.AF_INET6 if ':' in host else socket.AF_INET\n"
    "link = socket.socket(family, getattr(socket, kind))\n"
    "for option in options:\n"
    "    link.setsockopt(socket.SOL_SOCKET, getattr(socket, option), 1)\n"
    "try:\n"
    "    link.bind((host, int(port)))\n"
    "except OSError as error:\n"
    "    sys.exit(error.strerror)\n"
)
WAYS = [(), ("SO_REUSEADDR",), ("SO_REUSEPORT",), ("SO_REUSEADDR", "SO_REUSEPORT")]


def taken_as_nobody(port: int, *options: str) -> str:
    """Return "" when another user could take a UDP port of loopback, else why not."""
    return as_nobody(TAKE, "SOCK_DGRAM", "127.0.0.1", str(port), *options)


def console_taken_as_nobody(host: str, port: int, *options: str) -> str:
    """Return "" when another user could take the console's port, else why not."""
    return as_nobody(TAKE, "SOCK_STREAM", host, str(port), *options)


@as_root
@pytest.mark.parametrize("options", WAYS, ids=lambda options: "+".join(options) or "plainly")
async def test_another_user_cannot_take_the_port_of_stop_while_the_pilot_is_down(
    runtime: Runtime, options: tuple[str, ...]
) -> None:
    """He would keep every new pilot from starting."""
    told: list[str] = []
    with closing(StopSender("127.0.0.1", runtime.stop_ports["drone"], runtime.secret)) as sender:
        for pilot in ("first", "second"):
            assert (
                taken_as_nobody(runtime.stop_ports["drone"], *options) == "Address already in use"
            )
            listener = StopListener(
                *(
                    "127.0.0.1",
                    runtime.stop_ports["drone"],
                    runtime.secret,
                    partial(told.append, pilot),
                ),
                is_held=True,
            )
            await listener.start()
            assert (
                taken_as_nobody(runtime.stop_ports["drone"], *options) == "Address already in use"
            )
            for _ in range(20):
                assert await asyncio.wrap_future(sender.send())
            listener.close()
            await asyncio.sleep(0.0)
    assert told == ["first"] * 20 + ["second"] * 20


@as_root
def test_a_port_that_nobody_holds_can_be_taken_by_another_user(runtime: Runtime) -> None:
    for kind, taken in (
        (socket.SOCK_DGRAM, taken_as_nobody),
        (socket.SOCK_STREAM, partial(console_taken_as_nobody, "127.0.0.1")),
    ):
        with socket.socket(socket.AF_INET, kind) as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        assert taken(port) == ""


def until_it_answers(site: Site) -> None:
    deadline = time.monotonic() + 60.0
    while not console_answers(site):
        assert time.monotonic() < deadline
        time.sleep(0.05)


@as_root
@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.parametrize("host", ["127.0.0.1", "::1", "0.0.0.0"])
def test_another_user_cannot_take_the_consoles_port_while_the_console_is_down(
    host: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Open pages would show him cookie and proof, and STOP would go nowhere."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    site = changed(Site(), web__host=host, web__port=0)
    if host == "0.0.0.0":
        files, _ = make_certificate(tmp_path / "tls", ("lab.local",))
        tls = {"certificate": str(files.certificate), "key": str(files.key)}
        site = changed(site, **{f"web__tls_{key}": value for key, value in tls.items()})
    runtime = new_runtime(site, tmp_path, web=True)
    site, places = runtime.site(), {host, "127.0.0.1" if host == "0.0.0.0" else host}
    console = tuple(spec for spec in processes_of(runtime) if spec.name == "web")
    with ZenohBus(listen=runtime.bus), Launcher(runtime, tmp_path, console) as launcher:
        until_it_answers(site)
        os.kill(launcher.pid("web"), signal.SIGKILL)
        said = [console_taken_as_nobody(at, site.web.port, *how) for at in places for how in WAYS]
        assert set(said) == {"Address already in use"}
        assert not console_answers(site), "too late: the next one is already there"
        until_it_answers(site)
        assert launcher.restarts("web") == 1


def test_the_sockets_of_a_run_lie_in_a_folder_of_its_user(runtime: Runtime) -> None:
    found = bus_file(runtime).parent.stat()
    assert stat.S_IMODE(found.st_mode) == 0o700
    assert found.st_uid == os.geteuid()
    assert runtime.room_socket.parent == bus_file(runtime).parent


@pytest.mark.parametrize("mode", [0o755, 0o770, 0o711, 0o701])
def test_a_bus_in_a_folder_that_others_may_enter_is_refused(tmp_path: Path, mode: int) -> None:
    tmp_path.chmod(mode)
    for way in ({"listen": endpoint_in(tmp_path)}, {"connect": endpoint_in(tmp_path)}):
        with pytest.raises(LinkError, match="mode 0700"):
            ZenohBus(**way)


@as_root
def test_a_bus_that_another_user_holds_is_not_joined(tmp_path: Path) -> None:
    tmp_path.chmod(0o700)
    os.chown(tmp_path, NOBODY, NOBODY)
    with pytest.raises(LinkError, match="must belong to this user"):
        ZenohBus(connect=endpoint_in(tmp_path))


@pytest.mark.parametrize("endpoint", ["tcp/127.0.0.1:7447", "udp/127.0.0.1:7447", "", "tls/x:1"])
def test_a_bus_that_asks_nobody_who_they_are_is_refused(endpoint: str) -> None:
    for way in ({"listen": endpoint}, {"connect": endpoint}):
        with pytest.raises(LinkError, match="Unix socket"):
            ZenohBus(**way)


def test_the_entry_by_which_programs_find_a_run_is_for_its_user_only(
    runtime: Runtime, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    left = folder() / f"{os.getpid()}.json"
    left.touch()
    left.chmod(0o666)
    with announced(discovery_entry(runtime)):
        assert stat.S_IMODE(left.stat().st_mode) == 0o600
        assert stat.S_IMODE(left.parent.stat().st_mode) == 0o700


def test_what_a_killed_run_left_behind_is_removed_by_the_next() -> None:
    gone = subprocess.Popen(["true"])
    gone.wait()
    left = Path(tempfile.mkdtemp(prefix=f"housefly-run-{gone.pid}-"))
    logs, fresh = (Path(tempfile.mkdtemp(prefix=f"housefly-logs-{gone.pid}-")) for _ in range(2))
    (fresh / "pilot.log").touch()  # a child of the killed launcher lands the drone still
    ago = time.time() - 3600.0
    os.utime(logs, (ago, ago))
    with temporary_run_folder("logs") as own:
        assert own.is_dir() and stat.S_IMODE(own.stat().st_mode) == 0o700
        assert not left.exists() and not logs.exists() and fresh.exists()
    assert not own.exists()
    (fresh / "pilot.log").unlink()
    os.utime(fresh, (ago, ago))
    mine = new_run_folder()
    assert mine.exists() and not fresh.exists()
