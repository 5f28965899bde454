import numpy as np
import pytest

from workbench.errors import Refused
from workbench.geometry.body import check_body


@pytest.fixture
def plate():
    """Control heights of a plate of 0.5 over the entrance face at 0; the screen is at 5."""
    return np.full((12, 10), 0.5)


@pytest.mark.parametrize("height", [-9.8, 0.0, 1e-12, 5.0, 4000.0])
def test_a_face_that_touches_or_passes_another_is_refused(make_scene, plate, height):
    with pytest.raises(Refused, match="no body of glass") as refused:
        check_body(make_scene(), {"exit": np.full_like(plate, height)})
    assert f"z = {height:.5g} cm at x = " in str(refused.value)


def test_the_refusal_names_the_place(make_scene, plate):
    plate[11, 9] = -0.2  # the face passes through its corners
    with pytest.raises(Refused) as refused:
        check_body(make_scene(), {"exit": plate})
    assert str(refused.value) == (
        "lens: its exit face is at z = -0.2 cm at x = 1, y = 1, not above the entrance face at "
        "z = 0: that is no body of glass"
    )


def test_the_face_counts_and_not_its_control_points(make_scene, plate):
    plate[5, 5] = -0.2  # which the face does not come near
    check_body(make_scene(), {"exit": plate})
    plate[5, 5] = -2.0
    with pytest.raises(Refused, match="no body"):
        check_body(make_scene(), {"exit": plate})
