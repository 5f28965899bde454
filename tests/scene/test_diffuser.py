"""Trains with a diffuser: what is refused, and where."""

from typing import Any

import pytest

from tests.diffusers import with_diffuser
from tests.scenes import changed
from workbench.errors import Refused
from workbench.optics.account import keys_in
from workbench.scene import Scene

_LAMBERTIAN = {"kind": "lambertian"}
_FAR_FIELD = {"kind": "far_field", "half_angle": [10, 10], "pixels": [16, 16]}


def _refused(data: dict[str, Any]) -> Refused:
    with pytest.raises(Refused) as caught:
        Scene.from_data(data)
    return caught.value


@pytest.mark.parametrize(
    ("changes", "path"),
    [
        ({"elements.1.scatter.sigma": 0}, "elements[1].scatter.sigma"),
        ({"elements.1.scatter.sigma": 61}, "elements[1].scatter.sigma"),
        ({"elements.1.scatter": {"kind": "opal"}}, "elements[1].scatter.kind"),
        ({"elements.1.transmittance": 1.1}, "elements[1].transmittance"),
        ({"elements.1.position": [0, 0, 31]}, "images"),
        ({"elements.1.position": [0, 0, 3]}, "elements[1].position[2]"),
    ],
)
def test_values_that_are_impossible_are_refused(changes, path):
    data = with_diffuser()
    for field, value in changes.items():
        *parents, last = field.split(".")
        part: Any = data
        for parent in parents:
            part = part[int(parent)] if parent.isdigit() else part[parent]
        part[last] = value
    assert _refused(data).path == path


def test_nothing_but_the_receiver_may_be_behind_a_diffuser():
    data = with_diffuser()
    behind = {**data["elements"][1], "name": "second", "position": [0, 0, 29]}
    refused = _refused({**data, "elements": [*data["elements"], behind]})
    assert refused.path == "elements[2]"
    assert "'second' is behind the diffuser film" in str(refused)


def test_a_lambertian_diffuser_lights_planes_parallel_to_it():
    parallel = with_diffuser(_LAMBERTIAN, tilt=[10, 5, 0])
    parallel["images"][0]["receiver"] |= {"tilt": [10, 5, 30], "position": [0, 0, 45]}
    assert Scene.from_data(parallel).diffuser is not None
    assert _refused(with_diffuser(_LAMBERTIAN, tilt=[10, 0, 0])).path == "images[0].receiver.tilt"
    far = _refused(with_diffuser(_LAMBERTIAN, receiver=_FAR_FIELD))
    assert far.path == "images[0].receiver.kind"
    assert "elements[1].scatter.kind: 'gaussian'" in str(far)


def test_parts_that_know_no_diffuser_refuse_it():
    with pytest.raises(Refused, match=r"elements\[1\].kind: 'diffuser', which the bound"):
        Scene.from_data(with_diffuser()).check_no_diffuser("the bound")
    Scene.from_data(changed({"screen.z": 6})).check_no_diffuser("the bound")


def test_the_account_knows_the_losses_of_all_elements():
    at_lens = ("missed_lens", "left_side", "total_reflection", "fresnel_entrance", "fresnel_exit")
    at_film = "missed_diffuser@film", "absorbed_diffuser@film"
    keys = keys_in(Scene.from_data(with_diffuser()))
    assert keys == ("off_screen", *(f"{kind}@lens" for kind in at_lens), *at_film)
    assert keys_in(Scene.from_data(with_diffuser(transmittance=1.0)))[-1] == "missed_diffuser@film"
