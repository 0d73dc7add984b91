"""What every command of the command line is made of."""

from __future__ import annotations

from argparse import (
    Action,
    ArgumentError,
    ArgumentParser,
    HelpFormatter,
    Namespace,
    RawDescriptionHelpFormatter,
)
from argparse import _SubParsersAction as SubParsers  # what add_subparsers returns
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from housefly.config.text import did_you_mean, shortened


class SuggestingParser(ArgumentParser):
    """A parser that says what may have been meant, where something is not known."""

    def _check_value(self, action: Action, value: Any) -> None:
        """Raise ArgumentError for what is no choice of an argument."""
        if action.choices is None or value in action.choices:
            return
        known = [str(choice) for choice in action.choices]
        meant = did_you_mean(str(value), known)
        if not isinstance(action, SubParsers):
            meant = meant or f"; allowed: {', '.join(known)}"
            raise ArgumentError(action, f"is {shortened(str(value), 60)!r}{meant}")
        listed = f"`{self.prog} --help` lists all"
        self.error(f"no command {shortened(str(value), 60)!r}{meant or ';'} {listed}")

    def parse_args(  # type: ignore[override]
        self, args: Sequence[str] | None = None, namespace: None = None
    ) -> Namespace:
        """Return the arguments; exits with 2 where one is not known."""
        options, unknown = self.parse_known_args(args, namespace)
        if unknown:
            parser: ArgumentParser = getattr(options, "parser", self)
            known = [name for action in parser._actions for name in action.option_strings]
            first = unknown[0].partition("=")[0]
            meant = did_you_mean(first, known) if first.startswith("-") else ""
            parser.error(f"unknown argument {shortened(first, 60)!r}{meant}")
        return options


@dataclass(frozen=True, slots=True)
class Subcommand:
    """One command.

    Attributes:
        name: what people type.
        help: its line in the list of commands.
        add_arguments: declares its arguments.
        run: runs it and returns the exit code.
        description, epilog: what ``--help`` shows above and below the arguments.
    """

    name: str
    help: str
    add_arguments: Callable[[ArgumentParser], None]
    run: Callable[[Namespace], int]
    description: str = ""
    epilog: str = ""

    def add_to(self, commands: SubParsers[Any]) -> None:
        """Add the command to the parser; texts of several lines keep their line breaks."""
        is_formatted = "\n" in self.description or self.epilog
        parser = commands.add_parser(
            self.name,
            help=self.help,
            description=self.description or None,
            epilog=self.epilog or None,
            formatter_class=RawDescriptionHelpFormatter if is_formatted else HelpFormatter,
        )
        self.add_arguments(parser)
        parser.set_defaults(run=self.run, parser=parser)


@dataclass(frozen=True, slots=True)
class CommandGroup:
    """Commands below a common word, as ``housefly room show``.

    Attributes:
        name: the common word.
        help: its line in the list of commands.
        metavar: stands for the second word in ``--help``.
        commands: the commands by their second word.
        default: the second word of what runs without one; "" prints the help.
    """

    name: str
    help: str
    metavar: str
    commands: tuple[Subcommand, ...]
    default: str = ""

    def add_to(self, commands: SubParsers[Any]) -> None:
        """Add the commands of the group to the parser."""
        parser = commands.add_parser(self.name, help=self.help)
        inner = parser.add_subparsers(dest="action", metavar=self.metavar)
        parser.set_defaults(run=lambda _: self._without_second_word(parser, inner), parser=parser)
        for command in self.commands:
            command.add_to(inner)

    def _without_second_word(self, parser: ArgumentParser, inner: SubParsers[Any]) -> int:
        if not self.default:
            parser.print_help()
            return 2
        options = inner.choices[self.default].parse_args([])
        return int(options.run(options))
