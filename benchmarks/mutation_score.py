"""How many small wrong changes of the safety gate its tests notice: the mutation score.

    python benchmarks/mutation_score.py                 every tenth change, some minutes
    python benchmarks/mutation_score.py --every 1       all of them, hours on a core
    python benchmarks/mutation_score.py --only gate     of one file
    python benchmarks/mutation_score.py --show          what no test noticed so far

Each change is one of: a comparison moved by its boundary or turned round, plus for minus, times for
by, and for or, a number doubled, a truth turned round, the larger for the smaller, a statement left
out. What was tried is kept in a file; the same command goes on.
"""

from __future__ import annotations

import argparse
import ast
import copy
import importlib.abc
import importlib.util
import json
import os
import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType

import hypothesis  # noqa: F401 - once, for the processes of all changes
import numba
import pytest
import yaml  # noqa: F401

ROOT = Path(__file__).resolve().parents[1]
SAFETY, BEHAVIOR = "housefly.pilot.safety", "housefly.pilot.behavior"
RULES = ("tests/pilot/safety", "tests/pilot/test_faults.py")
PEOPLE = (
    "tests/pilot/behavior/test_collision_monitor.py",
    "tests/pilot/safety/test_words_and_numbers.py",
    "tests/pilot/test_obstacles.py",
    "tests/pilot/test_people.py",
)
MODULES = {
    **{
        f"{SAFETY}.{name}": RULES
        for name in (
            "gate", "rule", "rules", "fallbacks", "timers", "drone_rules", "motion_rules",
            "tracking_rules", "wind_rules", "observer", "energy", "inputs", "limits",
        )
    },
    f"{BEHAVIOR}.collision_monitor": PEOPLE,
}  # fmt: skip
LONGEST_S = 900
"""A change that keeps its tests busy for longer was noticed."""
OPERATORS: dict[type, tuple[type, ...]] = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div,),
    ast.Div: (ast.Mult,),
    ast.And: (ast.Or,),
    ast.Or: (ast.And,),
}
TURNED = {"min": "max", "max": "min", "any": "all", "all": "any"}


@dataclass(frozen=True)
class Mutant:
    """One change: the module, its number there, where it is, and what it does."""

    module: str
    number: int
    line: int
    words: str


def changed_nodes(node: ast.AST) -> Iterator[ast.AST]:
    """Yield what a node may be changed into."""
    match node:
        case ast.Compare(ops=[operator]):
            for other in OPERATORS.get(type(operator), ()):
                yield replaced(node, ops=[other()])
        case ast.BinOp(op=operator) | ast.BoolOp(op=operator):
            for other in OPERATORS.get(type(operator), ()):
                yield replaced(node, op=other())
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            yield operand
        case ast.Constant(value=bool(value)):
            yield ast.Constant(not value)
        case ast.Constant(value=int(value) | float(value)):
            yield ast.Constant(value * 2 or 1)
        case ast.Call(func=ast.Name(id=name)) if name in TURNED:
            yield replaced(node, func=ast.Name(TURNED[name], ast.Load()))
        case ast.Expr(value=ast.Call()) | ast.AugAssign():
            yield ast.Pass()


def replaced(node: ast.AST, **fields: object) -> ast.AST:
    """Return a copy of a node with other fields."""
    other = copy.deepcopy(node)
    for name, value in fields.items():
        setattr(other, name, value)
    return other


