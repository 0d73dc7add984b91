"""Where a point of the room is drawn: read at once, when the plan stands still."""

from __future__ import annotations

from math import cos, sin
from typing import NamedTuple

from playwright.async_api import Page

PLAN = ".plan-view > svg"

_STANDING = """async (selector) => {
  const read = () => {
    const plan = document.querySelector(selector), box = plan.getBoundingClientRect();
    const [u, v] = plan.dataset.origin.split(" ").map(Number);
    const { scale, angle } = plan.dataset;
    return [box.x, box.y, u, v, Number(scale), Number(angle ?? 0)];
  };
  const frame = () => new Promise(requestAnimationFrame);
  let last = read();
  for (let still = 0; still < 6; ) {
    await frame();
    const now = read();
    still = now.every((each, k) => each === last[k]) ? still + 1 : 0;
    last = now;
  }
  return last;
}"""


class DrawnPlan(NamedTuple):
    """A drawn plan: its corner on the page, the room's origin in it [px], its scale [px/m].

    It is turned counterclockwise by an angle [rad].
    """

    left: float
    top: float
    u: float
    v: float
    scale: float
    angle: float

    def pixel(self, x: float, y: float) -> tuple[float, float]:
        """Return where a point of the room [m] is on the page [px]."""
        right = x * cos(self.angle) - y * sin(self.angle)
        up = x * sin(self.angle) + y * cos(self.angle)
        return self.left + self.u + right * self.scale, self.top + self.v - up * self.scale


async def drawn_plan(page: Page, selector: str = PLAN) -> DrawnPlan:
    """Return how a plan is drawn, when it has not moved for six frames of the screen."""
    return DrawnPlan(*await page.evaluate(_STANDING, selector))
