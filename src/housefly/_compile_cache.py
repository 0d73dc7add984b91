"""Keeps compiled functions on disk, each under a digest of all that its machine code depends on.

The compiler's own cache looks at a function's own file only, although callees are compiled into
their callers and module constants are frozen. Here the digest covers the function, every compiled
function that it reaches, the values of their constants, the types of the arguments, the processor
and the versions: an edit compiles what it changes and nothing else, wherever the sources lie and
whenever they were written.
"""

from __future__ import annotations

import os
import pickle
import platform
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from enum import Enum
from functools import cache
from hashlib import sha256
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

import llvmlite.binding
import numba
import numpy as np
from numba.core import config, types
from numba.core.caching import _Cache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps
from numba.core.sigutils import normalize_signature

_SWITCHES = (
    "OPT",
    "LOOP_VECTORIZE",
    "SLP_VECTORIZE",
    "BOUNDSCHECK",
    "DEBUGINFO_DEFAULT",
    "DISABLE_INTEL_SVML",
)
"""Settings of the compiler that change what it makes."""
_FORGOTTEN_AFTER = 7 * 86400.0
"""Compiled code that was not loaded for this long is thrown away at the next compilation [s]."""
_TOUCHED_AFTER = 86400.0
"""A file that is loaded gets a new date when its own is older than this [s]."""
_INNER = "for callers"
"""Names code that is not called from Python."""


class CompileCache(_Cache):
    """The compiled code of one function on disk, as the compiler's dispatcher asks for it."""

    def __init__(self, dispatcher: Any, folder: Path) -> None:
        self._dispatcher = dispatcher
        self._folder = folder
        self._enabled = True

    @property
    def cache_path(self) -> str:
        """Where the files are."""
        return str(self._folder)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the compiled code for these types of arguments; None when there is none."""
        target_context.refresh()
        payload = self._read(self._path(sig, target_context.codegen()))
        if payload is None:
            return None
        return CompileResult._rebuild(target_context, *payload)  # type: ignore[no-untyped-call]

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep what was compiled for these types; where nothing can be written it is not kept."""
        if data.lifted or data.library.has_dynamic_globals:
            return
        self._write(self._path(sig, data.codegen), data._reduce())

    def load_inner(self, args: tuple[Any, ...], target_context: Any) -> Any:
        """Return what ``save_inner`` kept for these types of arguments; None when there is none."""
        target_context.refresh()
        return self._read(self._path(args, target_context.codegen(), _INNER))

    def save_inner(self, args: tuple[Any, ...], codegen: Any, data: Any) -> None:
        """Keep the form for callers; where nothing can be written it is not kept."""
        self._write(self._path(args, codegen, _INNER), data)

    def enable(self) -> None:
        """Read and write from now on."""
        self._enabled = True

    def disable(self) -> None:
        """Neither read nor write from now on."""
        self._enabled = False

    def flush(self) -> None:
        """Throw away what is kept of this function."""
        for path in self._folder.glob(f"{self._name()}-*.nbc"):
            path.unlink(missing_ok=True)

    def _read(self, path: Path) -> Any:
        if not self._enabled:
            return None
        try:
            payload = pickle.loads(path.read_bytes())
            if time.time() - path.stat().st_mtime > _TOUCHED_AFTER:
                os.utime(path)
        except (OSError, EOFError, pickle.UnpicklingError):
            return None
        return payload

    def _write(self, path: Path, payload: Any) -> None:
        if not self._enabled:
            return
        part = path.with_name(f"{path.name}.{os.getpid()}.part")
        with suppress(OSError):
            _prepared(self._folder)
            part.write_bytes(dumps(payload))  # type: ignore[no-untyped-call]
            part.replace(path)

    def _name(self) -> str:
        function = self._dispatcher.py_func
        return f"{function.__module__}.{function.__qualname__}".replace("<", "").replace(">", "")

    def _path(self, sig: Any, codegen: Any, form: str = "") -> Path:
        arguments, _ = normalize_signature(sig)  # type: ignore[no-untyped-call]
        made_from = (made_by(), codegen.magic_tuple(), code_digest(self._dispatcher), form)
        text = repr((made_from, [_type_text(kind) for kind in arguments]))
        return self._folder / f"{self._name()}-{sha256(text.encode()).hexdigest()[:32]}.nbc"


@cache
def code_digest(dispatcher: Any) -> str:
    """Return a digest of a compiled function, of all that it reaches, and of their constants."""
    digest, known, waiting = sha256(), {dispatcher}, [dispatcher]
    while waiting:
        text, callees = _described(waiting.pop())
        digest.update(text.encode())
        new = [callee for callee in callees if callee not in known]
        known.update(new)
        waiting += new
    return digest.hexdigest()


