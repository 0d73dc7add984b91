"""What the documents say is true: commands, files, functions, links and numbers are the code's."""

from __future__ import annotations

import argparse
import ast
import re
import shlex
from functools import cache
from operator import attrgetter
from pathlib import Path

import pytest
from acceptor_words import described

from housefly.cli import EPILOG, build_parser
from housefly.config.site import Site
from housefly.pilot.safety.rules import SAFETY_RULES

ROOT = Path(__file__).resolve().parents[1]
PAGES = sorted(
    [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "examples").glob("*.md")]
)
SCRIPTS = sorted((ROOT / "examples").glob("*.py"))
REFERENCE = re.compile(r"`([\w/.]+\.py)(?:::([\w.]+))?`")
COMMAND = re.compile(r"(?:^|\s)(?:\.venv/bin/)?housefly (?!import )(?=[a-z-])(.*)$")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
FUNCTIONS = ast.FunctionDef | ast.AsyncFunctionDef
NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


def name_of(path: Path) -> str:
    return str(path.relative_to(ROOT))


def code_of(text: str) -> list[str]:
    """Return the lines of code blocks and the code spans of a page."""
    blocks = re.findall(r"^```.*?\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
    prose = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    return [line for block in blocks for line in block.splitlines()] + re.findall(
        r"`([^`\n]+)`", prose
    )


def commands_in(path: Path) -> list[str]:
    text = path.read_text(encoding="utf-8")
    lines = text.splitlines() if path.suffix == ".py" else code_of(text)
    found = [match.group(1) for line in lines if (match := COMMAND.search(line))]
    return [re.sub(r"\s+#.*", "", command).strip() for command in found]


def all_commands() -> list[tuple[str, str]]:
    epilog = [
        (name, line.split("housefly ", 1)[1].split("  ")[0])
        for name in ("cli.py",)
        for line in EPILOG.splitlines()[1:]
    ]
    return [
        (name_of(path), command) for path in (*PAGES, *SCRIPTS) for command in commands_in(path)
    ] + epilog


@pytest.mark.parametrize(("page", "command"), all_commands())
def test_every_command_in_the_documents_is_one(
    page: str, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        options = build_parser().parse_args(shlex.split(command))
    except SystemExit as end:
        pytest.fail(f"{page}: housefly {command}: exit {end.code}: {capsys.readouterr().err}")
    assert isinstance(options, argparse.Namespace)


def test_the_documents_hold_commands_at_all() -> None:
    assert len(all_commands()) > 15


@cache
def names_in(path: Path) -> frozenset[str]:
    """Return the functions, classes, methods and constants that a file defines."""
    names: set[str] = set()
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, FUNCTIONS | ast.ClassDef):
            names.add(node.name)
        if isinstance(node, ast.ClassDef):
            names |= {
                f"{node.name}.{item.name}" for item in node.body if isinstance(item, FUNCTIONS)
            }
        if isinstance(node, ast.Assign | ast.AnnAssign):
            names |= {
                item.id
                for item in ast.walk(node)
                if isinstance(item, ast.Name) and isinstance(item.ctx, ast.Store)
            }
    return frozenset(names)


def file_of(reference: str) -> Path | None:
    """Return the file of a reference, relative to the root, src/housefly, tests or examples."""
    folders = (ROOT, ROOT / "src" / "housefly", ROOT / "tests", ROOT / "examples")
    return next((folder / reference for folder in folders if (folder / reference).is_file()), None)


def all_references() -> list[tuple[str, str, str]]:
    found = {
        (page, *match.groups(default=""))
        for page in PAGES
        for match in REFERENCE.finditer(page.read_text(encoding="utf-8"))
    }
    return sorted((name_of(page), file, name) for page, file, name in found)


@pytest.mark.parametrize(("page", "file", "name"), all_references())
def test_every_file_function_and_test_that_is_named_exists(page: str, file: str, name: str) -> None:
    path = file_of(file)
    assert path is not None, f"{page}: there is no {file}"
    assert not name or name in names_in(path), f"{page}: {file} has no {name}"


def test_every_equation_and_trap_has_a_test() -> None:
    paper = (ROOT / "docs" / "paper.md").read_text(encoding="utf-8")
    rows = re.findall(
        r"^\| ([^|]+) \|.*`[\w/]*test_\w+\.py::test_\w+` \|$", paper, flags=re.MULTILINE
    )
    assert [int(row) for row in rows if row.isdigit()] == list(range(1, 21))
    ranges = [
        (int(first), int(last or first))
        for row in rows
        for first, last in re.findall(r"\((\d+)\)(?:-\((\d+)\))?", row)
    ]
    assert {number for first, last in ranges for number in range(first, last + 1)} >= set(
        range(1, 26)
    )


def test_the_acceptor_is_described_as_it_is() -> None:
    assert described() in (ROOT / "docs" / "paper.md").read_text(encoding="utf-8")


def test_every_rule_of_the_last_gate_is_explained() -> None:
    safety = (ROOT / "docs" / "safety.md").read_text(encoding="utf-8")
    assert re.findall(r"^\| `(\w+)` \|", safety, flags=re.MULTILINE) == [
        rule.code for rule in SAFETY_RULES
    ]


def stated_values() -> list[tuple[str, str, str]]:
    """Return page, key and text of every table row that gives configuration keys or constants and
    then a number.
    """
    rows = []
    for page in PAGES:
        if page.name == "site.md":
            continue  # made from the code
        for line in page.read_text(encoding="utf-8").splitlines():
            for keys, value in re.findall(r"\| ((?:`[\w/.:]+`(?:, )?)+) \| ([^|`]*)", line):
                names = re.findall(r"`([^`]+)`", keys)
                if NUMBER.match(value) and all(constant_of(name) is not None for name in names):
                    rows.append((name_of(page), keys, value))
    return rows


def constant_of(name: str) -> float | None:
    """Return the number that a key of the site file has by default, or a constant of its airframe
    (``drone.airframe.brake.gain``) or of a module.
    """
    if re.fullmatch(r"\w+(\.\w+)+", name) and name.partition(".")[0] in Site.model_fields:
        value = attrgetter(name)(Site())
        return float(value) if isinstance(value, int | float) else None
    file, _, constant = name.partition("::")
    path = file_of(file) if constant else None
    for node in ast.parse(path.read_text(encoding="utf-8")).body if path else []:
        if isinstance(node, ast.Assign) and [ast.unparse(target) for target in node.targets] == [
            constant
        ]:
            return (
                float(ast.literal_eval(node.value))
                if isinstance(node.value, ast.Constant)
                else None
            )
    return None


@pytest.mark.parametrize(("page", "keys", "value"), stated_values())
def test_every_number_in_a_table_is_the_codes(page: str, keys: str, value: str) -> None:
    names = re.findall(r"`([^`]+)`", keys)
    stated = [float(number) for number in NUMBER.findall(value)[: len(names)]]
    assert stated == [constant_of(name) for name in names], f"{page}: {keys} | {value}"


def test_the_tables_state_numbers_at_all() -> None:
    assert len(stated_values()) > 20


@pytest.mark.parametrize(
    ("page", "target"),
    [
        (name_of(page), target)
        for page in PAGES
        for target in LINK.findall(page.read_text(encoding="utf-8"))
    ],
)
def test_every_relative_link_leads_somewhere(page: str, target: str) -> None:
    if "://" in target or target.startswith("#"):
        return
    assert ((ROOT / page).parent / target.partition("#")[0]).exists(), f"{page} links to {target}"
