"""What makes the demo lively, added to a site without replacing anything of its own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from housefly.config.site import Site

_SCENE, _ROOM = "demo", "bsen"
"""The shipped scene, and the room in which its people do not walk through walls."""


def demo_changes() -> dict[str, Any]:
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


def demo_site(site: Site, has_broker: bool) -> tuple[Site, str]:
    """Return a site with what makes it lively beside what it has, and words that say what is whose.

    A site into which the shipped scene does not fit stays as it is.

    Args:
        site: of the demo.
        has_broker: whether this machine can start a broker for the devices.
    """
    from housefly.config.site import changed

    if words := _objection(site):
        return site, words
    added, kept = demo_changes(), []
    if site.twin.scene:
        del added["twin__scene"]
        kept.append(f"the scene {site.twin.scene}")
    if site.mqtt.broker or not has_broker:
        added = {key: value for key, value in added.items() if not key.startswith("mqtt__")}
    if site.mqtt.broker:
        kept.append(f"the broker {site.mqtt.broker}")
    if site.lasers:
        del added["lasers"]
        kept.append("the scanners " + ", ".join(laser.name for laser in site.lasers))
    if site.hub.things:
        kept.append(f"the things of {site.hub.things}")
    added |= _tags(site)
    is_mute = not site.mqtt.broker and not has_broker
    return changed(site, **added), _words(added, kept) + (_MUTE if is_mute else "")


def remembered_site(site: Site) -> Site:
    """Return a site with the people and things of the demo, which its memory may hold."""
    from housefly.config.site import changed

    if site.twin.scene or not site.twin.enabled or site.room.model != _ROOM:
        return site
    return changed(site, twin__scene=_SCENE)


def _objection(site: Site) -> str:
    """Return why nobody is added to a site, or ""."""
    if not site.twin.enabled:
        return "nothing added: this room is real"
    if site.room.model != _ROOM and not site.twin.scene:
        return (
            f"nothing added: the people who ship live in the room {_ROOM!r}, and this one is"
            f" {site.room.model!r}; [twin] scene names people of your own"
            " (sites/demo_scene.toml shows how)"
        )
    return ""


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
    "twin__scene": "people, their things",
    "mqtt__broker": "devices on MQTT",
    "lasers": "three scanners that see people",
    "mqtt__tags": "tags",
}
_MUTE = (
    "; mosquitto is not installed, so no cabinet, bed or floor is heard (apt-get install"
    " mosquitto); the doorbell rings by a webhook"
)
