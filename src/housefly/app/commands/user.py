"""``housefly user``: who may log in to the console, and what each may do."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from getpass import getpass
from typing import TYPE_CHECKING

from housefly.app.commands.subcommand import CommandGroup, Subcommand
from housefly.app.terminal import console, new_table
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.web.access.users import UserBook

_ROLES = ("watch", "ask", "fly", "admin")


def _add_site(parser: ArgumentParser) -> None:
    parser.add_argument("--site", default="bsen", metavar="SITE", help="whose console")


def _add_name(parser: ArgumentParser) -> None:
    parser.add_argument("name", metavar="NAME")
    _add_site(parser)


def _add_user_arguments(parser: ArgumentParser) -> None:
    _add_name(parser)
    parser.add_argument("--role", required=True, choices=_ROLES, help="what NAME may do")


def _add(options: Namespace) -> int:
    from housefly.web.access.roles import Role

    book = _book(options.site)
    book.put(options.name, Role(options.role), _password(options.name))
    console.print(f"{options.name} may {options.role}", markup=False)
    return 0


def _set_role(options: Namespace) -> int:
    from housefly.web.access.roles import Role

    _book(options.site).set_role(options.name, Role(options.role))
    console.print(f"{options.name} may {options.role}", markup=False)
    return 0


def _remove(options: Namespace) -> int:
    _book(options.site).remove(options.name)
    console.print(f"{options.name} is out; open windows are closed within seconds", markup=False)
    return 0


def _list(options: Namespace) -> int:
    users = _book(options.site).all()
    table = new_table(("name", "role"))
    for user in users:
        table.add_row(user.name, user.role.value)
    console.print(table if users else "nobody yet: `housefly user add NAME --role fly`")
    return 0


def _book(site_name: str) -> UserBook:
    from housefly.config.state import users_file
    from housefly.sites.loaded_site import read_site
    from housefly.web.access.users import UserBook

    return UserBook(users_file(read_site(site_name)))


def _password(name: str) -> str:
    """Return a password: typed twice at a terminal, else the first line of the standard input."""
    if not sys.stdin.isatty():
        return sys.stdin.readline().rstrip("\n")
    first = getpass(f"password for {name}: ")
    if getpass("once more: ") != first:
        raise ConfigError("password", "was typed differently the second time; nothing is changed")
    return first


USER_COMMANDS = CommandGroup(
    name="user",
    help="say who may log in to the console from other machines, and what each may do",
    metavar="WHAT",
    default="list",
    commands=(
        Subcommand(
            name="add",
            help="let somebody in, or change a password",
            description=(
                "Let NAME in with a role: watch (see everything), ask (also ask where things are"
                " and for paths), fly (also take control), admin (also edit places and zones, and"
                " invite). Everybody may STOP and LAND. The password is asked for; without a"
                " terminal it is the first line of the standard input."
            ),
            add_arguments=_add_user_arguments,
            run=_add,
        ),
        Subcommand(
            name="role",
            help="give somebody another role",
            description="Give NAME another role; it counts at once, in open windows too.",
            add_arguments=_add_user_arguments,
            run=_set_role,
        ),
        Subcommand(
            name="remove",
            help="keep somebody out from now on",
            description="Take NAME out; his sessions are over at once.",
            add_arguments=_add_name,
            run=_remove,
        ),
        Subcommand(
            name="list",
            help="show who may log in",
            description="Show names and roles.",
            add_arguments=_add_site,
            run=_list,
        ),
    ),
)
