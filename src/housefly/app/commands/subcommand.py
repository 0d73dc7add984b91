"""What every command of the command line is made of."""

from __future__ import annotations

from argparse import ArgumentParser, HelpFormatter, Namespace, RawDescriptionHelpFormatter
from argparse import _SubParsersAction as SubParsers  # what add_subparsers returns
from collections.abc import Callable
from dataclasses import dataclass


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

    def add_to(self, commands: SubParsers[ArgumentParser]) -> None:
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
        parser.set_defaults(run=self.run)


@dataclass(frozen=True, slots=True)
class CommandGroup:
    """Commands below a common word, as ``housefly room show``.

    Attributes:
        name: the common word.
        help: its line in the list of commands.
        metavar: stands for the second word in ``--help``.
        commands: the commands by their second word.
    """

    name: str
    help: str
    metavar: str
    commands: tuple[Subcommand, ...]

    def add_to(self, commands: SubParsers[ArgumentParser]) -> None:
        """Add the commands of the group to the parser."""
        parser = commands.add_parser(self.name, help=self.help)
        inner = parser.add_subparsers(dest="action", metavar=self.metavar, required=True)
        for command in self.commands:
            command.add_to(inner)
