"""The encrypted console: what it is to a client, to a listener, and to who only holds it busy."""

from __future__ import annotations

import asyncio
import contextlib
import os
import socket
import ssl
import subprocess
import sys
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from typing import Any

import pytest
import pytest_asyncio
from held_lines import is_open
from playwright.async_api import Browser, expect
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus

from housefly.app.certificates import CertificateFiles, make_certificate
from housefly.web.access.roles import Role
from housefly.web.access.users import UserBook
from housefly.web.http import handshakes
from housefly.web.http.handshakes import MAX_HANDSHAKES

pytestmark = [pytest.mark.wire, pytest.mark.asyncio(loop_scope="session")]
PASSWORD = "correct horse battery"


@pytest.fixture
def files(tmp_path: Path, loopback: str) -> CertificateFiles:
    return make_certificate(tmp_path / "tls", ["localhost", loopback])[0]


@pytest_asyncio.fixture(loop_scope="session")
async def console(
    serving: Callable[..., Any],
    loopback: str,
    files: CertificateFiles,
    tmp_path: Path,
    cheap_passwords: None,
) -> AsyncIterator[Any]:
    book = UserBook(tmp_path / "users.json")
    book.put("anna", Role.FLY, PASSWORD)
    book.put("wim", Role.WATCH, PASSWORD)
    async with serving(loopback, users=book, certificate=files) as served:
        yield served


async def test_a_user_logs_in_and_flies_over_tls_with_a_cookie_for_this_host_alone(
    console: Any, until: Any
) -> None:
    form = f"name=anna&password={PASSWORD.replace(' ', '+')}"
    status, headers, _ = await console.request("POST", "/login", form, Origin=console.origin)
    assert status == 303
    cookie = headers["set-cookie"]
    assert cookie.startswith(f"__Host-housefly_{console.port}=")
    assert all(word in cookie for word in ("Secure", "HttpOnly", "SameSite=strict", "Path=/"))
    async with console.talk(console.opened(headers)) as one:
        await one.hear("viewers", pilot=1)
        await one.say(type="order", id=1, order="take_off")
        await one.hear("accepted", id=1)
        await one.say(type="stop", id=2)
        await one.hear("accepted", id=2)
        assert len(console.stops) == 1
    await until(lambda: [order.sender for order in console.pilot.orders][:1] == ["anna"])


async def test_the_page_of_the_same_host_without_encryption_is_another_site(console: Any) -> None:
    _, cookie = await console.login("anna", PASSWORD)
    plain = console.origin.replace("https", "http")
    headers = {"Cookie": cookie, "Origin": plain}
    assert (await console.request("POST", "/stop", **headers))[0] == 403
    assert (await console.login("anna", PASSWORD, Origin=plain))[0] == 403
    with pytest.raises(InvalidStatus):
        await connect(
            f"{console.origin.replace('https', 'wss')}/socket",
            ssl=console.trust,
            origin=plain,  # type: ignore[arg-type]
            additional_headers=console.proved({"Cookie": cookie}),
        )


async def test_who_does_not_trust_the_authority_does_not_talk_to_it(console: Any) -> None:
    with pytest.raises(ssl.SSLCertVerificationError):
        await asyncio.open_connection(console.host, console.port, ssl=ssl.create_default_context())


@pytest.mark.filterwarnings("ignore:ssl.TLSVersion:DeprecationWarning")
async def test_old_tls_is_refused(console: Any) -> None:
    old = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    old.check_hostname, old.verify_mode = False, ssl.CERT_NONE
    old.set_ciphers("ALL:@SECLEVEL=0")
    old.minimum_version = ssl.TLSVersion.TLSv1
    old.maximum_version = ssl.TLSVersion.TLSv1_1
    with pytest.raises((ssl.SSLError, ConnectionError)):
        await asyncio.open_connection(console.host, console.port, ssl=old)
    old.maximum_version = ssl.TLSVersion.TLSv1_2
    _, writer = await asyncio.open_connection(console.host, console.port, ssl=old)
    writer.close()


async def test_nothing_is_answered_without_encryption(console: Any) -> None:
    reader, writer = await asyncio.open_connection(console.host, console.port)
    writer.write(f"GET / HTTP/1.1\r\nHost: {console.host}\r\n\r\n".encode())
    answer = b""
    with contextlib.suppress(ConnectionError):
        answer = await asyncio.wait_for(reader.read(), 5.0)
    assert b"HTTP" not in answer
    writer.close()


async def test_handshakes_that_nobody_finishes_keep_nobody_out_and_stop_passes(
    console: Any, monkeypatch: pytest.MonkeyPatch, until: Any
) -> None:
    _, cookie = await console.login("anna", PASSWORD)
    monkeypatch.setattr(handshakes, "HANDSHAKE_TIMEOUT", 100.0)
    flood = []
    async with console.talk(cookie) as one:
        await one.hear("welcome")
        for _ in range(3 * MAX_HANDSHAKES):
            line = await asyncio.to_thread(
                socket.create_connection, (console.host, console.port), 5.0
            )
            line.setblocking(False)
            flood.append(line)
        await one.say(type="stop", id=1)
        await one.hear("accepted", id=1)
        assert (await console.request("GET", "/", Cookie=cookie))[0] == 200
        await asyncio.sleep(0.1)
        assert sum(is_open(line) for line in flood) <= MAX_HANDSHAKES
        monkeypatch.setattr(handshakes, "HANDSHAKE_TIMEOUT", 0.2)
        await until(lambda: not any(is_open(line) for line in flood), 10.0)
        await one.say(type="stop", id=2)
        await one.hear("accepted", id=2)
    for line in flood:
        line.close()


