"""H.264 in Annex B byte strings: which units a picture is made of."""

from __future__ import annotations

START_CODE = b"\x00\x00\x01"
_NAL_SLICE, _NAL_IDR, _NAL_SPS, _NAL_PPS = 1, 5, 7, 8


def can_begin(annex_b: bytes) -> bool:
    """Return whether a picture has SPS, PPS and an IDR slice, so that decoding may start here."""
    return {_NAL_SPS, _NAL_PPS, _NAL_IDR} <= nal_types(annex_b)


def nal_types(annex_b: bytes) -> frozenset[int]:
    """Return the types of the units up to the first slice."""
    found, at = set(), annex_b.find(START_CODE)
    while 0 <= at < len(annex_b) - len(START_CODE):
        at += len(START_CODE)
        kind = annex_b[at] & 0x1F
        found.add(kind)
        # A slice is the last and by far the longest unit of a one-slice picture; do not search it.
        if kind in (_NAL_SLICE, _NAL_IDR):
            break
        at = annex_b.find(START_CODE, at)
    return frozenset(found)
