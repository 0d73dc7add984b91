"""What decides whether an element of SVG is shown: attributes, style sheets, and what is around."""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.etree.ElementTree import Element

from housefly.room.draft.imports.svg_lengths import user_length

_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_RULE = re.compile(r"([^{}]+)\{([^{}]*)\}")
_SIMPLE = re.compile(r"(\*|[\w-]+)?(?:([.#])([\w-]+))?")
_KEYS = ("display", "visibility", "opacity", "fill", "stroke", "stroke-width")
_STYLING = frozenset({*_KEYS, "style"})
_INVISIBLE = ("none", "transparent")

Rules = tuple[tuple[str, str, str, dict[str, str]], ...]
"""Tag or "*", "." or "#" or "", name behind it, and what holds for such elements."""


@dataclass(frozen=True, slots=True)
class SvgStyle:
    """What holds for an element and is handed on to those inside of it."""

    is_gone: bool = False
    visibility: str = "visible"
    fill: str = ""
    stroke: str = ""
    stroke_width: str = "1"

    @property
    def is_hidden(self) -> bool:
        """Whether nothing is seen of a shape with this style."""
        return (
            self.is_gone
            or self.visibility in ("hidden", "collapse")
            or (self.fill in _INVISIBLE and self.stroke in _INVISIBLE)
        )

    @property
    def width(self) -> float:
        """Width of its lines in user units, 0 without any."""
        if self.stroke in ("", *_INVISIBLE):
            return 0.0
        try:
            return max(0.0, user_length(self.stroke_width, None))
        except ValueError:
            return 0.0


def style_rules(root: Element) -> Rules:
    """Return the simple rules of the style sheets in a picture; others are passed over."""
    text = "".join(one.text or "" for one in root.iter() if one.tag.endswith("style"))
    rules = []
    for selectors, body in _RULE.findall(_COMMENT.sub("", text)):
        for selector in selectors.split(","):
            match = _SIMPLE.fullmatch(selector.strip())
            if match and selector.strip():
                rules.append((match[1] or "*", match[2] or "", match[3] or "", _declared(body)))
    return tuple(rules)


def style_of(element: Element, tag: str, around: SvgStyle, rules: Rules) -> SvgStyle:
    """Return the style of an element inside of others."""
    if not rules and _STYLING.isdisjoint(element.attrib):
        return around
    own = {key: element.get(key, "").strip().lower() for key in _KEYS if key in element.attrib}
    for wanted, kind, name, declared in rules:
        if wanted in ("*", tag) and _is_named(element, kind, name):
            own |= declared
    own |= _declared(element.get("style", ""))
    is_gone = own.get("display") == "none" or own.get("opacity") in ("0", "0%", "0.0")
    return SvgStyle(
        around.is_gone or is_gone,
        *(
            own[key] if own.get(key, "inherit") != "inherit" else getattr(around, attribute)
            for key, attribute in _HANDED_ON.items()
        ),
    )


_HANDED_ON = {
    "visibility": "visibility",
    "fill": "fill",
    "stroke": "stroke",
    "stroke-width": "stroke_width",
}


def _is_named(element: Element, kind: str, name: str) -> bool:
    if kind == ".":
        return name in element.get("class", "").split()
    return kind == "" or element.get("id") == name


def _declared(body: str) -> dict[str, str]:
    pairs = (part.partition(":") for part in body.replace("!important", "").split(";"))
    found = {key.strip().lower(): value.strip().lower() for key, _, value in pairs}
    return {key: found[key] for key in _KEYS if key in found}
