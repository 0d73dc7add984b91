"""The style sheet of the flight report: one type scale, one accent, light and dark."""

from __future__ import annotations

from housefly.theme import DARK, LIGHT, Theme


def _variables(theme: Theme) -> str:
    """Return a theme as variables of a style sheet."""
    return f"""
  --paper: {theme.paper}; --card: {theme.card}; --ink: {theme.ink}; --muted: {theme.quiet};
  --line: {theme.line}; --accent: {theme.accent}; --second: {theme.second};
  --warn: {theme.warn}; --fault: {theme.danger}; --good: {theme.good};
  --occupied: {theme.wall}; --inflated: {theme.margin}; --virtual: {theme.virtual};
  --outside: {theme.outside}; --furniture: {theme.thing_edge};
"""


_LIGHT = f"""{_variables(LIGHT)}
  --s0: #e6e9ee; --s1: #cfe3fb; --s2: #a9cdf7; --s3: #bfe5c8; --s4: #e3ecc2;
  --s5: #d7cff2; --s6: #f3d9c0;
  --v0: #3b1c8c; --v1: #7e03a8; --v2: #b5367a; --v3: #d1492f; --v4: #b87300;
"""
_DARK = f"""{_variables(DARK)}
  --s0: #262d37; --s1: #1d3b5c; --s2: #24538a; --s3: #20492f; --s4: #424a1e;
  --s5: #3d3563; --s6: #5a3b22;
  --v0: #8f86ff; --v1: #c58bff; --v2: #f07bb0; --v3: #ff9a6b; --v4: #ffd166;
"""

REPORT_CSS = f"""
:root {{{_LIGHT}
  --font: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif;
}}
@media (prefers-color-scheme: dark) {{ :root {{{_DARK}}} }}
@media print {{ :root {{{_LIGHT}}} }}
* {{ box-sizing: border-box; }}
body {{ margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.5 var(--font); }}
main {{ max-width: 1080px; margin: 0 auto; padding: 32px 24px 64px; }}
h1 {{ margin: 0 0 12px; font-size: 28px; line-height: 1.2; letter-spacing: -0.01em; }}
h2 {{ margin: 40px 0 8px; font-size: 18px; }}
p {{ margin: 4px 0; color: var(--muted); }}
.outcome {{ display: inline-flex; gap: 8px; align-items: center; margin: 0 0 8px;
  padding: 4px 14px 4px 10px;
  border: 1.5px solid currentColor; border-radius: 999px; font-weight: 600; }}
.good {{ color: var(--good); }}
.bad, .problem, tr.fault td:nth-child(2) {{ color: var(--fault); }}
tr.warning td:nth-child(2) {{ color: var(--warn); }}
dl {{ display: grid; grid-template-columns: repeat(auto-fit, minmax(160px, 1fr)); gap: 1px;
  margin: 24px 0 0; padding: 1px; background: var(--line); border-radius: 10px; overflow: hidden; }}
dl div {{ padding: 10px 14px; background: var(--card); }}
dt {{ color: var(--muted); font-size: 12.5px; }}
dd {{ margin: 0; font-size: 20px; font-variant-numeric: tabular-nums; }}
small {{ color: var(--muted); font-size: 13px; }}
figure {{ margin: 0; }}
figcaption {{ margin-top: 4px; color: var(--muted); font-size: 13px; }}
.plot {{ overflow-x: auto; }}
.plot svg {{ display: block; width: 100%; min-width: 640px; height: auto; }}
table {{ width: 100%; border-collapse: collapse; font-size: 14px;
  font-variant-numeric: tabular-nums; }}
th {{ color: var(--muted); font-size: 12.5px; font-weight: 500; text-align: left; }}
th, td {{ padding: 5px 12px 5px 0; border-bottom: 1px solid var(--line); vertical-align: top; }}
code {{ color: var(--muted); font-size: 12.5px; }}
"""
