from __future__ import annotations

import pytest

from housefly.errors import ConfigError
from housefly.web.security import check_bind


@pytest.mark.parametrize("host", ["127.0.0.1", "127.9.9.9", "::1", "localhost"])
def test_loopback_is_always_allowed(host: str) -> None:
    check_bind(host, insecure=False)


@pytest.mark.parametrize("host", ["0.0.0.0", "::", "192.168.1.2", "housefly.local"])
def test_an_address_that_others_reach_must_be_asked_for(host: str) -> None:
    with pytest.raises(ConfigError, match="--insecure"):
        check_bind(host, insecure=False)
    check_bind(host, insecure=True)
