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
    from housefly.app.certificates import fingerprint, make_certificate
    from housefly.config.state import tls_folder
    from housefly.sites.loaded_site import read_site
    from housefly.web.access.own_names import own_names

    site = read_site(options.site)
    folder = Path(options.out) if options.out else tls_folder(site)
    names = (*own_names(), *options.name)
    files, is_new = make_certificate(folder.absolute(), names)
    console.print(f"a certificate for {', '.join(dict.fromkeys(names))}", markup=False)
    if is_new:
        print_how_to_trust(files.authority, fingerprint(files.authority))
    else:
        console.print("The authority is the one of last time: who trusts it goes on.")
    if not options.out:
        command = "housefly run --lan"
        command += f" --site {options.site}" if options.site != "bsen" else ""
        console.print(f"\nNow `{command}` lets others in; it prints a QR code.", markup=False)
    console.print(
        "\nOr for good, in the site file:\n\n"
        "[web]\n"
        'host = "0.0.0.0"            # or one address of this machine\n'
        f'tls_certificate = "{files.certificate}"\n'
        f'tls_key = "{files.key}"\n',
        markup=False,
        soft_wrap=True,
    )
    console.print("`housefly user add NAME --role fly` lets somebody come in by name as well.")
    return 0


def print_how_to_trust(authority: Path, fingerprint: str) -> None:
    """Print how browsers and phones are told, once, whom to trust."""
    for words in (
        f"\nEach phone and browser is told once to trust {authority}, which is no secret (the"
        " other three files stay here):",
        "- a phone opens https://ADDRESS-OF-THIS-MACHINE:8080/authority.crt while Housefly runs,"
        " says yes to the warning once, and gets the file;",
        "- Android: Settings, search for `CA certificate`, install it from the downloads;",
        "- iPhone: Settings, Profile downloaded, Install; then General, About, Certificate Trust"
        " Settings, switch it on;",
        "- a computer: import it under the browser's certificates, as an authority for web sites.",
        f"Compare before you say yes; its SHA-256 fingerprint is\n  {fingerprint}",
    ):
        console.print(words, markup=False, soft_wrap=True)


CERT_COMMAND = Subcommand(
    name="cert",
    help="make the certificate that lets other machines reach the console",
    description=(
        "Make a certification authority for this machine, unless there is one, and a certificate"
        " for all its names and addresses; say how a phone comes to trust it. `housefly run --lan`"
        " makes it anew when an address has changed or it runs out; phones trust it as before."
    ),
    add_arguments=_add_arguments,
    run=_run,
)
