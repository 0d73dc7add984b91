"""Words for wall in the names of layers, in the languages that plans are drawn in."""

from __future__ import annotations

import re
import unicodedata
from functools import cache

_PARTS = (
    # English, German, Dutch, French, Spanish, Portuguese, Italian
    "wall", "partition", "mauer", "wand", "waend", "muur", "cloison", "paroi", "muro", "muraille",
    "pared", "parede", "tabique", "parete", "pareti", "tramezz", "muratura",
    # Swedish, Norwegian, Danish, Finnish, Polish, Czech, Russian, Turkish
    "vagg", "vegg", "væg", "seina", "scian", "stena", "steny", "стен", "duvar",
    # Japanese, Chinese, Korean
    "壁", "間仕切", "墙", "牆", "墻", "隔断", "벽",
)  # fmt: skip
_WHOLE = frozenset({"mur", "murs", "muri", "zed", "zdi"})
"""French, Italian, Czech: inside of longer words they mean something else."""
_LETTERS = re.compile(r"[^\W\d_]+")


def names_wall(text: str) -> bool:
    """Return whether a layer's name holds a word for wall; accents and case do not matter."""
    plain = _folded(text)
    return any(part in plain for part in _FOLDED) or not _WHOLE.isdisjoint(_LETTERS.findall(plain))


def names_any(text: str, words: tuple[str, ...]) -> bool:
    """Return whether a layer's name holds one of some words; accents and case do not matter."""
    plain = _folded(text)
    return any(_folded(word) in plain for word in words)


@cache
def _folded(text: str) -> str:
    """Return a text in small letters without accents."""
    apart = unicodedata.normalize("NFKD", text)
    return "".join(sign for sign in apart if not unicodedata.combining(sign)).casefold()


_FOLDED = tuple(_folded(part) for part in _PARTS)
