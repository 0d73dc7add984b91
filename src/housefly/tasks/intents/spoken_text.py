"""Text as it is compared: one form for what can be written in several ways."""

from __future__ import annotations

import re
import unicodedata

from housefly.tasks.intents.intent import Language

_COMMAS = frozenset(",\u3001\uff64")
"""They part words and mean nothing; Japanese puts no space after them."""
_SPACES = re.compile(r"\s+")
_INVISIBLE = frozenset({"Cc", "Cf", "Cn", "Co", "Cs"})
"""Unicode categories of characters that nobody sees."""
_QUOTES = {
    '"': '"',
    "`": "`",
    "\u201e": "\u201c\u201d",
    "\u201c": "\u201d\u201c",
    "\u201d": "\u201d\u201c",
    "\u00ab": "\u00bb",
    "\u00bb": "\u00ab",
    "\u300c": "\u300d",
    "\u300e": "\u300f",
    "\u2018": "\u2019",
    "\u201a": "\u2018\u2019",
    "\u2039": "\u203a",
    "\u203a": "\u2039",
}
"""Quotation marks: what opens, and what closes it."""
_GERMAN = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue"})
_CJK_SIGNS = "\u3005\u3006\u3040-\u30ff\u3400-\u4dbf\u4e00-\u9fff"
_CJK = re.compile(f"[{_CJK_SIGNS}]")
_CJK_SPACES = re.compile(f"(?<=[{_CJK_SIGNS}]) (?=[{_CJK_SIGNS}])")


def folded(text: str, language: Language) -> str:
    """Return text in small letters, single spaces, full-width forms and umlauts written out."""
    text = unicodedata.normalize("NFKC", text).casefold()
    text = unicodedata.normalize("NFKC", text)
    if language == "de":
        text = text.translate(_GERMAN)
    text = text.replace("\u2019", "'").replace("\u2018", "'")
    shown = (" " if one.isspace() or one in _COMMAS else one for one in text)
    visible = "".join(one for one in shown if unicodedata.category(one) not in _INVISIBLE)
    text = _SPACES.sub(" ", visible).strip()
    return _CJK_SPACES.sub("", text) if language == "ja" else text


def without_quotes(text: str) -> tuple[str, tuple[str, ...]]:
    """Return a sentence without quotation marks, and what stood between them."""
    quoted: list[str] = []
    kept: list[str] = []
    rest = text
    while rest:
        start = next((i for i, one in enumerate(rest) if one in _QUOTES), None)
        ends = () if start is None else _ends(rest, start)
        if start is None or not ends:
            kept.append("".join(one for one in rest if one not in _QUOTES))
            break
        end = min(ends)
        kept.append(f"{rest[:start]} {rest[start + 1 : end]} ")
        quoted.append(rest[start + 1 : end])
        rest = rest[end + 1 :]
    return "".join(kept).strip(), tuple(quoted)


def _ends(text: str, start: int) -> tuple[int, ...]:
    found = (text.find(mark, start + 1) for mark in _QUOTES[text[start]])
    return tuple(end for end in found if end > start)


def is_cjk(text: str) -> bool:
    """Return whether a text has signs of a script that puts no spaces between words."""
    return _CJK.search(text) is not None


def occurrences(name: str, text: str) -> tuple[tuple[int, int], ...]:
    """Return where a folded name stands in a folded text: begin and end of each, whole words."""
    if not name:
        return ()
    found: list[tuple[int, int]] = []
    start = text.find(name)
    while start >= 0:
        end = start + len(name)
        if _is_edge(text, start) and _is_edge(text, end):
            found.append((start, end))
        start = text.find(name, start + 1)
    return tuple(found)


def _is_edge(text: str, index: int) -> bool:
    """Return whether a word begins or ends there."""
    if index in (0, len(text)):
        return True
    before, after = text[index - 1], text[index]
    return (
        not (before.isalnum() and after.isalnum())
        or bool(_CJK.match(before + after))
        or bool(_CJK.match(after))
    )
