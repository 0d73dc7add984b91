"""Where the simulated room writes the true course of each of several drones."""

from __future__ import annotations

from pathlib import Path


def take_truth(given: Path, drone: str, own: Path) -> None:
    """Move what the simulated room wrote of one of several drones to where it is looked for.

    Args:
        given: file that the simulated room was given; with one drone it is that one's.
        drone: whose.
        own: where its recorder looks.
    """
    written = given.with_stem(f"{given.stem}-{drone}")
    if written.exists():
        written.replace(own)
