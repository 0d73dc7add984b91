"""Situation detectors: who is where and how, what was taken, who is at the door. Pure."""

from housefly.hub.situations.layout import Area, Layout
from housefly.hub.situations.situation import Situation
from housefly.hub.situations.situations import Situations

__all__ = ["Area", "Layout", "Situation", "Situations"]
