"""Writes ``docs/site.md`` from the types: every key of a site file, with range and meaning.

``python scripts/site_page.py > docs/site.md``
"""

from __future__ import annotations

from textwrap import fill
from typing import Any, get_args, get_origin

from pydantic.fields import FieldInfo

from housefly.config.drone import DroneConfig
from housefly.config.section import Section
from housefly.config.site import Site

_HEAD = """# The site file

A site file (TOML) names the room, the drone, the tracking system and the limits of one place where
Housefly flies. Every key has a default: an empty file is a valid site (the simulated B-sen). A
value of the wrong type or outside its range, an unknown key, or a combination that cannot fly is
refused with the key and what is allowed. All numbers are SI; a key whose unit is not SI says so in
its name.

```toml
name = "my lab"

[room]
model = "."            # the folder that `housefly room import map.yaml --out DIR` wrote

[drone]
address = "192.168.1.1"    # a real AR.Drone 2.0

[tracking]
address = "10.0.0.5"       # the machine that runs Vicon Tracker
port = 801
body = "ardrone"

[twin]
enabled = false
```

Several drones have a table each. What it leaves out its model gives, else `[drone]`; the room, the
tracking system and the limits are for all. The first may have the room's own pad.

```toml
[drone]                    # what all have
has_video = false

[models.indoor]            # what a model has
kind = "ardrone"
hull_length = 0.52

[[drones]]
name = "red"               # its body, too, unless body says otherwise
model = "indoor"
address = "192.168.1.11"

[[drones]]
name = "blue"
model = "indoor"
address = "192.168.1.12"
pad = [4.0, 1.5, 0.0]      # x, y [m], heading [rad]
```

This page is made from the code (`python scripts/site_page.py`); a test keeps it current.
"""


def site_page() -> str:
    """Return the page as Markdown."""
    parts = [
        _HEAD,
        _table("Top level", {k: v for k, v in Site.model_fields.items() if not _is_section(v)}),
    ]
    for key, found in Site.model_fields.items():
        if _is_section(found):
            section: type[Section] = found.annotation  # type: ignore[assignment]
            parts.append(_table(f"[{key}]", section.model_fields, _prose(section)))
        elif many := _sections_in(found):
            title = f"[{key}.NAME]" if get_origin(found.annotation) is dict else f"[[{key}]]"
            parts.append(_table(title, _own_fields(many), _prose(many)))
    return "\n".join(parts)


def _own_fields(section: type[Section]) -> dict[str, FieldInfo]:
    """Return the keys of a section; of one that may have all keys of the drone, only the others."""
    if not issubclass(section, DroneConfig):
        return section.model_fields
    plain = DroneConfig.model_fields
    return {
        key: found
        for key, found in section.model_fields.items()
        if key not in plain or found.is_required()
    }


def _is_section(found: FieldInfo) -> bool:
    return isinstance(found.annotation, type) and issubclass(found.annotation, Section)


def _sections_in(found: FieldInfo) -> type[Section] | None:
    """Return the section type of a list at the top level, or None."""
    kinds = [
        kind
        for kind in get_args(found.annotation)
        if isinstance(kind, type) and issubclass(kind, Section)
    ]
    return kinds[0] if kinds else None


def _table(title: str, fields: dict[str, FieldInfo], meaning: str = "") -> str:
    if not fields:
        return f"## {title}\n\n{meaning}\n"
    lines = [
        f"## {title}",
        "",
        *([meaning, ""] if meaning else []),
        "| key | default | allowed | meaning |",
        "|---|---|---|---|",
    ]
    lines += [
        f"| `{key}` | {_default(found)} | {_allowed(found)} | {found.description or ''} |"
        for key, found in fields.items()
    ]
    return "\n".join(lines) + "\n"


def _default(found: FieldInfo) -> str:
    if found.is_required():
        return "-"
    # a default that depends on the drone is shown for the default drone
    given = DroneConfig().model_dump(include={"kind"})
    value = found.get_default(call_default_factory=True, validated_data=given)
    if isinstance(value, bool):
        return "`true`" if value else "`false`"
    if isinstance(value, str):
        return f'`"{value}"`'
    return f"`{list(value)}`" if isinstance(value, tuple) else f"`{value}`"


def _allowed(found: FieldInfo) -> str:
    choices = [value for value in get_args(found.annotation) if isinstance(value, str)]
    if choices:
        return ", ".join(f'`"{choice}"`' for choice in choices)
    bounds: list[Any] = [
        getattr(item, side)
        for side in ("ge", "le")
        for item in found.metadata
        if hasattr(item, side)
    ]
    if len(bounds) == 2:
        extra = found.json_schema_extra if isinstance(found.json_schema_extra, dict) else {}
        unit = str(extra.get("unit", "1"))
        return f"{bounds[0]:g} to {bounds[1]:g}" + ("" if unit == "1" else f" {unit}")
    words: dict[Any, str] = {bool: "`true`, `false`", str: "text"}
    return words.get(found.annotation, "a table or list, see the meaning")


def _prose(section: type) -> str:
    """Return the docstring of a section as one paragraph."""
    return fill(" ".join((section.__doc__ or "").split()), 100)


if __name__ == "__main__":
    print(site_page(), end="")
