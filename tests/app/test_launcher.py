"""How the processes of a run start, are started again, are given up, and end."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from http.client import HTTPConnection
from pathlib import Path
from typing import Any

import psutil
import pytest

from housefly.app.console_answer import console_answers
from housefly.app.launcher import Landing, Launcher, ProcessSpec, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.people_note import UNSEEN_PEOPLE
from housefly.app.runtime import Runtime
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site, changed, site_from_file
from housefly.web.console_port import ConsolePort

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]


def start(site: Path, log: Path, *options: str) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "housefly.cli", "run", "--site", str(site), *options]
    process = subprocess.Popen(command, stdout=log.open("w"), stderr=subprocess.STDOUT)
    deadline = time.monotonic() + 200.0
    while "ready after" not in log.read_text() and time.monotonic() < deadline:
        time.sleep(0.1)
    if "ready after" not in log.read_text():
        process.send_signal(signal.SIGINT)
        process.wait(60)
        raise AssertionError(log.read_text())
    return process


def children_of(process: subprocess.Popen[bytes]) -> list[psutil.Process]:
    return psutil.Process(process.pid).children(recursive=True)


def test_one_memory_has_one_run_a_killed_part_comes_back_and_ctrl_c_ends_all_and_is_scored(
    tmp_path: Path, write_site: Any
) -> None:
    site, log, recording = write_site(), tmp_path / "log", tmp_path / "recording"
    process = start(site, log, "--record", str(recording))
    said = log.read_text()
    assert 0 <= said.find(UNSEEN_PEOPLE) < said.find("ready after")
    assert listeners_of(process.pid, port_said_in(said)) == 1, "held for every next console"
    assert_memory_is_refused_to_a_second_run(site_from_file(site).hub.store, write_site())
    children = children_of(process)
    next(child for child in children if "housefly.twin.process" in child.cmdline()).kill()
    wait_for(lambda: "twin died and was started again" in log.read_text(), timeout=20.0)
    children = children_of(process)
    assert len(children) >= 3
    process.send_signal(signal.SIGINT)
    assert process.wait(40) == 0
    assert psutil.wait_procs(children, timeout=5)[1] == []
    summary = json.loads((recording / "summary.json").read_text())
    assert summary["contacts"] == [], "None: nobody wrote what was true"


def assert_memory_is_refused_to_a_second_run(memory: Path, second: Path) -> None:
    second.write_text(re.sub(r"store = .*", f'store = "{memory}"', second.read_text()))
    command = [sys.executable, "-m", "housefly.cli", "run", "--site", str(second)]
    refused = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert refused.returncode == 2
    assert "another run uses this room's memory" in refused.stderr
    assert "hub.store" in refused.stderr
    assert Path(memory).stat().st_mode & 0o777 == 0o600


@pytest.mark.interop
def test_no_process_outlives_a_launcher_that_was_killed(tmp_path: Path, write_site: Any) -> None:
    process = start(write_site(), tmp_path / "log")
    children = children_of(process)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    assert psutil.wait_procs(children, timeout=30)[1] == []


def wait_for(condition: Callable[[], object], timeout: float = 60.0) -> None:
    deadline = time.monotonic() + timeout
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.05)


@pytest.fixture
def runtime(tmp_path: Path) -> Runtime:
    class OwnModules(Runtime):
        def environment(self) -> dict[str, str]:
            path = os.pathsep.join(filter(None, (str(tmp_path), os.environ.get("PYTHONPATH"))))
            return {**os.environ, "PYTHONPATH": path}

    return object.__new__(OwnModules)


def test_who_cannot_start_is_given_up_and_quoted_and_the_others_go_on(
    tmp_path: Path, runtime: Runtime
) -> None:
    (tmp_path / "broken.py").write_text("import sys; sys.exit('hub: disk is full')")
    (tmp_path / "steady.py").write_text("import time; time.sleep(100)")
    parts = (ProcessSpec("hub", "broken"), ProcessSpec("twin", "steady"))
    with Launcher(runtime, tmp_path, parts) as launcher:
        wait_for(lambda: launcher.given_up)
        restarts = launcher.restarts("hub")
        time.sleep(2.0)
        assert launcher.restarts("hub") == restarts <= 5
        (death,) = launcher.given_up
        assert death.name == "hub" and death.last_words == ("hub: disk is full",)
        assert launcher.restarts("twin") == 0 and psutil.pid_exists(launcher.pid("twin"))


def test_who_is_killed_again_and_again_is_always_started_again(
    tmp_path: Path, runtime: Runtime
) -> None:
    (tmp_path / "steady.py").write_text("import time; time.sleep(100)")
    with Launcher(
        runtime, tmp_path, (ProcessSpec("pilot", "steady", lands=Landing.FIRST),)
    ) as launcher:
        for number in range(1, 7):
            os.kill(launcher.pid("pilot"), signal.SIGKILL)
            wait_for(lambda number=number: launcher.restarts("pilot") == number)
        assert launcher.given_up == ()


def test_who_lands_last_is_never_killed_and_who_hangs_before_is_all_drones_at_once(
    tmp_path: Path, runtime: Runtime, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("housefly.app.launcher._LANDING_TIMEOUT", 1.0)
    (tmp_path / "deaf.py").write_text(
        "import signal, time; signal.signal(signal.SIGTERM, signal.SIG_IGN);"
        " print('ready', flush=True); time.sleep(100)"
    )
    pilots, drivers = ("pilot-red", "pilot-blue"), ("driver-red", "driver-blue")
    parts = (
        *(ProcessSpec(name, "deaf", lands=Landing.FIRST) for name in pilots),
        *(ProcessSpec(name, "deaf", lands=Landing.LAST) for name in drivers),
    )
    launcher = Launcher(runtime, tmp_path, parts)
    with launcher:
        for name in (*pilots, *drivers):
            wait_for(lambda name=name: (tmp_path / f"{name}.log").read_text())
        running = {name: psutil.Process(launcher.pid(name)) for name in (*pilots, *drivers)}
        try:
            assert launcher.stop() == drivers
            assert not any(running[name].is_running() for name in pilots)
            assert all(running[name].is_running() for name in drivers)
        finally:
            for name in drivers:
                running[name].kill()


def test_the_live_view_runs_only_where_the_site_asks_for_it_and_yields_to_all_others(
    tmp_path: Path,
) -> None:
    without = processes_of(new_runtime(Site(), tmp_path))
    assert "foxglove" not in [spec.name for spec in without]
    *others, live = processes_of(new_runtime(changed(Site(), foxglove__enabled=True), tmp_path))
    assert live.name == "foxglove" and live.lands is None
    assert all(live.niceness > spec.niceness for spec in others)


def test_logs_are_for_their_user_alone(tmp_path: Path, runtime: Runtime) -> None:
    (tmp_path / "steady.py").write_text("import time; time.sleep(100)")
    before = os.umask(0o022)
    try:
        with Launcher(runtime, tmp_path, (ProcessSpec("web", "steady"),)):
            assert (tmp_path / "web.log").stat().st_mode & 0o777 == 0o600
    finally:
        os.umask(before)


def test_who_connects_while_the_console_is_down_is_answered_by_the_next_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    runtime = new_runtime(changed(Site(), web__port=0), tmp_path, web=True)
    site = runtime.site()
    parts = tuple(spec for spec in processes_of(runtime) if spec.name == "web")
    with ZenohBus(listen=runtime.bus), Launcher(runtime, tmp_path, parts) as launcher:
        wait_for(lambda: console_answers(site))
        for number in (1, 2):
            os.kill(launcher.pid("web"), signal.SIGKILL)
            psutil.Process(launcher.pid("web")).wait()
            line = HTTPConnection(site.web.host, site.web.port, timeout=60.0)
            line.request("HEAD", "/")
            assert launcher.restarts("web") < number, "too late: the next one is already there"
            assert line.getresponse().status < 500
            line.close()
            wait_for(lambda number=number: launcher.restarts("web") == number)
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection((site.web.host, site.web.port))


def port_said_in(log: str) -> int:
    found = re.search(r"console: +http://[\d.]+:(\d+)/", log)
    assert found, log
    return int(found[1])


def listeners_of(process: int, port: int) -> int:
    found = psutil.Process(process).net_connections(kind="tcp")
    return sum(one.status == psutil.CONN_LISTEN and one.laddr.port == port for one in found)


def test_only_the_console_inherits_its_socket(tmp_path: Path, runtime: Runtime) -> None:
    (tmp_path / "steady.py").write_text("import time; time.sleep(100)")
    port = ConsolePort("127.0.0.1", 0)
    parts = (
        ProcessSpec("pilot", "steady", lands=Landing.FIRST),
        ProcessSpec("web", "steady", port=port),
        ProcessSpec("twin", "steady"),
    )
    with Launcher(runtime, tmp_path, parts) as launcher:
        for part, number in (("pilot", 0), ("web", 1), ("twin", 0)):
            assert listeners_of(launcher.pid(part), port.number) == number
        os.kill(launcher.pid("web"), signal.SIGKILL)
        wait_for(lambda: launcher.restarts("web"))
        assert listeners_of(launcher.pid("web"), port.number) == 1
