"""A module of the console's client in node, called from here."""

from __future__ import annotations

import contextlib
import json
import shutil
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from housefly.web.access.page_routes import STATIC_FOLDER

CLIENT = STATIC_FOLDER.parent / "client"
_SERVE = """
import { createInterface } from "node:readline";
import * as module from "./module.mjs";
const call = new Function("module", "values", process.argv[2]);
for await (const line of createInterface({ input: process.stdin }))
  console.log(JSON.stringify(call(module, JSON.parse(line))));
"""


@contextlib.contextmanager
def called(sources: tuple[str, ...], body: str, folder: Path) -> Iterator[Callable[..., Any]]:
    """Yield what calls a function's body with `module` and `values`, and returns what it returns.

    `module` has all that some sources of the client export. Skips the test where node or the
    client's tools are not installed.
    """
    node, esbuild = shutil.which("node"), CLIENT / "node_modules" / "esbuild" / "bin" / "esbuild"
    if node is None or not esbuild.is_file():
        pytest.skip("the client's tools are not installed: npm ci in src/housefly/web/client")
    subprocess.run(
        [esbuild, "--bundle", "--format=esm", f"--outfile={folder / 'module.mjs'}"],
        input="".join(f'export * from "./src/{source}";' for source in sources),
        cwd=CLIENT,
        check=True,
        text=True,
        capture_output=True,
    )
    (folder / "serve.mjs").write_text(_SERVE, encoding="utf-8")
    with subprocess.Popen(
        [node, folder / "serve.mjs", body],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdin is not None and process.stdout is not None
        asked, answered = process.stdin, process.stdout

        def call(*values: Any) -> Any:
            asked.write(json.dumps(values) + "\n")
            asked.flush()
            return json.loads(answered.readline())

        yield call
        asked.close()
