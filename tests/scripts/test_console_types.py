"""The TypeScript types are those of the messages, and others can compile with them."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from console_types import generated_files

from housefly.web.access.page_routes import STATIC_FOLDER


@pytest.mark.parametrize("path", generated_files(), ids=lambda path: str(path.name))
def test_the_typescript_types_are_current(path: Path) -> None:
    assert path.read_text(encoding="utf-8") == generated_files()[path], (
        "run: python scripts/console_types.py"
    )


PROGRAM = """\
import type { AnswerTo, RoomNews, ServerMessage, TaskQuestion, WhereQuestion } from "./housefly";

const question: WhereQuestion = { ask: "where", thing: "cup" };
async function ask(): Promise<AnswerTo["where"]> {
  return (await fetch(`/api/v1/where/${question.thing}`)).json();
}
const look: TaskQuestion = { ask: "request", service: "look", parameters: { subject: "sofa" } };
export const told = (news: RoomNews): string[] => news.events.map((event) => event.thing);
export const charge = (message: ServerMessage): number =>
  message.type === "state" ? (message.battery ?? 0) : 0;
export const where = ask().then(({ position }) => position?.[2].toFixed(2));
// @ts-expect-error a question without its thing
const wrong: WhereQuestion = { ask: "where" };
// @ts-expect-error there is no such question
const other: TaskQuestion = { ask: "dance" };
export const all = [look, wrong, other];
"""


def test_a_program_of_others_compiles_with_the_types(tmp_path: Path) -> None:
    client = STATIC_FOLDER.parent / "client"
    node, compiler = shutil.which("node"), client / "node_modules" / "typescript" / "bin" / "tsc"
    if node is None or not compiler.is_file():
        pytest.skip("the client's tools are not installed: npm ci in src/housefly/web/client")
    shutil.copy(STATIC_FOLDER / "housefly.d.ts", tmp_path)
    program = tmp_path / "program.ts"
    program.write_text(PROGRAM, encoding="utf-8")
    options = ("--noEmit", "--strict", "--target", "es2022", "--lib", "es2022,dom")
    command = [node, str(compiler), *options, str(program)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
