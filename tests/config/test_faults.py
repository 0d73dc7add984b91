"""Faults in a site file."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.faults import FaultConfig
from housefly.config.site import Site, changed, site_from_file
from housefly.errors import ConfigError


def test_a_site_file_names_its_faults(tmp_path: Path) -> None:
    file = tmp_path / "site.toml"
    file.write_text('[[faults]]\nfault = "F13@20s"\n[[faults]]\nfault = "mocap:wrong=0.3"\n')
    assert [entry.fault for entry in site_from_file(file).faults] == ["F13@20s", "mocap:wrong=0.3"]


def test_faults_are_refused_with_real_hardware() -> None:
    with pytest.raises(ConfigError, match="simulated room only"):
        changed(Site(), twin__enabled=False, faults=[{"fault": "F13@20s"}])


def test_real_hardware_without_faults_is_a_site() -> None:
    assert changed(Site(), twin__enabled=False).faults == ()


@given(st.text(max_size=90))
def test_any_text_is_a_fault_or_refused_with_an_example(text: str) -> None:
    try:
        changed(Site(), faults=[{"fault": text}])
    except ConfigError as error:
        assert error.key.startswith("faults.0")
    else:
        assert FaultConfig(fault=text).fault == text
