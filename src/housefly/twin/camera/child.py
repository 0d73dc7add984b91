"""The process that renders the drone's pictures: ``python -m housefly.twin.camera.child FD``.

It serves only the newest request at its end of a socket pair, and ends when the other end closes.
It is a process of its own because a missing or broken GL library can take the whole process down.
"""

from __future__ import annotations

import os
import signal
import socket
import sys
import time

import numpy as np
from numpy.typing import NDArray

from housefly.twin.camera.card import draw_card
from housefly.twin.camera.encoder import Encoder
from housefly.twin.camera.messages import (
    Encoded,
    Inbox,
    MessageKind,
    PictureRequest,
    RenderBackend,
    RenderSettings,
    pack_message,
)

_CARD_RATE_HZ = 2.0
_CARD_BIT_RATE = 200_000
_NICENESS = 10
"""Lower priority than the twin's own: pictures may be late, physics and the pilot may not.

A picture takes some milliseconds of processor time; on Linux only a process of the idle policy is
preempted for everything else. A process cannot leave that policy, so the parent replaces a child
that starves.
"""


def _serve(link: socket.socket) -> None:
    """Read the settings, then answer requests with pictures until the other end closes."""
    inbox = Inbox(link)
    (_, body), *_ = inbox.receive() or [(MessageKind.SETTINGS, b"")]
    if not body:
        return
    settings = RenderSettings.unpack(body)
    try:
        if settings.backend is RenderBackend.CARD:
            _send_cards(link, inbox, settings)
        else:
            _send_views(link, inbox, settings)
    except (BrokenPipeError, ConnectionResetError):
        return
    except Exception as error:  # whatever a GL stack raises: the parent tries the next backend
        link.sendall(pack_message(MessageKind.FAILED, f"{type(error).__name__}: {error}".encode()))


def _send_views(link: socket.socket, inbox: Inbox, settings: RenderSettings) -> None:
    from housefly.twin.camera.view import CameraView

    view = CameraView(settings.scene, *settings.size)
    encoder = Encoder(*settings.size, settings.rate_hz)
    link.sendall(pack_message(MessageKind.READY, settings.backend.name.encode()))
    if settings.yields and sys.platform == "linux":
        os.sched_setscheduler(0, os.SCHED_IDLE, os.sched_param(0))
    while (request := _newest(inbox)) is not None:
        _send(link, encoder, view.picture(request), request.at, settings.size)


def _send_cards(link: socket.socket, inbox: Inbox, settings: RenderSettings) -> None:
    card = draw_card(settings.reasons, *settings.size)
    encoder = Encoder(*settings.size, _CARD_RATE_HZ, group=1, bit_rate=_CARD_BIT_RATE)
    link.sendall(pack_message(MessageKind.READY, settings.backend.name.encode()))
    due = 0.0
    while (request := _newest(inbox)) is not None:
        if time.monotonic() >= due:
            due = time.monotonic() + 1 / _CARD_RATE_HZ
            _send(link, encoder, card, request.at, settings.size)


def _newest(inbox: Inbox) -> PictureRequest | None:
    messages = inbox.receive()
    return PictureRequest.unpack(messages[-1][1]) if messages else None


def _send(
    link: socket.socket,
    encoder: Encoder,
    picture: NDArray[np.uint8],
    at: float,
    size: tuple[int, int],
) -> None:
    data, keyframe = encoder.encode(picture)
    link.sendall(pack_message(MessageKind.PICTURE, Encoded(data, keyframe, *size, at).pack()))


def main() -> None:
    """Serve the socket whose file descriptor is the first argument."""
    # Ctrl-C is for the parent; this process notices when it ends.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.nice(_NICENESS)
    with socket.socket(fileno=int(sys.argv[1])) as link:
        _serve(link)
        # A half-loaded GL library may crash in its own clean-up; there is nothing left to clean up.
        link.shutdown(socket.SHUT_WR)
        os._exit(0)


if __name__ == "__main__":
    main()
