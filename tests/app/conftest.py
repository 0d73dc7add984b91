"""Sites on loopback addresses of their own, so that several can fly at once."""

from __future__ import annotations

import socket
from collections.abc import Callable
from pathlib import Path

import pytest

SITE = """
name = "test"
mode = "{mode}"
[room]
model = "{model}"
[drone]
kind = "{kind}"
address = "{address}"
has_video = {video}
[tracking]
kind = "{tracking}"
address = "{address}"
[hub]
store = "{store}"
[web]
port = {port}
[twin]
seed = {seed}
mocap_rate_hz = {rate}
video = {video}
"""

WriteSite = Callable[..., Path]


def free_port() -> int:
    """Return a TCP port that is free now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@pytest.fixture
def write_site(tmp_path: Path, request: pytest.FixtureRequest) -> WriteSite:
    """Return a function that writes a site file with its own loopback address."""
    from itertools import count
    from os import getpid

    numbers = count(1)

    def write(
        *,
        rate: float = 100.0,
        video: bool = False,
        mode: str = "default",
        model: str = "bsen",
        seed: int = 1,
        tracking: str = "vicon",
        kind: str = "ardrone",
    ) -> Path:
        number = next(numbers)
        last = 200 + (abs(hash(request.node.nodeid)) + number) % 50
        address = f"127.{1 + getpid() % 250}.{getpid() // 250 % 250}.{last}"
        file = tmp_path / f"site{number}.toml"
        flag = "true" if video else "false"
        text = SITE.format(
            mode=mode,
            model=model,
            address=address,
            video=flag,
            rate=rate,
            seed=seed,
            port=free_port(),
            store=tmp_path / f"room{number}.db",
            tracking=tracking,
            kind=kind,
        )
        file.write_text(text)
        return file

    return write
