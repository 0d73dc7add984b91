"""Counts what a newcomer meets: public names, names defined twice, long lines, the walk.

``python scripts/house.py`` prints the counts; ``python scripts/house.py src/housefly`` also works
on another tree. ``tests/test_house.py`` holds the house to them.
"""

from __future__ import annotations

import ast
import re
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "src" / "housefly"
WALK_STARTS_AT = "housefly.pilot.pilot"
"""A sighting enters there and a command leaves."""
LINE_MAX = 100
CODE = ("src", "tests", "benchmarks", "examples", "scripts")
PRAGMA = re.compile(r"  # (?:type: ignore|noqa).*$")
SUFFIXES = (".py", ".ts", ".tsx", ".css", ".md")


def modules(package: Path = PACKAGE) -> dict[str, Path]:
    """Return every module of the package by its dotted name."""
    found = {}
    for path in sorted(package.rglob("*.py")):
        parts = [package.name, *path.relative_to(package).with_suffix("").parts]
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def public_definitions(package: Path = PACKAGE) -> dict[str, list[str]]:
    """Return the modules that define each public function or class at their top level.

    The names begin with their package: one that is unique there is unique enough.
    """
    found = defaultdict(list)
    for name, path in modules(package).items():
        if any(part.startswith("_") for part in name.split(".")):
            continue
        room = ".".join(name.split(".")[1:2])
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
                continue
            if not node.name.startswith("_"):
                found[f"{room}.{node.name}"].append(name)
    return dict(found)


def long_lines(root: Path = ROOT) -> list[str]:
    """Return file and number of every line that is too long.

    In prose, tables, links, messages on the wire and single words may be; so may a line with
    its word to the type checker.
    """
    found = []
    inside = (path for folder in (*CODE, "docs") for path in (root / folder).rglob("*"))
    for path in sorted([*root.glob("*.md"), *inside]):
        skipped = {"node_modules", "static", "__pycache__"} & set(path.parts)
        if path.suffix not in SUFFIXES or skipped or path.name in GENERATED:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            excused = path.suffix == ".md" and (
                line.lstrip().startswith(("|", "{")) or "](" in line or len(line.split()) == 1
            )
            if len(PRAGMA.sub("", line)) > LINE_MAX and not excused:
                found.append(f"{path.relative_to(root)}:{number}")
    return found


GENERATED = ("results.md",)
"""Printed by the benchmarks."""


def walk(start: str = WALK_STARTS_AT, package: Path = PACKAGE) -> dict[str, int]:
    """Return the lines of every module that one module imports, directly or not."""
    paths, seen, waiting = modules(package), {}, [start]
    while waiting:
        name = waiting.pop()
        if name in seen or name not in paths:
            continue
        text = paths[name].read_text(encoding="utf-8")
        seen[name] = len(text.splitlines())
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.ImportFrom) and node.module:
                waiting += [node.module, *(f"{node.module}.{each.name}" for each in node.names)]
            elif isinstance(node, ast.Import):
                waiting += [each.name for each in node.names]
    return seen


def main() -> None:
    """Print the counts."""
    package = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else PACKAGE
    definitions = public_definitions(package)
    twice = {name: places for name, places in definitions.items() if len(places) > 1}
    start = WALK_STARTS_AT if WALK_STARTS_AT in modules(package) else "housefly.pilot"
    walked = walk(start, package)
    rooms = [path for path in package.iterdir() if (path / "__init__.py").exists()]
    print(f"packages side by side   {len(rooms)}")
    print(f"loose modules           {len(list(package.glob('*.py'))) - 1}")
    print(f"public top-level names  {len(definitions)}")
    print(f"twice in a package      {len(twice)}  {', '.join(sorted(twice))}")
    print(f"lines over {LINE_MAX}          {len(long_lines(package.parents[1]))}")
    print(f"walk Sighting->Command  {len(walked)} modules, {sum(walked.values())} lines")


if __name__ == "__main__":
    main()
