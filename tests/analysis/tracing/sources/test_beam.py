"""Collimated light of the check: tilted, from a disc, or a Gaussian beam."""

import pytest

from tests.optics.points import smooth
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources import light_source
from workbench.analysis.validation import validate
from workbench.optics.plan import Plan

SUN = {"kind": "collimated", "angular_diameter": 6.0}
TILTED = {"kind": "collimated", "direction": [8.0, -5.0], "angular_diameter": 2.0}
PARALLEL = {"kind": "collimated", "direction": [8.0, -5.0]}
BEAM = {"kind": "collimated", "profile": {"kind": "gaussian", "radius": 0.7}}
OBLIQUE = BEAM | {"direction": [10.0, 4.0], "angular_diameter": 3.0}
ALL = pytest.mark.parametrize("source", [SUN, TILTED, PARALLEL, BEAM, OBLIQUE])


@ALL
def test_the_check_agrees_with_the_walk(make_scene, source):
    few = {"screen.pixels": [8, 8], "filter": {"kind": "box"}}
    scene = make_scene(few | {"source": source | {"rays": [400, 400]}})
    heights = smooth(scene)
    light = Plan(scene, fused=False).trace({"exit": heights})
    image = light.flux.double().numpy() / scene.receiver.pixel_measure
    faces = {"exit": heights.numpy()}
    found = validate(scene, image, faces, rays=100_000, accuracy=0.05)
    assert found.relative_l2_corrected < 2e-2
    assert found.account.on_screen + sum(found.account.lost.values()) == pytest.approx(1, abs=1e-9)
    for name, flux in found.account.lost.items():
        assert flux == pytest.approx(light.account.lost[name], abs=3e-3), name
    assert found.by_cells is not None
    assert found.by_cells.unscattered.distance < found.by_cells.bound + 5e-3


@pytest.mark.parametrize("source", [BEAM, OBLIQUE])
@pytest.mark.parametrize("pose", [Pose(), Pose((0.1, -0.05), (0.3, 0.2))])
def test_rays_carry_the_flux_of_the_quadrature_rule(make_scene, source, pose):
    scene = make_scene({"source": source})
    light = light_source(scene.source, scene.optic, pose, 200_000, 1)
    flux = sum(rays.flux.sum() for number in range(16) for rays in light.batch(number))
    assert flux / light.rays == pytest.approx(1 / (1 + light.beside), abs=1e-3)