@pytest.mark.browser
async def test_a_person_logs_in_sees_the_drone_and_logs_out_in_a_browser(
    console: Any, chromium: Browser
) -> None:
    context = await chromium.new_context(ignore_https_errors=True)
    page = await context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    await page.goto(console.origin)
    await page.get_by_label("Name").fill("anna")
    await page.get_by_label("Password").fill("a wrong guess")
    await page.get_by_role("button", name="Log in").click()
    await expect(page.locator("main")).to_contain_text("No user has this name and this password")
    await page.get_by_label("Name").fill("anna")
    await page.get_by_label("Password").fill(PASSWORD)
    await page.get_by_role("button", name="Log in").click()
    await expect(page.locator(".drone")).to_be_visible()
    assert page.url == f"{console.origin}/"
    other = await context.new_page()
    await other.goto(f"{console.origin}/account")
    await expect(other.locator("main")).to_contain_text("You are anna; your role is “fly”")
    await other.get_by_role("button", name="Log out").click()
    await expect(other.locator("main")).to_contain_text("You are logged out")
    await page.reload()
    await expect(page.get_by_role("button", name="Log in")).to_be_visible()
    await context.close()
    assert errors == []


CLIENT = """
import http.client, ssl, sys
connection = http.client.HTTPSConnection(
    "10.77.0.1", 8443, timeout=10, context=ssl.create_default_context(cafile=sys.argv[1])
)
connection.request("GET", "/")
print(connection.getresponse().status)
connection.close()
for host in ("127.0.0.1", "evil.example"):
    connection.request("GET", "/", headers={"Host": host})
    print(connection.getresponse().status)
    connection.close()
"""
SERVER = """
import asyncio, sys
from pathlib import Path
from housefly.bus.local import LocalBus
from housefly.config.site import Site, changed
from housefly.web.console_port import listening
from housefly.web.access.exposure import checked_exposure
from housefly.web.process import make_server
from housefly.web.server import create_app
from housefly.web.access.users import UserBook

folder = sys.argv[1]
site = changed(
    Site(), web__host=sys.argv[2], web__port=8443, web__users=f"{folder}/users.json",
    web__tls_certificate=f"{folder}/console.pem", web__tls_key=f"{folder}/console-key.pem",
)
exposure = checked_exposure(site)
app = create_app(
    LocalBus(), "token", lambda: None, hosts=exposure.names, users=UserBook(Path(site.web.users))
)
with listening(site.web.host, site.web.port) as listener:
    print("listens", flush=True)
    asyncio.run(make_server(app, exposure.certificate.context).serve([listener]))
"""


def can_make_networks() -> bool:
    if sys.platform != "linux" or os.geteuid() != 0:
        return False
    made = subprocess.run(["unshare", "-n", "ip", "link"], capture_output=True, check=False)
    return made.returncode == 0


@pytest.mark.skipif(not can_make_networks(), reason="only root makes networks, with iproute2")
async def test_another_machine_reaches_it_by_the_name_in_the_certificate(
    tmp_path: Path, cheap_passwords: None
) -> None:
    """Two network namespaces with a cable: the console in one, a client in the other."""
    make_certificate(tmp_path, ["lab.local", "10.77.0.1"])
    UserBook(tmp_path / "users.json").put("anna", Role.FLY, PASSWORD)
    script = (
        "ip link set lo up; ip link add cable type veth peer name plug;"
        " unshare -n sleep 60 & far=$!; here=$(readlink /proc/self/ns/net);"
        " until [ $(readlink /proc/$far/ns/net) != $here ]; do sleep 0.1; done;"
        " ip link set plug netns $far;"
        " ip addr add 10.77.0.1/24 dev cable; ip link set cable up;"
        " nsenter -t $far -n ip addr add 10.77.0.2/24 dev plug;"
        " nsenter -t $far -n ip link set plug up;"
        ' timeout 60 "$1" -c "$2" "$3" 0.0.0.0 > "$3/said" 2>&1 & served=$!;'
        ' until grep -q listens "$3/said"; do kill -0 $served || break; sleep 0.1; done;'
        ' nsenter -t $far -n "$1" -c "$4" "$3/authority.pem"; kill $served $far;'
        ' cat "$3/said" >&2'
    )
    given = (sys.executable, SERVER, str(tmp_path), CLIENT)
    done = await asyncio.to_thread(
        subprocess.run,
        [*("unshare", "-n", "bash", "-c", script, "-"), *given],
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    assert done.stdout.split() == ["403", "403", "421"], done.stdout + done.stderr
