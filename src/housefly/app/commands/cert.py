"""``housefly cert``: the certificate with which other machines may reach the console."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console


def _add_arguments(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--site", default="bsen", metavar="SITE", help="for the console of this site"
    )
    parser.add_argument(
        "--name",
        action="append",
        default=[],
        metavar="HOST",
        help="a further host name or IP address of this machine; may be repeated",
    )
    parser.add_argument(
        "--out", metavar="DIR", help="folder of the files (default: beside the room's memory)"
    )


def _run(options: Namespace) -> int:
    from housefly.app.certificates import make_certificate
    from housefly.app.loaded_site import read_site
    from housefly.app.own_names import own_names
    from housefly.config.state import edits_folder

    site = read_site(options.site)
    folder = Path(options.out) if options.out else edits_folder(site).with_name("tls")
    names = (*own_names(), *options.name)
    files, is_new = make_certificate(folder.absolute(), names)
    console.print(f"a certificate for {', '.join(dict.fromkeys(names))}", markup=False)
    console.print(
        "\nIn the site file:\n\n"
        "[web]\n"
        f'host = "0.0.0.0"            # or one address of this machine\n'
        f'tls_certificate = "{files.certificate}"\n'
        f'tls_key = "{files.key}"\n',
        markup=False,
        soft_wrap=True,
    )
    console.print("Then `housefly user add NAME --role fly` for everybody who may come in.")
    if is_new:
        console.print(
            f"Every browser must be told once to trust {files.authority}, which is no secret: copy"
            " it there and import it under the browser's certificates, as an authority for web"
            " sites. The other three files stay here.",
            markup=False,
            soft_wrap=True,
        )
    else:
        console.print("The authority is the one of last time: browsers that trust it go on.")
    return 0


CERT_COMMAND = Subcommand(
    name="cert",
    help="make the certificate that lets other machines reach the console",
    description=(
        "Make a certification authority for this machine, unless there is one, and a certificate"
        " for all its names and addresses; print the lines for the site file. Run it again when an"
        " address changes, or after two years."
    ),
    add_arguments=_add_arguments,
    run=_run,
)
