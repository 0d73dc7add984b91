"""Arguments that several commands have, and the site that they name."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING, Any

from housefly.app.mosquitto import find_mosquitto
from housefly.app.terminal import console
from housefly.errors import ConfigError
from housefly.twin.demo_site import demo_site

if TYPE_CHECKING:
    from housefly.config.site import Site
    from housefly.sites.loaded_site import LoadedSite


def add_site_arguments(parser: ArgumentParser) -> None:
    """Add ``--site`` and ``--mode``."""
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="site file, folder, or shipped site (default: bsen)",
    )
    parser.add_argument(
        "--mode", choices=("default", "paper"), help="fly the paper's own chain, or the mended one"
    )


def add_console_arguments(parser: ArgumentParser) -> None:
    """Add ``--port``, ``--lan`` and ``--record``."""
    parser.add_argument("--port", type=int, help="port of the console (default: the site's, 8080)")
    parser.add_argument(
        "--lan",
        action="store_true",
        help="let phones and other machines in, over TLS (`housefly cert` first); prints a QR code",
    )
    parser.add_argument(
        "--record", metavar="DIR", help="record everything that is flown into this folder"
    )


def add_simulation_arguments(parser: ArgumentParser) -> None:
    """Add ``--seed`` and ``--mocap-rate``."""
    parser.add_argument("--seed", type=int, help="seed of all simulated noise")
    parser.add_argument(
        "--mocap-rate",
        type=float,
        metavar="HZ",
        help="frames per second of the simulated tracking (default: 100)",
    )


def add_fault_argument(parser: ArgumentParser) -> None:
    """Add ``--fault``."""
    parser.add_argument(
        "--fault",
        action="append",
        default=[],
        metavar="FAULT",
        help=(
            "make something fail in the simulated room: F13@20s, mocap:wrong@20s+5s=0.3"
            " (docs/faults.md); repeatable"
        ),
    )


def add_drone_argument(parser: ArgumentParser) -> None:
    """Add ``--drone``."""
    parser.add_argument(
        "--drone", metavar="NAME", help="which drone of the site (default: the only one)"
    )


def load_drone(options: Namespace, *, with_edits: bool = False) -> LoadedSite:
    """Load the site as the drone has it that the options name; see ``load``."""
    loaded = load(options, with_edits=with_edits)
    return loaded.for_drone(chosen_drone(loaded.site, options))


def chosen_drone(site: Site, options: Namespace) -> str:
    """Return the drone that the options name, or the only one.

    Raises:
        ConfigError: the site has none that is flown, or several and none is named.
    """
    require_drone(site)
    names: tuple[str, ...] = site.drone_names
    if options.drone is None and len(names) == 1:
        return names[0]
    if options.drone not in names:
        is_not = "is needed" if options.drone is None else f"is {options.drone!r}"
        raise ConfigError("--drone", f"{is_not}; allowed: {', '.join(names)}")
    return str(options.drone)


def require_drone(site: Site) -> None:
    """Raise ConfigError for a site without a drone: this command flies, or looks at one."""
    if not site.drone_names:
        words = "is false: this room has no drone; set it to true to fly one"
        raise ConfigError("drone.enabled", words)


def add_instance_argument(parser: ArgumentParser, which: str = "which room: ") -> None:
    """Add ``--instance``."""
    parser.add_argument(
        "--instance",
        type=int,
        metavar="N",
        help=f"{which}2 and up run beside the first, with ports and a memory of their own",
    )


def given(changes: dict[str, Any]) -> dict[str, Any]:
    """Return the changes of a site that the options ask for: those that are not None."""
    return {key: value for key, value in changes.items() if value is not None}


def load(options: Namespace, *, with_edits: bool = False) -> LoadedSite:
    """Load the site that the options name, optionally with the newest edits of the ROOM screen."""
    from housefly.config.site import changed
    from housefly.sites.loaded_site import open_site, read_site, with_newest_edits

    changes: dict[str, Any] = {
        "mode": options.mode,
        "drone__kind": getattr(options, "model", None),
        "web__port": getattr(options, "port", None),
        "twin__seed": getattr(options, "seed", None),
        "twin__mocap_rate_hz": getattr(options, "mocap_rate", None),
        "drone__enabled": False if getattr(options, "memory", False) else None,
    }
    site = read_site(options.site, **given(changes))
    if getattr(options, "lan", False):
        from housefly.app.lan import lan_site

        site, words = lan_site(site, options.site)
        if words:
            console.print(f"tls:      {words}", markup=False, soft_wrap=True)
    if getattr(options, "lively", False):
        site, words = demo_site(site, find_mosquitto() is not None)
        console.print(f"lively:   {words}", markup=False, soft_wrap=True)
    if (instance := getattr(options, "instance", None)) is not None:
        from housefly.app.instance import site_of_instance

        site = site_of_instance(site, instance)
        site = changed(site, **given({"web__port": changes["web__port"]}))
    if faults := _parsed_faults(getattr(options, "fault", [])):
        site = changed(site, faults=[*site.model_dump()["faults"], *faults])
    if with_edits:
        site, words = with_newest_edits(site)
        if words:
            console.print(f"map:      {words}", markup=False)
    return open_site(site)


def _parsed_faults(texts: list[str]) -> list[dict[str, str]]:
    """Return the faults of the command line as a site has them; raises ConfigError."""
    from housefly.twin.faults.parse import parse_fault

    for text in texts:
        parse_fault(text)
    return [{"fault": text.strip()} for text in texts]
