"""What makes the demo lively, added to a site without replacing anything of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.config.site import Site

_SCENE = _ROOM = "bsen"
"""The shipped scene, and the room in which its people do not walk through walls."""


def lively_changes() -> dict[str, Any]:
    """Return what makes the demo lively: people, their things and devices, and what sees people.

    The scanners look at 0.85 m: over the headboard of the bed and the backs of chairs, at standing,
    sitting and small people, while the drone flies above.
    """
    z = 0.85
    return {
        "twin__scene": _SCENE,
        "mqtt__broker": "127.0.0.1",
        "mqtt__start": True,
        "mqtt__port": 0,
        "lasers": [
            {"name": "laser-1", "x": 5.5, "y": 0.85, "z": z, "yaw": 1.2},
            {"name": "laser-2", "address": "127.0.0.2", "x": 13.9, "y": 3.3, "z": z, "yaw": -2.6},
            {"name": "laser-3", "address": "127.0.0.3", "x": 0.3, "y": 4.9, "z": z, "yaw": -0.2},
        ],
    }


def lively_site(site: Site) -> tuple[Site, str]:
    """Return a site with what makes it lively beside what it has, and words that say what is whose.

    Raises:
        ConfigError: the shipped scene does not fit the site; the message says what to do.
    """
    from housefly.config.site import changed

    _check(site)
    added, kept = lively_changes(), []
    if site.twin.scene:
        del added["twin__scene"]
        kept.append(f"the scene {site.twin.scene}")
    if site.mqtt.broker:
        added = {key: value for key, value in added.items() if not key.startswith("mqtt__")}
        kept.append(f"the broker {site.mqtt.broker}")
    if site.lasers:
        del added["lasers"]
        kept.append("the scanners " + ", ".join(laser.name for laser in site.lasers))
    if site.hub.things:
        kept.append(f"the things of {site.hub.things}")
    added |= _tags(site)
    return changed(site, **added), _words(added, kept)


def _check(site: Site) -> None:
    if not site.twin.enabled:
        raise ConfigError(
            "--lively",
            "needs the simulated room, and this site has [twin] enabled = false: leave --lively"
            " away, or enable the twin",
        )
    if site.room.model != _ROOM and not site.twin.scene:
        raise ConfigError(
            "--lively",
            f"brings people who live in the room {_ROOM!r}, and this site's room is"
            f" {site.room.model!r}: write a scene for it and name it, [twin] scene ="
            ' "my_scene.toml" (sites/bsen_scene.toml shows how), or leave --lively away',
        )


def _tags(site: Site) -> dict[str, Any]:
    """Return the site's tags with those of the scene's things that it does not name."""
    from pathlib import Path

    from housefly.twin.people import load_scene

    own = site.model_dump()["mqtt"]["tags"]
    known = {row["tag"] for row in own}
    things = load_scene(site.twin.scene or _SCENE, Path()).script.things
    new = [{"tag": one.tag, "thing": one.name} for one in things if one.tag not in known]
    return {"mqtt__tags": [*own, *new]} if new else {}


def _words(added: dict[str, Any], kept: list[str]) -> str:
    new = [words for key, words in _WORDS.items() if key in added]
    told = [f"added {', '.join(new)}"] if new else ["nothing to add"]
    return "; ".join([*told, *([f"this site's own stay: {', '.join(kept)}"] if kept else [])])


_WORDS = {
    "twin__scene": f"the people and things of the scene {_SCENE}",
    "mqtt__broker": "a broker for its devices",
    "lasers": "three scanners",
    "mqtt__tags": "tags",
}
