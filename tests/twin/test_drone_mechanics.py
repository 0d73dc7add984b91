from hypothesis import given
from hypothesis import strategies as st

from housefly.config.airframe import airframe_named
from housefly.twin.drone_mechanics import mechanics_of


@given(st.floats(0.02, 20.0))
def test_a_body_of_any_mass_is_one_that_mujoco_takes(mass: float) -> None:
    airframe = airframe_named("ardrone")
    scaled = {"mass": mass, "inertia_tilt": None, "inertia_turn": None}
    body = airframe.body.model_copy(update=scaled)
    moments = mechanics_of(airframe.model_copy(update={"body": body})).inertia
    tilt, other, turn = (float(f"{moment:.9g}") for moment in moments)
    assert 0.0 < turn <= tilt + other