def changeable(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield the nodes that do something: no annotations, decorators or documentation."""
    skipped: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            parts: list[ast.AST | None] = [*node.decorator_list]
            if isinstance(node, ast.FunctionDef):
                parts += [node.returns, node.args]
            skipped.update(id(part) for whole in parts if whole for part in ast.walk(whole))
        elif isinstance(node, ast.AnnAssign):
            skipped.update(id(part) for part in ast.walk(node.annotation))
    yield from (node for node in ast.walk(tree) if id(node) not in skipped)


def mutants_of(module: str) -> list[tuple[Mutant, Callable[[], ast.Module]]]:
    """Return every change of a module with what makes the whole changed module."""
    tree = ast.parse(path_of(module).read_text("utf-8"))
    found: list[tuple[Mutant, Callable[[], ast.Module]]] = []
    for place, node in enumerate(list(changeable(tree))):
        for other in changed_nodes(node):
            line = getattr(node, "lineno", 0)
            words = f"{ast.unparse(node)} -> {ast.unparse(other)}"
            mutant = Mutant(module, len(found), line, " ".join(words.split())[:160])
            make = partial(with_node, tree, place, ast.copy_location(other, node))
            found.append((mutant, make))
    return found


def with_node(tree: ast.Module, place: int, other: ast.AST) -> ast.Module:
    """Return a copy of a module in which one node is another."""
    fresh = copy.deepcopy(tree)
    old = list(changeable(fresh))[place]
    for parent in ast.walk(fresh):
        for name, value in ast.iter_fields(parent):
            if value is old:
                setattr(parent, name, other)
            elif isinstance(value, list) and any(item is old for item in value):
                setattr(parent, name, [other if item is old else item for item in value])
    return ast.fix_missing_locations(fresh)


def path_of(module: str) -> Path:
    """Return the file of a module."""
    return ROOT / "src" / Path(*module.split(".")).with_suffix(".py")


class ChangedModule(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Imports one module as it was changed."""

    def __init__(self, name: str, tree: ast.Module) -> None:
        self._name, self._code = name, compile(tree, str(path_of(name)), "exec")

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return this finder for its module."""
        if name != self._name:
            return None
        return importlib.util.spec_from_file_location(name, path_of(name), loader=self)

    def exec_module(self, module: ModuleType) -> None:
        """Run the changed code."""
        exec(self._code, module.__dict__)


def is_noticed(mutant: Mutant, tree: ast.Module) -> bool:
    """Return whether a test fails, in a process of its own; it has all imports but ours."""
    child = os.fork()
    if not child:
        os.setpgid(0, 0)
        signal.alarm(LONGEST_S)
        silence = os.open(os.devnull, os.O_WRONLY)
        os.dup2(silence, 1)
        os.dup2(silence, 2)
        # What is compiled comes from a cache that knows the file, not the change.
        is_compiled = "@compiled" in path_of(mutant.module).read_text("utf-8")
        vars(numba.config)["DISABLE_JIT"] = is_compiled
        sys.meta_path.insert(0, ChangedModule(mutant.module, tree))
        options = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:randomly", "--no-header"]
        os._exit(int(pytest.main([*options, *MODULES[mutant.module]])) != 0)
    return os.waitpid(child, 0)[1] != 0


def main() -> int:
    """Try the changes that were not tried yet, and print the score."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--every", type=int, default=10, help="try every n-th change")
    parser.add_argument("--first", type=int, default=0, help="beginning with this one")
    parser.add_argument("--only", default="", help="modules whose names hold this")
    parser.add_argument("--out", type=Path, default=Path("mutants.jsonl"))
    parser.add_argument("--show", action="store_true", help="try nothing")
    options = parser.parse_args()
    os.chdir(ROOT)
    lines = options.out.read_text("utf-8").splitlines() if options.out.exists() else []
    tried = {(m["module"], m["words"], m["line"]): m["noticed"] for m in map(json.loads, lines)}
    mutants = [m for name in MODULES if options.only in name for m in mutants_of(name)]
    wanted = mutants[options.first :: options.every]
    for mutant, make in [] if options.show else wanted:
        key = (mutant.module, mutant.words, mutant.line)
        if key not in tried:
            tried[key] = is_noticed(mutant, make())
            with options.out.open("a", encoding="utf-8") as file:
                file.write(json.dumps({**mutant.__dict__, "noticed": tried[key]}) + "\n")
            mark = "noticed " if tried[key] else "SURVIVED"
            print(f"{mark} {mutant.module}:{mutant.line} {mutant.words}", file=sys.stderr)
    report([mutant for mutant, _ in mutants], tried)
    return 0


def report(mutants: list[Mutant], tried: dict[tuple[str, str, int], bool]) -> None:
    """Print the score of each module, and what no test noticed."""
    from _run import table  # imports the gate, which the changes must not find imported

    keys = {(m.module, m.words, m.line): m for m in mutants}
    known = [(m, tried[key]) for key, m in keys.items() if key in tried]
    rows = []
    for name in MODULES:
        own = [noticed for mutant, noticed in known if mutant.module == name]
        if own:
            there = sum(mutant.module == name for mutant in mutants)
            rows.append((name, there, len(own), sum(own), f"{100 * sum(own) / len(own):.0f} %"))
    noticed = sum(seen for _, seen in known)
    share = f"{100 * noticed / len(known):.1f} %" if known else "-"
    rows.append(("all", len(mutants), len(known), noticed, share))
    print("## Changes of the safety gate that its tests notice\n")
    print(table(["module", "changes", "tried", "noticed", "share"], rows))
    for mutant, seen in known:
        if not seen:
            print(f"\nNot noticed: {mutant.module}:{mutant.line} {mutant.words}")


if __name__ == "__main__":
    sys.exit(main())
