"""The drone's camera, parent side: keeps a child process rendering and never waits for it.

The child tries egl, then osmesa, then a plain card that says why there is no picture.
``HOUSEFLY_RENDERER`` (egl, osmesa or none) chooses. MUJOCO_GL is set for the child only: where the
library it names is missing, even importing MuJoCo fails.
"""

from __future__ import annotations

import asyncio
import os
import socket
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from threading import Thread

from housefly.clock import RealClock
from housefly.config.site import Site
from housefly.messages import Pose
from housefly.room.model import Room
from housefly.twin.camera.messages import (
    MESSAGE_HEADER,
    Encoded,
    MessageKind,
    PictureRequest,
    RenderBackend,
    RenderSettings,
    pack_message,
)
from housefly.twin.contracts import DroneCamera, EncodedPicture
from housefly.twin.people.script import PersonScript
from housefly.twin.quadrotor.body import camera_of
from housefly.twin.scene_mjcf import scene_mjcf

_RENDERER_VARIABLE = "HOUSEFLY_RENDERER"
_RENDERERS = {
    "egl": (RenderBackend.EGL, RenderBackend.CARD),
    "osmesa": (RenderBackend.OSMESA, RenderBackend.CARD),
    "none": (RenderBackend.CARD,),
}
_START_TIMEOUT = 30.0
_HUNG_AFTER = 3.0
"""A child that owes a picture for this long [s] is replaced."""
_STARVED_AFTER = 1.0
"""The same for a child of idle priority [s]; on a busy machine it may starve."""
_POLL_PERIOD = 0.5
"""How often to check a silent child [s]."""
_EXIT_TIMEOUT = 2.0
"""How long ``close`` waits for the child to exit [s]."""
_FIRST_RESTART_DELAY, _MAX_RESTART_DELAY = 0.1, 5.0
_STABLE_AFTER = 10.0
"""A child that ran this long [s] is restarted at once."""


