"""What is installed is what was tested: every package by version and hash, of every platform."""

from __future__ import annotations

import hashlib
import importlib.machinery
import importlib.util
import json
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
LOCKS = sorted((ROOT / "requirements").glob("*.txt"))
ENTRY = re.compile(
    r"^([\w.-]+)==(\S+)(?: ; [^\\]+)?((?: \\\n    --hash=sha256:[0-9a-f]{64})+)$", re.M
)


def same(name: str) -> str:
    """Return the name of a package in the one spelling of the registry."""
    return re.sub(r"[-_.]+", "-", name).lower()


def locked(lock: Path) -> dict[str, str]:
    return {same(name): version for name, version, _ in ENTRY.findall(lock.read_text())}


def constrained() -> dict[str, str]:
    lines = (ROOT / "constraints.txt").read_text().split()
    return {same(name): version for name, _, version in (line.partition("==") for line in lines)}


def required(*extras: str) -> set[str]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    lines = list(project["dependencies"])
    for extra in extras:
        lines += project["optional-dependencies"][extra]
    return {same(re.split(r"[\[<>=]", line)[0]) for line in lines} - {"housefly"}


def test_there_are_locks_for_flying_testing_building_auditing_fuzzing_and_strangers() -> None:
    names = ["build.txt", "cflib.txt", "dev.txt", "djitellopy.txt"]
    names += ["fuzz.txt", "homeassistant.txt", "installer.txt"]
    names += ["roslibpy.txt", "run.txt", "tools.txt", "yamspy.txt"]
    assert [lock.name for lock in LOCKS] == names


@pytest.mark.parametrize("lock", LOCKS, ids=lambda lock: lock.name)
def test_every_line_of_a_lock_is_a_version_with_hashes(lock: Path) -> None:
    assert ENTRY.sub("", lock.read_text()).strip() == ""
    assert len(locked(lock)) >= 1


def test_the_locks_hold_what_the_project_needs_at_the_versions_of_the_constraints() -> None:
    pins, run, dev = (
        constrained(),
        *(locked(ROOT / "requirements" / f"{n}.txt") for n in ("run", "dev")),
    )
    assert required("twin", "lab", "lan") <= set(run)
    assert required("dev", "twin", "lab", "lan", "cluster", "postgres", "mocap") <= set(dev)
    assert run.items() <= dev.items()
    only_elsewhere = {"colorama"}
    """On Windows alone."""
    assert {name: dev[name] for name in set(dev) - only_elsewhere} == {
        name: pins.get(name) for name in set(dev) - only_elsewhere
    }


def set_up() -> Any:
    path = str(ROOT / "scripts" / "set-up")
    loader = importlib.machinery.SourceFileLoader("set_up", path)
    spec = importlib.util.spec_from_loader("set_up", loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    loader.exec_module(module)
    return module


def test_nothing_is_installed_without_its_hash() -> None:
    installs = [
        command
        for steps in set_up().STEPS.values()
        for _, *commands in steps
        for command in commands
        if "pip" in command and "install" in command
    ]
    assert len(installs) == 10
    for command in installs:
        by_hash = "--require-hashes" in command
        assert by_hash or {"--no-deps", "--no-build-isolation"} <= set(command), command
    recipe = (ROOT / "Makefile").read_text()
    assert all("--require-hashes" in line for line in recipe.splitlines() if "pip install" in line)


def a_wheel(folder: Path, content: str) -> Path:
    """Write a wheel of a package called ``sample``."""
    wheel, info = folder / "sample-1.0-py3-none-any.whl", "sample-1.0.dist-info"
    with zipfile.ZipFile(wheel, "w") as archive:
        archive.writestr("sample.py", content)
        archive.writestr(f"{info}/METADATA", "Metadata-Version: 2.1\nName: sample\nVersion: 1.0\n")
        archive.writestr(
            f"{info}/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
        )
        archive.writestr(f"{info}/RECORD", "")
    return wheel


@pytest.mark.parametrize("is_pip", [True, False], ids=["pip", "uv"])
def test_a_package_that_somebody_changed_is_not_installed(tmp_path: Path, is_pip: bool) -> None:
    wheel = a_wheel(tmp_path, "good = True")
    digest = hashlib.sha256(wheel.read_bytes()).hexdigest()
    lock = tmp_path / "lock.txt"
    lock.write_text(f"sample==1.0 \\\n    --hash=sha256:{digest}\n")
    own = {"-r", "requirements/build.txt"}
    how = set_up()
    if not is_pip and not Path(how.UV[0]).exists():
        pytest.skip("uv could not be had here: pip installs everything")
    installer = [sys.executable, *how.PIP[1:]] if is_pip else [str(how.UV[0]), *how.UV[1:3]]
    command = [*installer, *(one for one in how.LOCKED if one not in own)]
    command += ["-r", str(lock)]
    command += ["--no-index", "--find-links", str(tmp_path), "--target"]
    environment = {
        "PATH": "/usr/bin:/bin",
        "PIP_CONFIG_FILE": "/dev/null",
        "HOME": str(tmp_path),
        "UV_NO_CACHE": "1",
    }

    def installed(into: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [*command, str(tmp_path / into)],
            capture_output=True,
            text=True,
            env=environment,
            check=False,
            timeout=100,
        )

    done = installed("first")
    assert done.returncode == 0, done.stderr
    a_wheel(tmp_path, "good = False")
    done = installed("second")
    told = "DO NOT MATCH THE HASHES" if is_pip else "Hash mismatch"
    assert done.returncode != 0 and told in done.stderr


@pytest.mark.parametrize("folder", ["src/housefly/web/client", "tests/peers"])
def test_every_package_of_npm_has_its_hash(folder: str) -> None:
    packages = json.loads((ROOT / folder / "package-lock.json").read_text())["packages"]
    assert len(packages) > 1
    for name, entry in packages.items():
        assert name == "" or entry["integrity"].startswith("sha512-"), name
