"""The drone's pictures as JPEG, for browsers without WebCodecs, which needs a secure address.

Pictures are decoded only while such a browser watches.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from io import BytesIO

import av
from av.codec.context import Flags
from av.error import FFmpegError
from av.video.codeccontext import VideoCodecContext
from PIL import Image
from starlette.responses import StreamingResponse

from housefly.web.camera.video import FRAME_HEADER, VideoRelay
from housefly.web.http.seats import Seats

_BOUNDARY = "picture"
_JPEG_QUALITY = 75


def mjpeg_response(
    video: VideoRelay, seats: Seats, owner: str, may_watch: Callable[[], bool]
) -> StreamingResponse:
    """Answer with pictures until the browser leaves or may not; with none when it has no seat."""
    kind = f"multipart/x-mixed-replace; boundary={_BOUNDARY}"
    return StreamingResponse(
        _seated_pictures(video, seats, owner, may_watch),
        media_type=kind,
        headers={"cache-control": "no-store"},
    )


async def _seated_pictures(
    video: VideoRelay, seats: Seats, owner: str, may_watch: Callable[[], bool]
) -> AsyncIterator[bytes]:
    with seats.taken(owner) as seated:
        if seated:
            async for picture in _pictures(video):
                if not may_watch():
                    return
                yield picture


async def _pictures(video: VideoRelay) -> AsyncIterator[bytes]:
    decoder = VideoCodecContext.create("h264", "r")
    decoder.thread_count, decoder.flags = 1, decoder.flags | Flags.low_delay
    with video.subscribed() as queue:
        while True:
            await queue.wake.wait()
            queue.wake.clear()
            if queue.waiting:
                messages = list(queue.waiting)
                queue.waiting.clear()
                picture = await asyncio.to_thread(_newest, decoder, messages)
                if picture:
                    head = (
                        f"--{_BOUNDARY}\r\nContent-Type: image/jpeg\r\nContent-Length:"
                        f" {len(picture)}\r\n\r\n"
                    )
                    yield head.encode() + picture + b"\r\n"


def _newest(decoder: VideoCodecContext, messages: list[bytes]) -> bytes:
    """Decode all messages and return the last picture as JPEG; empty when none could be decoded."""
    newest = None
    for message in messages:
        try:
            frames = decoder.decode(av.Packet(message[FRAME_HEADER.size :]))
        except FFmpegError:
            continue
        newest = frames[-1] if frames else newest
    if newest is None:
        return b""
    buffer = BytesIO()
    Image.fromarray(newest.to_ndarray(format="rgb24")).save(buffer, "JPEG", quality=_JPEG_QUALITY)
    return buffer.getvalue()
