"""Reads TOML files; says in words why one cannot be read."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

from housefly.config.text import read_text_file, shortened
from housefly.errors import ConfigError


def read_toml(path: Path, what: str) -> dict[str, Any]:
    """Return the content of a TOML file, or of a JSON file when its name ends in ``.json``.

    Args:
        path: the file.
        what: what people call the file; the key of the error.

    Raises:
        ConfigError: the file cannot be read or parsed.
    """
    try:
        text = read_text_file(path)
        if path.suffix == ".json":
            tree = json.loads(text)
            if not isinstance(tree, dict):
                raise ConfigError(
                    what, "cannot be parsed: it is no table of keys", shortened(str(path))
                )
            return tree
    except OSError as error:
        raise ConfigError(
            what, f"cannot be read ({error.strerror})", shortened(str(path))
        ) from error
    except (ValueError, RecursionError) as error:
        raise ConfigError(what, f"cannot be parsed: {error}", shortened(str(path))) from error
    return parse_toml(text, what, str(path))


def parse_toml(
    text: str, what: str, source: str = "", problem: str = "cannot be parsed"
) -> dict[str, Any]:
    """Return the content of a TOML text.

    Args:
        text: the TOML.
        what: what people call the file; the key of the error.
        source: path of the file, "" when the text comes from none.
        problem: how the error's sentence begins.

    Raises:
        ConfigError: the text is not TOML.
    """
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise ConfigError(what, f"{problem}: {error}", source) from error