class CameraProcess:
    """Asks a child process for pictures and passes them to handlers.

    All calls belong to one asyncio loop. A child that dies or hangs is replaced; only pictures are
    missing meanwhile.

    Attributes:
        restarts: how often a child was replaced.
    """

    def __init__(self, site: Site, room: Room, people: tuple[PersonScript, ...] = ()) -> None:
        self.restarts = 0
        self._scene = scene_mjcf(site, room, people, first=site.drone.name)
        self._rate_hz, camera = site.twin.video_rate_hz, camera_of(site.drone.airframe)
        self._size = camera.width, camera.height
        self._clock = RealClock()
        self._handlers: list[Callable[[EncodedPicture], None]] = []
        self._backends = list(_RENDERERS.get(os.environ.get(_RENDERER_VARIABLE, ""), RenderBackend))
        self._reasons: list[str] = (
            [f"{_RENDERER_VARIABLE}=none"] if os.environ.get(_RENDERER_VARIABLE) == "none" else []
        )
        self._number = 0
        self._task: asyncio.Task[None] | None = None
        self._child: subprocess.Popen[bytes] | None = None
        self._writer: asyncio.StreamWriter | None = None
        self._ready = False
        self._owed_since: float | None = None
        self._yields = True

    @property
    def pid(self) -> int | None:
        """Process id of the child, while there is one."""
        return self._child.pid if self._child else None

    @property
    def problem(self) -> str:
        """Why there are no real pictures, in words, or ""."""
        return "; ".join(self._reasons) if self._backends[0] is RenderBackend.CARD else ""

    def on_picture(self, handler: Callable[[EncodedPicture], None]) -> None:
        """Call this with every new picture; it must neither wait nor raise."""
        self._handlers.append(handler)

    def start(self) -> None:
        """Start the child in the background; needs a running loop."""
        self._task = asyncio.get_running_loop().create_task(self._supervise())

    def request_picture(
        self,
        pose: Pose,
        visitor_present: bool,
        camera: DroneCamera,
        at: float,
        people: tuple[Pose, ...] = (),
    ) -> None:
        """Ask for a picture; returns at once. A busy child serves only the newest request."""
        if (
            self._writer is None
            or not self._ready
            or self._writer.transport.get_write_buffer_size()
        ):
            return
        self._writer.write(
            pack_message(
                MessageKind.REQUEST,
                PictureRequest(pose, visitor_present, camera, at, people).pack(),
            )
        )
        if self._owed_since is None:
            self._owed_since = self._clock.now()

    def close(self) -> None:
        """End the child and the supervision."""
        if self._task is not None:
            self._task.cancel()
        child = self._child
        self._kill_child()
        if child is not None:
            with suppress(subprocess.TimeoutExpired):
                child.wait(_EXIT_TIMEOUT)

    async def _supervise(self) -> None:
        pause = _FIRST_RESTART_DELAY
        while True:
            started = self._clock.now()
            was_ready, reason = await self._run_child(self._backends[0])
            if not was_ready and len(self._backends) > 1:
                self._reasons.append(f"{self._backends.pop(0).name.lower()}: {reason}")
                continue
            self.restarts += 1
            pause = (
                _FIRST_RESTART_DELAY
                if self._clock.now() - started > _STABLE_AFTER
                else min(2 * pause, _MAX_RESTART_DELAY)
            )
            await asyncio.sleep(pause)

    async def _run_child(self, backend: RenderBackend) -> tuple[bool, str]:
        """Run one child to its end; return whether it became ready, and why it ended."""
        reason = "the process ended"
        try:
            reader = await self._spawn(backend)
            while True:
                kind, body = await self._receive(reader)
                if kind is MessageKind.READY:
                    self._ready = True
                elif kind is MessageKind.PICTURE:
                    self._deliver(Encoded.unpack(body))
                else:
                    reason = body.decode(errors="replace")
        except TimeoutError:
            self._yields = self._yields and not self._ready
            return self._ready, "the process hung"
        except (asyncio.IncompleteReadError, OSError):
            return self._ready, reason
        finally:
            self._kill_child()

    async def _spawn(self, backend: RenderBackend) -> asyncio.StreamReader:
        ours, theirs = socket.socketpair()
        with theirs:
            self._child = subprocess.Popen(
                [sys.executable, "-m", "housefly.twin.camera.child", str(theirs.fileno())],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                pass_fds=[theirs.fileno()],
                env=_environment(backend),
            )
        reader, self._writer = await asyncio.open_connection(sock=ours)
        settings = RenderSettings(
            self._scene, backend, self._rate_hz, self._size, tuple(self._reasons), self._yields
        )
        self._writer.write(pack_message(MessageKind.SETTINGS, settings.pack()))
        return reader

    async def _receive(self, reader: asyncio.StreamReader) -> tuple[MessageKind, bytes]:
        """Return the next message; raises TimeoutError when the child owes one for too long."""
        kind, length = MESSAGE_HEADER.unpack(await self._header(reader))
        async with asyncio.timeout(_HUNG_AFTER):
            return MessageKind(kind), await reader.readexactly(length)

    async def _header(self, reader: asyncio.StreamReader) -> bytes:
        started = self._clock.now()
        while True:
            try:
                async with asyncio.timeout(_POLL_PERIOD):
                    return await reader.readexactly(MESSAGE_HEADER.size)
            except TimeoutError:
                owed = self._owed_since, _STARVED_AFTER if self._yields else _HUNG_AFTER
                since, patience = owed if self._ready else (started, _START_TIMEOUT)
                if since is not None and self._clock.now() - since > patience:
                    raise

    def _deliver(self, picture: Encoded) -> None:
        self._owed_since = None
        self._number += 1
        numbered = EncodedPicture(
            self._number, picture.data, picture.keyframe, picture.width, picture.height, picture.at
        )
        for handler in self._handlers:
            handler(numbered)

    def _kill_child(self) -> None:
        self._ready, self._owed_since = False, None
        if self._writer is not None:
            self._writer.transport.abort()
            self._writer = None
        if self._child is not None:
            self._child.kill()
            # A starving child is slow even to die, and the simulated drone must not wait for it.
            Thread(target=self._child.wait, name="camera child", daemon=True).start()
            self._child = None


def _environment(backend: RenderBackend) -> dict[str, str]:
    """Return the child's environment: its GL library, one thread for software rendering."""
    environment = {name: value for name, value in os.environ.items() if name != "MUJOCO_GL"}
    environment.setdefault("LP_NUM_THREADS", "0")
    if backend is not RenderBackend.CARD:
        environment["MUJOCO_GL"] = backend.name.lower()
    return environment
