"""A train as a scene of Mitsuba 3, whose light tracer makes the image (optional extra ``mitsuba``).

Nothing of this program traces here: Mitsuba emits, meets triangles, refracts by the exact equations
of Fresnel and connects the lit screen to a camera. The scene holds all elements as meshes with the
normals of their faces, black walls at the sides of lenses, black baffles around them, and a screen
that scatters all light to the other side, where the camera looks at it. Reflected light goes
astray, as in this program: paths that meet more than all faces and the screen are left out.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from workbench import system_libraries
from workbench.analysis.mitsuba_elements import Coordinates, mitsuba_elements
from workbench.analysis.mitsuba_lights import check_known, mitsuba_lights
from workbench.analysis.mitsuba_receivers import picture_of
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.progress import Progress, no_progress
from workbench.scene import Scene, Screen

# Variant without a compiler at run time: that of the others needs an LLVM of the right version.
_VARIANT = "scalar_rgb"
# Distance of the camera over the half-width of the screen.
_AWAY = 4.0
# Paths of a pass, at least one for each pixel: an interruption waits for one of them.
_AT_ONCE = 1 << 17


class MitsubaScene:
    """Elements, their light and their screen in Mitsuba.

    Parameters
    ----------
    scene : Scene
        Elements, source and receiver; filter and run settings play no part.
    heights : mapping of str to ndarray, shape (n_u, n_v)
        Control heights of each freeform face by its name, scene units.

    Raises
    ------
    Refused
        If Mitsuba is not installed, its camera cannot see the receiver, or it is given no light or
        no element of a kind.
    """

    def __init__(self, scene: Scene, heights: Mapping[str, Array]) -> None:
        self._mi = _mitsuba()
        self._picture = picture_of(scene)
        self._scene, self._coordinates = scene, Coordinates.of(scene)
        self._onwards = scene.onwards(scene.receiver)
        check_known(scene.source)
        self._pixel_area = self._picture.screen.pixel_measure / self._coordinates.unit**2
        screen = self._picture.screen
        self._unlit: dict[str, Any] = {
            "type": "scene",
            # Else two of a million rays pass between two triangles of a face.
            "embree_use_robust_intersections": True,
            "integrator": {"type": "ptracer", "max_depth": _segments(scene), "rr_depth": 100},
            "sensor": self._camera(),
            "screen": self._screen(),
            **mitsuba_elements(self._mi, scene, heights, screen, self._coordinates),
        }

    def flux(self, rays: int, seed: int, progress: Progress = no_progress) -> Array:
        """Part of the emitted light in each pixel.

        Parameters
        ----------
        rays : int
            Paths to trace at least; rounded up to as many for each pixel in each pass.
        seed : int
            The same seed gives the same paths.
        progress : callable
            Called with the part that is done.

        Returns
        -------
        ndarray, shape (n_y, n_x)
            Row 0 at +y.
        """
        n_x, n_y = self._picture.screen.pixels
        samples = -(-rays // (n_x * n_y))
        passes = min(-(-samples * n_x * n_y // _AT_ONCE), samples)
        samples = -(-samples // passes)
        lights, emitted = mitsuba_lights(
            self._mi, *self._coordinates.entrance(self._scene), self._coordinates.unit, rays, seed
        )
        lit = self._mi.load_dict(self._unlit | lights)
        radiance = np.zeros((n_y, n_x))
        # Seeds that have nothing to do with each other: Mitsuba counts on from them.
        states = np.random.SeedSequence(seed).generate_state(passes)
        for done, state in enumerate(states, 1):
            picture = self._mi.render(lit, spp=samples, seed=int(state))
            radiance += np.array(picture)[:, :, 0]
            progress(done / passes)
        if self._onwards < 0:  # seen from the other side, x goes to the left
            radiance = radiance[:, ::-1]
        # Scattered evenly into the half-sphere.
        irradiance = math.pi / passes * radiance
        flux = np.asarray(irradiance * self._pixel_area / emitted)
        return self._picture.light(flux, self._scene.receiver)

    def _seen(self, screen: Screen) -> tuple[Array, Array]:
        """Middle of a screen, and its unit vectors as rows, in Mitsuba."""
        coordinates = self._coordinates
        return coordinates.places(np.array(screen.position)), coordinates.vectors(screen.sides)

    def _screen(self) -> dict[str, Any]:
        screen = self._picture.screen
        r_x, r_y = (r / self._coordinates.unit for r in screen.half_width)
        to_world = np.eye(4)
        middle, sides = self._seen(screen)
        to_world[:3, :3] = sides.T * [r_x, r_y, 1.0]
        to_world[:3, 3] = middle
        return {
            "type": "rectangle",
            "to_world": self._mi.ScalarTransform4f(to_world),
            "bsdf": {
                "type": "principledthin",
                "base_color": {"type": "rgb", "value": 1.0},
                "diff_trans": 2.0,  # all of it goes through
                "spec_trans": 0.0,
            },
        }

    def _camera(self) -> dict[str, Any]:
        """Its picture is the screen, exactly."""
        screen, (n_x, n_y) = self._picture.screen, self._picture.screen.pixels
        middle, (_, up, across) = self._seen(screen)
        r_x = screen.half_width[0] / self._coordinates.unit
        behind = middle + _AWAY * r_x * self._onwards * across
        return {
            "type": "perspective",
            "fov": 2 * math.degrees(math.atan(1 / _AWAY)),
            "fov_axis": "x",
            # What is farther away than its usual 10,000 would be left out.
            "near_clip": 0.1 * _AWAY * r_x,
            "far_clip": 10 * _AWAY * r_x,
            "to_world": self._mi.ScalarTransform4f().look_at(
                behind.tolist(), middle.tolist(), up.tolist()
            ),
            "film": {
                "type": "hdrfilm",
                "width": n_x,
                "height": n_y,
                "rfilter": {"type": "box"},
                "pixel_format": "luminance",
                "component_format": "float32",
            },
        }


def _segments(scene: Scene) -> int:
    """Segments of the longest way: source, faces, screen, camera.

    From a mirror light may go through the sheet that it came from.
    """
    faces = sum(len(element.placed_faces) for element in scene.elements)
    back = any(element.onwards < 0 for element in scene.elements)
    return faces + 2 + int(back)


def _mitsuba() -> Any:
    if missing := system_libraries.missing(system_libraries.MITSUBA):
        raise Refused("--with", f"'mitsuba' cannot be loaded. {system_libraries.advice(missing)}")
    try:
        import mitsuba
    except ImportError as error:
        raise Refused(
            "--with",
            "'mitsuba' needs Mitsuba 3, which pip install "
            "'freeform-lens-workbench[mitsuba]' brings",
        ) from error
    mi: Any = mitsuba
    mi.set_variant(_VARIANT)
    mi.logger().clear_appenders()  # its progress is not for our output
    return mi
