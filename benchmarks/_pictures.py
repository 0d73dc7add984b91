"""Pictures as the simulated drone sends them on a round flight through its room."""

from __future__ import annotations

from camera import PICTURES, RATE_HZ, SCENE, pose
from housefly.twin.camera.encoder import Encoder
from housefly.twin.camera.messages import PictureRequest
from housefly.twin.camera.view import CameraView
from housefly.twin.contracts import DroneCamera
from housefly.twin.quadrotor.body import PICTURE_SIZE


def flight_pictures() -> list[tuple[bytes, bool]]:
    """Return eight seconds of H.264 in flight, and whether each is a key frame."""
    view, encoder = CameraView(SCENE, *PICTURE_SIZE), Encoder(*PICTURE_SIZE, RATE_HZ)
    requests = (
        PictureRequest(pose(number / PICTURES), True, DroneCamera.FRONT, number / RATE_HZ)
        for number in range(PICTURES)
    )
    return [encoder.encode(view.picture(request)) for request in requests]
