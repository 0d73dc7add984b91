"""The parts of which a report is made: one page, its numbers, figures and events, as HTML."""

from __future__ import annotations

import html
from collections.abc import Sequence

from housefly.record.report_style import REPORT_CSS
from housefly.record.summary import EventRecord

_MARKS = {"info": "", "warning": "\u25b2", "fault": "\u25a0"}
"""Shapes beside the words, for those who do not see colours."""


def report_page(title: str, header: str, sections: Sequence[tuple[str, str]]) -> str:
    """Return a whole page; sections are titles and their HTML."""
    body = "\n".join(f"<section><h2>{name}</h2>{content}</section>" for name, content in sections)
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{report_text(title)}</title>
<style>{REPORT_CSS}</style>
</head>
<body>
<main>
{header}
{body}
</main>
</body>
</html>
"""


def report_number(name: str, value: float | None, digits: int, unit: str) -> str:
    """Return a number with its name and unit; a dash for one that is not known."""
    shown = "\u2014" if value is None else f"{value:,.{digits}f}".replace(",", "\u202f")
    return (
        f"<div><dt>{name}</dt><dd>{shown} <small>{'' if value is None else unit}</small></dd></div>"
    )


SCROLLS = '<div class="plot" tabindex="0">'
"""Around what is wider than a phone; keys scroll it, too."""


def report_figure(svg: str, caption: str) -> str:
    """Return a drawing with its caption."""
    words = f"<figcaption>{caption}</figcaption>"
    return f"<figure>{SCROLLS}{svg}</div>{words}</figure>"


def report_events(events: Sequence[EventRecord]) -> str:
    """Return events as a table."""
    if not events:
        return "<p>Nothing was reported.</p>"
    rows = "".join(
        f'<tr class="{event.severity}"><td>{event.at_s:.2f}</td><td>{_MARKS[event.severity]}'
        f" {event.severity}</td>"
        f"<td>{report_text(event.text)}</td><td><code>{report_text(event.code)}</code></td></tr>"
        for event in events
    )
    head = "<tr><th>time [s]</th><th>severity</th><th>what</th><th>code</th></tr>"
    return f"{SCROLLS}<table><thead>{head}</thead><tbody>{rows}</tbody></table></div>"


def report_text(value: str) -> str:
    """Return a text as HTML."""
    return html.escape(value)
