import subprocess
import sys

import pytest


@pytest.mark.parametrize(
    ("substitute", "remedy"),
    [
        ("sys.modules['mujoco'] = None", "housefly[twin]"),
        ("sys.meta_path.insert(0, Broken())", "unset MUJOCO_GL"),
    ],
)
def test_without_a_usable_mujoco_the_error_names_the_remedy(substitute: str, remedy: str) -> None:
    code = f"""
import sys
class Broken:
    def find_spec(self, name, path=None, target=None):
        if name == "mujoco":
            raise AttributeError("'NoneType' object has no attribute 'eglQueryString'")
{substitute}
from housefly.errors import MissingPartError
try:
    import housefly.twin.world
except MissingPartError as error:
    print(error)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert remedy in done.stdout
