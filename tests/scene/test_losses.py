"""Fields of losses: versions of files, and what is refused."""

import pytest

from workbench.errors import Refused
from workbench.scene import Scene


def read(data, version, **lens):
    given = {key: value for key, value in data["lens"].items() if key not in lens} | lens
    return Scene.from_data(data | {"version": version, "lens": given})


class TestVersions:
    def test_a_file_of_version_1_means_schlick_and_is_written_as_it_was(self, scene_data):
        scene = read(scene_data, 1)
        assert scene.optic.reflection == "schlick"
        written = scene.to_data()
        assert written["version"] == 1
        assert not {"reflection", "coating", "absorption"} & written["lens"].keys()


@pytest.mark.parametrize(
    ("lens", "path", "said"),
    [
        ({"reflection": "mirror"}, "lens.reflection", "'fresnel', 'schlick' or 'none'"),
        ({"coating": [0.1, 1.0]}, "lens.coating[1]", "1.0"),
        ({"coating": [-0.1, 0.0]}, "lens.coating[0]", "-0.1"),
        ({"coating": [0.1]}, "lens.coating[1]", "missing"),
        ({"coating": 0.01}, "lens.coating", "a list"),
        ({"absorption": -1e-9}, "lens.absorption", "-1e-09"),
        ({"absorption": "clear"}, "lens.absorption", "clear"),
        ({"absorption": 30.0}, "lens.absorption", "at most 27.6"),
    ],
)
def test_impossible_loss_is_refused_with_its_path(scene_data, lens, path, said):
    with pytest.raises(Refused) as refused:
        read(scene_data, 2, **lens)
    assert refused.value.path == path
    assert said in refused.value.reason
