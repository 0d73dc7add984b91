"""The room to load, and the occupancy grid that is built of it."""

from __future__ import annotations

from typing import Literal, Self

from pydantic import Field, model_validator

from housefly.config.rectangle import Rectangle, check_floor, check_rectangle
from housefly.config.section import Section, quantity


class RoomConfig(Section):
    """Which room the drone flies in."""

    model: str = Field(
        default="bsen",
        description="a built-in room (bsen) or the path of a room directory, relative to this file",
    )


class VirtualObstacle(Section):
    """A part of the floor plan that the drone must not enter although nothing stands there."""

    rectangle: Rectangle = Field(description="x_min, y_min, x_max, y_max [m]")
    reason: str = Field(default="", description="shown on the map")

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        check_rectangle(self.rectangle)
        return self


class MapConfig(Section):
    """The occupancy grid and how obstacles grow on it; the voxels of flight in space."""

    planner: Literal["grid", "space"] = Field(
        default="space",
        description=(
            "space: smooth trajectories in three dimensions; grid: corners at flight_height, as"
            " mode paper always flies"
        ),
    )
    voxel: float = quantity(0.1, 0.05, 0.25, "m", "edge of a voxel, planner space")
    narrow_speed: float = quantity(
        0.8, 0.05, 2.0, "m/s", "highest speed where the way is as narrow as can be, planner space"
    )
    resolution: float = quantity(0.1, 0.02, 1.0, "m", "edge of a grid cell")
    flight_height: float = quantity(
        1.1, 0.3, 2.5, "m", "height that the grid is cut at and that the drone flies at"
    )
    half_band: float = quantity(
        0.25, 0.0, 1.0, "m", "obstacles within flight_height plus or minus this count"
    )
    tracking_bound: float = quantity(0.10, 0.0, 1.0, "m", "largest expected distance from the path")
    margin: float = quantity(0.05, 0.0, 1.0, "m", "extra distance kept from everything")
    paper_rectangle: Rectangle = Field(
        default=(2.3, 0.5, 14.8, 5.0),
        description=(
            "part of the room that mode paper's 25 x 9 grid covers: x_min, y_min, x_max, y_max [m]"
        ),
    )
    paper_resolution: float = quantity(0.5, 0.1, 1.0, "m", "edge of a grid cell in mode paper")
    virtual_obstacles: tuple[VirtualObstacle, ...] = Field(
        default=(), description="places kept free by order"
    )
    paper_virtual_obstacles: tuple[VirtualObstacle, ...] = Field(
        default=(), description="the same, in mode paper"
    )

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        check_rectangle(self.paper_rectangle)
        check_floor(self.paper_rectangle, "paper_rectangle")
        return self
