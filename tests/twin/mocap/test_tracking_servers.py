"""The twin poses as the tracking systems that its site asks for."""

from __future__ import annotations

from typing import get_args

from housefly.config.site import Site, changed
from housefly.config.tracking import MocapWire
from housefly.config.twin import TwinConfig
from housefly.twin.mocap.natnet_server import NatNetServer
from housefly.twin.mocap.tracking_servers import MAKERS, NATNET_VERSIONS, tracking_servers
from housefly.twin.mocap.vicon_server import ViconServer
from housefly.twin.mocap.vrpn_server import VrpnServer


def test_every_protocol_has_a_server() -> None:
    assert set(MAKERS) == set(get_args(MocapWire))
    assert set(NATNET_VERSIONS) == set(
        get_args(TwinConfig.model_fields["natnet_version"].annotation)
    )


def test_an_empty_site_serves_vicon_alone() -> None:
    assert [type(server) for server in tracking_servers(Site())] == [ViconServer]


def test_the_clients_protocol_comes_first_and_none_twice() -> None:
    site = changed(Site(), tracking__kind="vrpn", twin__mocap_wires=["natnet", "vrpn"])
    assert [type(server) for server in tracking_servers(site)] == [VrpnServer, NatNetServer]
