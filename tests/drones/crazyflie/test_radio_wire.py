"""A drone's address leads over UDP or over the USB radio; what is missing is said in words."""

from __future__ import annotations

from importlib.util import find_spec

import pytest

from housefly.cli import main
from housefly.clock import RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.drones.crazyflie.driver import Crazyflie
from housefly.drones.crazyflie.radio_wire import is_for_radio
from housefly.errors import ConfigError, MissingPartError

RADIO = "radio://0/80/2M/E7E7E7E7E7"
without_cflib = pytest.mark.skipif(find_spec("cflib") is not None, reason="cflib is installed")


@pytest.mark.parametrize(
    "address", [RADIO, "radio://0/80/2M", "radio://1/125/250K/E7E7E7E701", "radio://9f3c/0/1M"]
)
def test_an_address_of_a_radio_leads_over_it(address: str) -> None:
    assert is_for_radio(address)


@pytest.mark.parametrize("address", ["192.168.4.20", "::1", "esp-drone.local"])
def test_any_other_leads_over_udp(address: str) -> None:
    assert not is_for_radio(address)


@pytest.mark.parametrize(
    "address", ["radio://", "radio://0/126/2M", "radio://0/80/3M", "radio://0/80/2M/xyz", "usb://0"]
)
def test_a_wrong_one_is_refused_with_what_is_allowed(address: str) -> None:
    with pytest.raises(ConfigError, match="radio://0/80/2M/E7E7E7E7E7"):
        is_for_radio(address)


@without_cflib
async def test_without_cflib_the_driver_says_what_installs_it_and_stays_well() -> None:
    config = DroneConfig(kind="crazyflie", address=RADIO)
    driver = Crazyflie(config, LimitsConfig(), RealClock())
    with pytest.raises(MissingPartError, match=r"pip install 'housefly\[crazyradio\]'"):
        await driver.connect()
    assert "housefly[crazyradio]" in driver.problem and not driver.connected
    await driver.close()


@without_cflib
def test_the_doctor_says_it_too(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["doctor", "--drone", f"crazyflie://{RADIO}"]) == 1
    assert "housefly[crazyradio]" in " ".join(capsys.readouterr().out.split())
