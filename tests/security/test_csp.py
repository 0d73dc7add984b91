"""What a page of the console may not do, in real Chromium: run what somebody slipped into it."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.async_api import Browser

pytestmark = [pytest.mark.browser, pytest.mark.asyncio(loop_scope="session")]

SLIPPED_IN = """async (elsewhere) => {
  window.hits = [];
  const script = document.createElement("script");
  script.textContent = "window.hits.push('inline script')";
  document.body.append(script);
  const picture = document.createElement("div");
  picture.innerHTML = "<img src=x onerror=\\"window.hits.push('attribute')\\">";
  document.body.append(picture);
  const foreign = document.createElement("script");
  foreign.src = elsewhere + "/static/app.js";
  foreign.onload = () => window.hits.push("foreign script");
  document.body.append(foreign);
  await fetch(elsewhere + "/").then(() => window.hits.push("sent away"), () => {});
  const form = document.createElement("form");
  form.action = elsewhere + "/login";
  form.method = "post";
  document.body.append(form);
  form.submit();
  const base = document.createElement("base");
  base.href = elsewhere;
  document.head.append(base);
  if (new URL("x", document.baseURI).href.startsWith(elsewhere)) window.hits.push("base");
  await new Promise((done) => setTimeout(done, 300));
  return window.hits;
}"""
FRAMED = """async (inside) => {
  const frame = document.createElement("iframe");
  frame.src = inside;
  const ready = new Promise((done) => { frame.onload = frame.onerror = done; });
  document.body.append(frame);
  await ready;
  try { return frame.contentDocument ? "readable" : "closed"; } catch { return "closed"; }
}"""


async def test_what_is_slipped_into_the_page_neither_runs_nor_sends(
    serving: Any, loopback: str, chromium: Browser
) -> None:
    async with serving(loopback) as console, serving("127.67.0.9") as elsewhere:
        page = await (await chromium.new_context()).new_page()
        await page.goto(console.link)
        await page.wait_for_selector(".drone")
        assert await page.evaluate(SLIPPED_IN, elsewhere.origin) == []
        assert page.url == f"{console.origin}/"
        await page.context.close()


async def test_no_page_shows_the_console_in_a_frame(
    serving: Any, loopback: str, chromium: Browser
) -> None:
    async with serving(loopback) as console:
        page = await (await chromium.new_context()).new_page()
        await page.goto(console.link)
        await page.wait_for_selector(".drone")
        other = await page.context.new_page()
        await other.set_content("<p>a page of somebody else</p>")
        await other.evaluate(FRAMED, console.origin)
        assert await other.frames[-1].query_selector(".drone") is None
        await page.context.close()
