"""The live view is off, and for this machine alone."""

from __future__ import annotations

from ipaddress import ip_address

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.errors import ConfigError


def test_nothing_listens_unless_the_site_asks_for_it() -> None:
    assert not Site().foxglove.enabled


@given(st.ip_addresses().filter(lambda address: not address.is_loopback))
def test_an_address_that_others_reach_is_refused(address: object) -> None:
    with pytest.raises(ConfigError, match=r"foxglove\.host.*loopback"):
        changed(Site(), foxglove__host=str(address))


@given(st.ip_addresses(network="127.0.0.0/8"))
def test_any_loopback_address_will_do(address: object) -> None:
    assert ip_address(changed(Site(), foxglove__host=str(address)).foxglove.host).is_loopback


@pytest.mark.parametrize("host", ["", "example.org", "0.0.0.0", "::"])
def test_a_name_that_may_be_anywhere_is_refused(host: str) -> None:
    with pytest.raises(ConfigError, match=r"foxglove\.host"):
        changed(Site(), foxglove__host=host)
