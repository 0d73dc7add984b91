"""Privacy in pictures: zones blank and faces blurred, before disk and screen."""

from __future__ import annotations

from housefly.evidence.face_blur import FaceBlur
from housefly.evidence.picture_codec import Picture, PictureDecoder, PictureEncoder
from housefly.evidence.privacy_mask import MASK_ALL, FrameToMask, PrivacyMask
from housefly.messages import VideoFrame

BLANK = (24, 26, 30)
"""Colour of what is blank (RGB)."""


class FrameBlanker:
    """Decodes, blanks and encodes a stream, picture by picture.

    Args:
        faces: what blurs faces, or None.

    Attributes:
        has_blanked: whether anything was blanked so far.
    """

    def __init__(self, faces: FaceBlur | None = None) -> None:
        self.has_blanked = False
        self._faces = faces
        self._decoder = PictureDecoder()
        self._encoder: PictureEncoder | None = None

    def filtered(self, filmed: FrameToMask) -> VideoFrame | None:
        """Return the frame that may be shown and kept; None when it cannot be decoded.

        Frames must come in order, each of them.
        """
        picture = self.picture(filmed)
        if picture is None:
            return None
        size = picture.shape[1], picture.shape[0]
        if self._encoder is None or self._encoder.size != size:
            self._encoder = PictureEncoder(*size)
        return self._encoder.encode(picture, filmed.frame)

    def picture(self, filmed: FrameToMask) -> Picture | None:
        """Return the picture that may be shown and kept; None when it cannot be decoded."""
        decoded = self._decoder.decode(filmed.frame)
        if decoded is None:
            return None
        shown = decoded if self._faces is None else self._faces.blurred(decoded)
        if filmed.mask.is_empty:
            return shown
        self.has_blanked = True
        size = filmed.frame.width, filmed.frame.height
        # A mask is made for the size that the drone tells.
        is_told = size == (shown.shape[1], shown.shape[0])
        return blanked_picture(shown, filmed.mask if is_told else MASK_ALL)


def blanked_picture(picture: Picture, mask: PrivacyMask) -> Picture:
    """Return a picture with everything blank that must be."""
    height, width = picture.shape[:2]
    blank = picture.copy()
    blank[mask.pixels(width, height)] = BLANK
    return blank
