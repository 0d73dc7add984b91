"""The control laws with one site's gains, in the words of the pilot."""

from __future__ import annotations

from housefly.config.site import Site
from housefly.messages import Action, Behavior, Command, Setpoint
from housefly.pilot.control.steering import Aim, Asked, Gains, Where, steered, steered_by_paper

STATES = tuple(Behavior)


def gains_of(site: Site) -> Gains:
    """Return what the laws need of a site."""
    control, limits, drone = site.control, site.limits, site.drone
    return Gains(
        alpha=control.alpha,
        beta=control.beta,
        height=control.height_gain,
        yaw=control.yaw_gain,
        tilt_max=limits.tilt_max,
        climb_max=limits.vertical_speed_max,
        turn_max=limits.yaw_rate_max,
        gain=drone.attitude_gain,
        drag=drone.drag,
        delay=drone.command_delay,
    )


class Autopilot:
    """The laws of both modes."""

    def __init__(self, site: Site) -> None:
        self._gains = gains_of(site)

    def default(self, aim: Aim, where: Where) -> Command:
        """Return the command of mode default: all four axes at once, in every state of the
        acceptor.
        """
        return _flying(steered(aim, where, self._gains))

    def paper(self, behavior: Behavior, aim: Aim, where: Where) -> Command:
        """Return the command of mode paper: only the active behavior's axis is commanded, the
        others are level or still.
        """
        if behavior is Behavior.HOVER:
            return Command(Action.HOVER)
        return _flying(steered_by_paper(STATES.index(behavior), aim, where, self._gains))


def _flying(asked: Asked) -> Command:
    return Command(Action.FLY, Setpoint(asked.theta, asked.phi, asked.vz, asked.yaw_rate))
