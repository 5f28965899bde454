"""The spectrum of a source."""

import pytest

from tests.scenes import changed
from workbench.errors import Refused
from workbench.scene import Scene

DATA = {
    "version": 3,
    "source": {"kind": "point", "position": [0, 0, -9]},
    "elements": [
        {
            "kind": "lens",
            "name": "lens",
            "half_width": [2, 2],
            "material": "PC",
            "thickness": 1,
            "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": [8, 8]}],
        }
    ],
    "images": [
        {
            "receiver": {
                "kind": "plane",
                "position": [0, 0, 60],
                "half_width": [4, 3],
                "pixels": [8, 8],
            },
            "target": {"builtin": "tophat"},
        }
    ],
}


def lit(**light):
    return Scene.from_data(changed({f"source.{name}": each for name, each in light.items()}, DATA))


@pytest.mark.parametrize(
    ("light", "path", "words"),
    [
        ({"spectrum": []}, "source.spectrum", "0 lines are given; 1 to 16"),
        ({"spectrum": [[0.5 + 0.01 * k, 1] for k in range(17)]}, "source.spectrum", "17 lines"),
        ({"spectrum": [[0.5, 0], [0.6, 0]]}, "source.spectrum", "all parts of the flux are 0"),
        ({"spectrum": [[0.5, 1], [0.6, -1]]}, "source.spectrum[1][1]", "-1 is too small"),
        ({"spectrum": [[0.5, 1], [0.3, 1]]}, "source.spectrum[1][0]", "outside the data for PC"),
        ({"spectrum": [[0.5, 1]], "wavelength_um": 0.6}, "source.spectrum", "one of both"),
    ],
)
def test_an_impossible_spectrum_is_refused_with_its_path(light, path, words):
    with pytest.raises(Refused) as refused:
        lit(**light)
    assert refused.value.path == path
    assert words in str(refused.value.reason)


def test_parts_add_up_to_one_and_the_mean_wavelength_counts_elsewhere():
    scene = lit(spectrum=[[0.5, 3], [0.6, 1], [0.7, 0]])
    assert [(line.scene.source.wavelength, line.part) for line in scene.lines] == [
        (0.5, 0.75),
        (0.6, 0.25),
    ]
    assert scene.source.wavelength == pytest.approx(0.525)
    assert scene.source.sharp.spectrum == scene.source.spectrum
    assert Scene.from_data(scene.to_data()) == scene


def test_lines_without_dispersion_are_one():
    data = changed({"source.spectrum": [[0.5, 3], [0.6, 1]]}, DATA)
    data["elements"][0]["material"] = {"index": 1.5}
    (line,) = Scene.from_data(data).lines
    assert line.part == 1
    assert line.scene.source.spectrum is None
