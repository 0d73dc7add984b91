"""Names the modules that ship although no user reaches them: ``python scripts/reach.py``.

A user enters by the command ``housefly``, by ``import housefly``, or by a ``python -m`` that the
documents or the set-up name. From there it goes on by imports, and by quoted names of modules:
those are started as processes.
"""

from __future__ import annotations

import re
import sys
import tomllib

import grimp

from house import ROOT, modules

DOCUMENTS = ("README.md", "docs/*.md", "scripts/set-up")
_RUN = re.compile(r"-m\W+(housefly(?:\.\w+)*)")
_QUOTED = re.compile(r'"(housefly(?:\.\w+)+)"')


def import_graph() -> grimp.ImportGraph:
    """Return who imports whom in the package."""
    return grimp.build_graph("housefly", cache_dir=None)


def entries() -> set[str]:
    """Return the modules at which users enter."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    commands = {target.partition(":")[0] for target in project["scripts"].values()}
    texts = [page.read_text(encoding="utf-8") for name in DOCUMENTS for page in ROOT.glob(name)]
    named = {module for text in texts for module in _RUN.findall(text)}
    return {"housefly", "housefly.__main__"} | commands | named


def unreached(graph: grimp.ImportGraph) -> list[str]:
    """Return the modules of the graph that are reached from no entry, in order."""
    paths, seen, waiting = modules(), set[str](), entries() & graph.modules
    while waiting:
        name = waiting.pop()
        seen.add(name)
        started = set(_QUOTED.findall(paths[name].read_text(encoding="utf-8")))
        package = {name.rpartition(".")[0]}
        found = graph.find_modules_directly_imported_by(name) | started | package
        waiting |= (found & graph.modules) - seen
    return sorted(graph.modules - seen)


if __name__ == "__main__":
    print("\n".join(left := unreached(import_graph())))
    sys.exit(bool(left))
