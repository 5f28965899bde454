"""Predicted photos of lenses whose light is known."""

import math

import numpy as np
import pytest

from tests.analysis.lenses import net_of
from workbench.analysis.cells.image import imaging
from workbench.analysis.photo.light import LIGHTS, linear_rgb, tristimulus
from workbench.analysis.photo.photo import photograph
from workbench.materials import CATALOGUE
from workbench.progress import finished
from workbench.scene import PlaneFace

DISPERSIVE = {"lens.refractive_index": "PMMA", "lens.wavelength_um": 0.55}
# All light of the plate on the screen, which stands far away, in few pixels.
WIDE = {"screen": {"z": 20.0, "half_width": [6.0, 6.0], "pixels": [48, 16]}}
LEANS = 0.3


def plate(scene):
    return {"lens.back": np.full(scene.optic.net_shape, 0.5)}


def prism(scene):
    return {"lens.back": net_of(scene, lambda x, y: 0.5 + LEANS * x + 0 * y)}


def shift(index):
    """How far the light of the prism goes aside on its way to the screen, by Snell's law."""
    tilt = math.atan(LEANS)
    return 19.5 * math.tan(math.asin(index * math.sin(tilt)) - tilt)


def white(scene):
    n_x, n_y = scene.receiver.pixels
    return np.ones((n_y, n_x))


def test_without_dispersion_each_channel_is_the_image_of_the_check(make_scene):
    scene = make_scene(WIDE)
    photo = photograph(scene, white(scene), prism(scene))
    grey = finished(imaging(scene, prism(scene), 0.02)).irradiance
    for channel in np.moveaxis(photo.rgb, -1, 0):
        assert np.linalg.norm(channel - grey) < 0.02 * np.linalg.norm(grey)
        assert channel == pytest.approx(photo.rgb[..., 0], abs=1e-9 * grey.max())
    assert len(photo.wavelengths_um) == 1
    assert "no dispersion known" in photo.summary


def test_a_plate_before_a_prism_leaves_its_colours_where_they_are(make_scene):
    scene = make_scene(WIDE | DISPERSIVE)
    heights = prism(scene)
    alone = photograph(scene, white(scene), heights, LIGHTS["equal"])
    faces = (PlaneFace(), PlaneFace())
    changes = {"name": "plate", "faces": faces, "position": (0.0, 0.0, -2.0), "material": "PC"}
    plate_before = scene.optic.model_copy(update=changes)
    train = scene.model_copy(update={"elements": (plate_before, *scene.elements)})
    photo = photograph(train, white(scene), heights, LIGHTS["equal"])
    x = (np.arange(48) + 0.5) / 4 - 6
    places = [x @ each.rgb.sum(axis=0) / each.rgb.sum(axis=(0, 1)) for each in (alone, photo)]
    assert places[1] == pytest.approx(places[0], abs=0.01)
    assert photo.rgb.sum() < 0.95 * alone.rgb.sum()  # the plate reflects


def test_a_prism_parts_colours_by_snells_law(make_scene):
    scene = make_scene(WIDE | DISPERSIVE)
    photo = photograph(scene, white(scene), prism(scene), LIGHTS["equal"])
    x = (np.arange(48) + 0.5) / 4 - 6
    found = x @ photo.rgb.sum(axis=0) / photo.rgb.sum(axis=(0, 1))
    # Light beyond the wavelengths that are traced is taken to go where the last of these does.
    wavelengths = np.linspace(0.38, 0.78, 801)
    places = [shift(CATALOGUE["PMMA"].index(each)) for each in wavelengths.clip(0.4, 0.7).tolist()]
    seen = linear_rgb(tristimulus(wavelengths))
    assert np.abs(found) == pytest.approx(places @ seen / seen.sum(axis=0), rel=0.005)
    red, green, blue = np.abs(found)
    assert red < green < blue
    assert photo.step < 1


def test_a_source_of_some_size_is_seen_with_it(make_scene):
    scene = make_scene(
        WIDE | {"source": {"kind": "collimated", "angular_diameter": 4.0}} | DISPERSIVE
    )
    photo = photograph(scene, white(scene), plate(scene))
    # From the middle of the image to its end the light falls over the width of the disc.
    across = photo.rgb[..., 1].sum(axis=0)
    blurred = (across > 0.01 * across.max()) & (across < 0.99 * across.max())
    assert blurred.sum() * 0.25 == pytest.approx(2 * 20 * math.radians(4.0), abs=0.8)
