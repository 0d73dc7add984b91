"""Compiles a numeric function once for its callers, and once more where Python calls it.

The compiler's own way makes machine code, and an entry for Python, of every function that it meets.
Here a function that only compiled code calls stays an intermediate form, which is put into its
callers: machine code is made of what Python calls, and of nothing else.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import llvmlite.binding
import numba.core.codegen
import numba.core.compiler
import numba.core.registry
import numba.core.typing
from numba.core.compiler_lock import global_compiler_lock

_compiler: Any = numba.core.compiler
_typing: Any = numba.core.typing
_Dispatcher: Any = numba.core.registry.CPUDispatcher
_Library: Any = numba.core.codegen.JITCodeLibrary
"""The compiler's inner parts have no types."""


def tell_each(listener: Callable[[str], object] | None) -> None:
    """Have the name of each function told when its compilation begins; None: no more."""
    _listeners[:] = [listener] if listener else []


_listeners: list[Callable[[str], object]] = []


class CompiledFunction(_Dispatcher):  # type: ignore[misc]
    """A numeric function, compiled when it is first called with arguments of a kind."""

    def __init__(self, py_func: Any, **options: Any) -> None:
        super().__init__(py_func, **options)
        self._inner: dict[tuple[Any, ...], _Inner] = {}

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """Return what the compiler of a caller must know of a call with these types."""
        signature, folded = self._compiler.fold_argument_types(args, kws)
        self._compile_inner(tuple(folded))
        name = self.py_func.__name__
        signatures = [each.signature for each in self._inner.values()]
        template = _typing.make_concrete_template(f"CallTemplate({name})", name, signatures)
        return template, signature, folded, {}

    def get_overload(self, sig: Any) -> Any:
        """Return the key under which the compiler of a caller finds the code for these types."""
        return self._inner[tuple(sig)]

    def add_overload(self, cres: Any) -> None:
        """Take what was compiled for Python, and let it find the constants of its callees."""
        super().add_overload(cres)
        if cres.metadata is not None:
            for each in cres._find_referenced_environments():
                cres.library.codegen.set_env(each.env_name, each)

    def _compile_inner(self, args: tuple[Any, ...]) -> None:
        with global_compiler_lock, self._compiling_counter:
            if args in self._inner:
                return
            codegen = self.targetctx.codegen()
            kept = self._cache.load_inner(args, self.targetctx)
            inner = _rebuilt(codegen, kept) if kept else self._compiled_inner(args)
            self.targetctx.insert_user_function(inner, inner.description, [inner.library])
            self._inner[args] = inner
            if not kept and not inner.library.has_dynamic_globals:
                self._cache.save_inner(args, codegen, _reduced(inner))

    def _compiled_inner(self, args: tuple[Any, ...]) -> _Inner:
        for listener in _listeners:
            listener(f"{self.py_func.__module__}.{self.py_func.__name__}")
        flags = _compiler.Flags()
        self.targetdescr.options.parse_as_flags(flags, self.targetoptions)
        flags.no_compile = flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True
        library = _InnerLibrary(self.targetctx.codegen(), self.py_func.__qualname__)
        made = _compiler.compile_extra(
            self.typingctx, self.targetctx, self.py_func, args, None, flags, self.locals, library
        )
        library.finalize()
        environments = (made.environment, *made._find_referenced_environments())
        made.fndesc.typemap = made.fndesc.calltypes = None
        return _Inner(library, made.fndesc, made.signature, environments, tuple(made.reload_init))


class _InnerLibrary(_Library):  # type: ignore[misc]
    """Code for callers: no machine code is made of it, and nothing of it is loaded."""

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._verify_declare_only_symbols()
        self._finalized = True


@dataclass(frozen=True, eq=False)
class _Inner:
    """A function as its callers take it."""

    library: Any
    description: Any
    signature: Any
    environments: tuple[Any, ...]
    reload_init: tuple[Any, ...]


def _reduced(inner: _Inner) -> tuple[Any, ...]:
    bitcode = inner.library._get_module_for_linking().as_bitcode()
    rest = (inner.description, inner.signature, inner.environments, inner.reload_init)
    return (inner.library.name, bitcode, *rest)


def _rebuilt(codegen: Any, kept: tuple[Any, ...]) -> _Inner:
    name, bitcode, *rest = kept
    inner = _Inner(_InnerLibrary(codegen, name), *rest)
    for initialize in inner.reload_init:
        initialize()
    inner.library._final_module = llvmlite.binding.parse_bitcode(bitcode)
    inner.library._finalize_final_module()
    return inner