@cache
def _described(dispatcher: Any) -> tuple[str, tuple[Any, ...]]:
    """Return what a function is, without what it calls, and what it calls."""
    function: FunctionType = dispatcher.py_func
    described = _Description()
    text = [
        f"{function.__module__}.{function.__qualname__}",
        repr(sorted((key, repr(value)) for key, value in dispatcher.targetoptions.items())),
        described.code(function.__code__, function.__doc__),
        described.value((function.__defaults__, function.__kwdefaults__)),
    ]
    names = frozenset(_names(function.__code__))
    for name in sorted(names & function.__globals__.keys()):
        text.append(f"{name}={described.value(function.__globals__[name], names)}")
    for name, cell in zip(function.__code__.co_freevars, function.__closure__ or (), strict=True):
        text.append(f"{name}={described.value(cell.cell_contents, names)}")
    return "\n".join(text), tuple(described.callees)


def _names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


class _Description:
    """Texts that differ when what the compiler sees differs; collects compiled functions."""

    def __init__(self) -> None:
        self.callees: list[Any] = []

    def code(self, code: CodeType, doc: str | None = None) -> str:
        """Describe bytecode without its place in the file and its docstring."""
        constants = [
            self.code(each) if isinstance(each, CodeType) else self.value(each)
            for each in code.co_consts
            if doc is None or each is not code.co_consts[0]
        ]
        shape = (code.co_argcount, code.co_kwonlyargcount, code.co_flags, code.co_exceptiontable)
        names = (code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars)
        return repr((code.co_name, shape, names, code.co_code.hex(), constants))

    def value(self, value: object, names: frozenset[str] = frozenset()) -> str:
        """Describe a constant; of a module what the function's names find in it."""
        if hasattr(value, "py_func"):
            self.callees.append(value)
            return f"compiled {value.py_func.__module__}.{value.py_func.__qualname__}"
        if isinstance(value, ModuleType):
            found = sorted(name for name in names if hasattr(value, name))
            members = [(name, self.value(getattr(value, name))) for name in found]
            return f"module {value.__name__} {members}"
        if isinstance(value, type):
            return _class_text(value)
        if isinstance(value, np.ndarray):
            return f"{value.dtype} {value.shape} {sha256(value.tobytes()).hexdigest()}"
        if isinstance(value, Enum):
            return f"{_class_text(type(value))}.{value.name}"
        if isinstance(value, tuple | list):
            return f"{_class_text(type(value))}{[self.value(each) for each in value]}"
        if isinstance(value, frozenset | set):
            return f"set{sorted(self.value(each) for each in value)}"
        if isinstance(value, dict):
            return f"dict{[(self.value(key), self.value(each)) for key, each in value.items()]}"
        if isinstance(value, bool | int | float | complex | str | bytes | np.generic | None):
            return f"{type(value).__name__} {value!r}"
        name = getattr(value, "__qualname__", None) or getattr(value, "__name__", None)
        return f"{type(value).__name__} {getattr(value, '__module__', '')}.{name}"


@cache
def _class_text(kind: type) -> str:
    """Describe a class by what compiled code can know of it: fields, defaults, members."""
    name = f"{kind.__module__}.{kind.__qualname__}"
    if issubclass(kind, Enum):
        return f"{name} {[(member.name, repr(member.value)) for member in kind]}"
    if issubclass(kind, tuple) and hasattr(kind, "_fields"):
        defaults = getattr(kind, "_field_defaults", {})
        return f"{name} {kind._fields} {sorted(defaults.items())!r}"
    return name


def _type_text(kind: Any) -> str:
    """Describe a type of the compiler, with the fields of every named tuple in it."""
    if isinstance(kind, types.Type):
        return str(kind) if isinstance(kind.key, str) else f"{kind}:{_type_text(kind.key)}"
    if isinstance(kind, tuple):
        return repr([_type_text(each) for each in kind])
    return _class_text(kind) if isinstance(kind, type) else repr(kind)


@cache
def made_by() -> str:
    """Return processor, versions and settings that the machine code depends on."""
    binding = llvmlite.binding
    processor = (binding.get_host_cpu_name(), binding.get_host_cpu_features().flatten())
    switches = tuple(getattr(config, name, None) for name in _SWITCHES)
    versions = (sys.implementation.cache_tag, numba.__version__, llvmlite.__version__)
    return repr((platform.machine(), processor, versions, np.__version__, switches))


@cache
def _prepared(folder: Path) -> None:
    """Make the folder, and throw away what was not used for long."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        with suppress(OSError):
            if time.time() - old.stat().st_mtime > _FORGOTTEN_AFTER:
                old.unlink()
