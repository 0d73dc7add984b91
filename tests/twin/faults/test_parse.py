"""Faults as people write them."""

from __future__ import annotations

from math import inf
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.app.commands.shared import load
from housefly.cli import build_parser
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.sites.loaded_site import read_site
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.fault_types import FAULT_TYPES
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.parse import faults_of, parse_fault
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind, FaultType

MOCAP, WRONG = FaultComponent.MOCAP, FaultKind.WRONG


def test_a_component_is_read_with_all_its_parts() -> None:
    assert parse_fault("mocap:wrong@20s+5s=0.3#9") == (
        Fault(MOCAP, WRONG, "position", 20.0, 5.0, 0.3, 9),
    )
    assert parse_fault("mocap.yaw:wrong=1.5") == (Fault(MOCAP, WRONG, "yaw", 0.0, inf, 1.5),)
    assert parse_fault("mocap:off@1.5+.25") == (Fault(MOCAP, FaultKind.OFF, "", 1.5, 0.25),)


def test_a_row_is_read_with_variant_and_times() -> None:
    assert [str(fault) for fault in parse_fault("F13/5cm@20s+10s#7")] == [
        "mocap.drift:wrong@20s+10s=0.05#7"
    ]
    assert [str(fault) for fault in parse_fault("F05/gap0.8s_0.4m@20")] == [
        "mocap:off@20s+0.8s",
        "mocap.position:wrong@20.8s=0.4#2",
    ]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("F99@2s", "there are F01 to F52"),
        ("F27@2s", "is no fault of the simulated room; it is covered by: tests/web"),
        ("F13/7cm", "it has F13/2cm, F13/5cm, F13/steps, F13/jumps_5cm, F13/up_5cm"),
        ("F13=0.3", "cannot be read"),
        ("cat:off", "'cat' is no component; known: mocap, telemetry"),
        ("mocap:melted", "known: ok, off, stuck, garbage, wrong, slow, delayed, intermittent"),
        ("mocap:wrong@x", "cannot be read"),
        ("motor:stuck", "motor can have: motor.front_left:wrong, motor.front_right:wrong"),
        ("motor:wrong=2", "motor.front_left:wrong is 2; allowed: 0 to 1"),
        ("mocap:slow=0", "allowed: 0.5 to 200 Hz"),
        ("mocap:off@1e400", "start is inf"),
        ("", "cannot be read"),
    ],
)
def test_what_cannot_be_is_refused_with_what_can(text: str, words: str) -> None:
    with pytest.raises(ConfigError, match=words) as caught:
        parse_fault(text)
    assert caught.value.key == "--fault"


@given(st.text(st.sampled_from("F0123456789@+=#s.:/mocapwrgff-e"), max_size=30))
def test_any_text_is_faults_or_a_config_error(text: str) -> None:
    try:
        assert parse_fault(text)
    except ConfigError as error:
        assert text in str(error) or repr(text) in str(error)


def test_the_faults_of_a_site_are_those_of_all_entries() -> None:
    site = changed(Site(), faults=[{"fault": "F14@5s"}, {"fault": "wind:wrong"}])
    assert [str(fault) for fault in faults_of(site).faults] == [
        "commands:intermittent@5s=0.3",
        "telemetry:intermittent@5s=0.3#2",
        "wind:wrong@0s",
    ]


def test_a_bad_entry_of_a_site_is_named() -> None:
    site = changed(Site(), faults=[{"fault": "F13@1s"}, {"fault": "cat:off"}])
    with pytest.raises(ConfigError) as caught:
        faults_of(site)
    assert caught.value.key == "faults.1.fault"


def scheduled(known: FaultType) -> str:
    """Return a fault as people write it, from 20 s to 25 s, with a seed."""
    return f"{known.name}@20s+5s{f'={known.default:g}' if known.unit else ''}#7"


def check_scheduled(site: Site, known: FaultType) -> None:
    """Check that a site has a fault of this type, and when, wherever it can be made."""
    for where in known.where:
        schedule = FaultInjector(site, where).schedule
        (fault,) = schedule.active(22.0)
        assert (fault.type, fault.seed) == (known, 7)
        assert fault.size == pytest.approx(known.default, rel=1e-5)
        assert schedule.active(19.9) == schedule.active(25.0) == ()


@pytest.mark.parametrize("known", FAULT_TYPES, ids=lambda known: known.name)
def test_every_fault_is_reached_by_site_file_and_by_command_line_for_its_time(
    known: FaultType, tmp_path: Path
) -> None:
    text, file = scheduled(known), tmp_path / "site.toml"
    file.write_text(f'[[faults]]\nfault = "{text}"\n')
    check_scheduled(read_site(file), known)
    file.write_text("")
    words = ["fly", "table", "--site", str(file), "--fault", text]
    check_scheduled(load(build_parser().parse_args(words)).site, known)


@pytest.mark.parametrize("known", FAULT_TYPES, ids=lambda known: known.name)
def test_no_fault_can_be_had_with_real_hardware(known: FaultType, tmp_path: Path) -> None:
    file = tmp_path / "site.toml"
    file.write_text(f'[twin]\nenabled = false\n[[faults]]\nfault = "{scheduled(known)}"\n')
    with pytest.raises(ConfigError, match="simulated room only"):
        read_site(file)
