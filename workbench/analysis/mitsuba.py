"""A lens as a scene of Mitsuba 3, whose light tracer makes the image (optional extra ``mitsuba``).

Nothing of this program traces here: Mitsuba emits, meets triangles, refracts by the exact equations
of Fresnel and connects the lit screen to a camera. The scene holds the lens as a mesh with the
normals of its B-splines, black walls at its sides, black baffles around these, and a screen that
scatters all light to the other side, where the camera looks at it. Reflected light goes astray, as
in this program: paths that meet more than both faces and the screen are left out.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from workbench import system_libraries
from workbench.analysis.mitsuba_lights import check_known, mitsuba_lights
from workbench.analysis.mitsuba_receivers import picture_of
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.geometry.outlines import Rectangle, outline_of
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.scene import Lens, Mirror, Scene
from workbench.watch import Watch, unwatched

Indices = npt.NDArray[np.uint32]

# Variant without a compiler at run time: that of the others needs an LLVM of the right version.
_VARIANT = "scalar_rgb"
# Least number of cells of the mesh along each axis; they divide the knot spans evenly.
_CELLS = 1024
# In half-widths of the lens: how far the baffle goes.
_BAFFLE = 1000.0
# Distance of the camera over the half-width of the screen.
_AWAY = 4.0
# Paths of a pass, at least one for each pixel: an interruption waits for one of them.
_AT_ONCE = 1 << 17
_BLACK = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}}


class MitsubaScene:
    """A lens, its light and its screen in Mitsuba.

    Parameters
    ----------
    scene : Scene
        Lens, source and screen; filter and run settings play no part.
    heights : mapping of str to ndarray, shape (n_u, n_v)
        Control heights of each freeform face by its name, scene units.

    Raises
    ------
    Refused
        If Mitsuba is not installed, or its camera cannot see the receiver.
    """

    def __init__(self, scene: Scene, heights: Mapping[str, Array]) -> None:
        self._mi = _mitsuba()
        self._picture = picture_of(scene.receiver, scene.optic)
        # Mitsuba counts in single precision and has thresholds made for lengths of about 1.
        self._scene, self._unit = scene, max(scene.optic.half_width)
        check_known(scene.source)
        self._pixel_area = self._picture.screen.pixel_measure / self._unit**2
        make, segments = _BODIES[type(scene.optic)]
        body = make(self, heights)
        self._unlit: dict[str, Any] = {
            "type": "scene",
            "integrator": {"type": "ptracer", "max_depth": segments, "rr_depth": 100},
            "sensor": self._camera(),
            "screen": self._screen(),
            **body,
        }

    def flux(self, rays: int, seed: int, watch: Watch = unwatched) -> Array:
        """Part of the emitted light in each pixel.

        Parameters
        ----------
        rays : int
            Paths to trace at least; rounded up to as many for each pixel in each pass.
        seed : int
            The same seed gives the same paths.
        watch : callable
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
        source, optic = self._scene.source, self._scene.optic
        lights, emitted = mitsuba_lights(self._mi, source, optic, self._unit, rays, seed)
        lit = self._mi.load_dict(self._unlit | lights)
        radiance = np.zeros((n_y, n_x))
        # Seeds that have nothing to do with each other: Mitsuba counts on from them.
        states = np.random.SeedSequence(seed).generate_state(passes)
        for done, state in enumerate(states, 1):
            picture = self._mi.render(lit, spp=samples, seed=int(state))
            radiance += np.array(picture)[:, :, 0]
            watch(done / passes)
        if self._scene.optic.onwards < 0:  # seen from below, x goes to the left
            radiance = radiance[:, ::-1]
        # Scattered evenly into the half-sphere.
        irradiance = math.pi / passes * radiance
        flux = np.asarray(irradiance * self._pixel_area / emitted)
        return self._picture.light(flux, self._scene.receiver)

    def _body(self, heights: Mapping[str, Array]) -> dict[str, Any]:
        """Both faces of the lens, and what swallows light beside it or out of its sides."""
        optic, nets = self._scene.optic, freeform_nets(self._scene.optic)
        (u, v), outline = _grid(nets[optic.designed_face]), outline_of(optic)
        x, y, z, slope_x, slope_y = nets[optic.designed_face].over(
            outline, u, v, heights[optic.designed_face]
        )
        exit_face = _stacked(x, y, z) / self._unit
        if "entrance" in nets:
            _, _, z, *slopes = nets["entrance"].over(outline, u, v, heights["entrance"])
        else:
            z, slopes = np.full(z.shape, optic.front_z), [np.zeros_like(x), np.zeros_like(x)]
        entrance = _stacked(x, y, z) / self._unit
        normals = _stacked(slopes[0], slopes[1], -1.0)
        index = np.arange(z.size).reshape(z.shape)
        rim = np.concatenate([index[:-1, 0], index[-1, :-1], index[:0:-1, -1], index[0, ::-1]])
        foot, top = (places.reshape(-1, 3)[rim] for places in (entrance, exit_face))
        glass = self._mi.load_dict({"type": "dielectric", "int_ior": optic.index, "ext_ior": 1.0})
        black = self._mi.load_dict(_BLACK)
        body = {
            "exit": self._mesh(exit_face, glass, _stacked(-slope_x, -slope_y, 1.0)),
            "entrance": self._mesh(entrance[:, ::-1], glass, normals[:, ::-1]),
            "walls": self._mesh(np.stack([foot, top], axis=1), black),
        }
        # At the plane that light has to pass within the outline, and about the rim of the entrance
        # face, past which it would go by the lens.
        levels = {optic.front_z / self._unit, float(min(foot[:, 2].max(), top[:, 2].min()))}
        for number, level in enumerate(levels):
            body |= self._baffle(level, number)
            if outline.whole:
                continue
            # Black out to the bounding rectangle, where the baffle begins.
            box = _stacked(*Rectangle(optic.half_width).from_square(u[:, None], v), 0.0)
            around = box.reshape(-1, 3)[rim] / self._unit + [0, 0, level]
            frame = np.stack([around, foot * [1, 1, 0] + [0, 0, level]], axis=1)
            body[f"frame{number}"] = self._mesh(frame, black)
        return body

    def _mirror(self, heights: Mapping[str, Array]) -> dict[str, Any]:
        """The face, which reflects; its back is met by no light."""
        optic, net = self._scene.optic, ControlNet.of(self._scene.optic)
        u, v = _grid(net)
        x, y, z, slope_x, slope_y = net.over(outline_of(optic), u, v, heights[optic.designed_face])
        reflectance = optic.reflectance if isinstance(optic, Mirror) else 1.0
        metal = self._mi.load_dict(
            {
                "type": "twosided",
                "bsdf": {
                    "type": "conductor",
                    "material": "none",
                    "specular_reflectance": {"type": "rgb", "value": reflectance},
                },
            }
        )
        normals = _stacked(-slope_x, -slope_y, 1.0)
        return {"mirror": self._mesh(_stacked(x, y, z) / self._unit, metal, normals)}

    def _mesh(self, places: Array, material: Any, normals: Array | None = None) -> Any:
        """Places of shape (m, n, 3) as triangles; counterclockwise if they run along x and y."""
        triangles = _triangles(places.shape[0], places.shape[1])
        properties = self._mi.Properties()
        properties["bsdf"] = material
        mesh = self._mi.Mesh(
            "",
            places.size // 3,
            len(triangles),
            props=properties,
            has_vertex_normals=normals is not None,
        )
        content = self._mi.traverse(mesh)
        content["vertex_positions"] = places.astype(np.float32).ravel()
        content["faces"] = triangles.ravel()
        if normals is not None:
            unit = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
            content["vertex_normals"] = unit.astype(np.float32).ravel()
        content.update()
        return mesh

    def _baffle(self, z: float, which: int) -> dict[str, Any]:
        """Black rectangles around that of the lens, at a height in Mitsuba's unit."""
        r_x, r_y = (r / self._unit for r in self._scene.optic.half_width)
        to = self._mi.ScalarTransform4f
        wide, beside_x, beside_y = _BAFFLE, (r_x + _BAFFLE) / 2, (r_y + _BAFFLE) / 2
        return {
            f"baffle{which}{number}": {
                "type": "rectangle",
                "to_world": to().translate([x, y, z]).scale([half_x, half_y, 1]),
                "bsdf": _BLACK,
            }
            for number, (x, y, half_x, half_y) in enumerate(
                [
                    (-beside_x, 0, (wide - r_x) / 2, wide),
                    (beside_x, 0, (wide - r_x) / 2, wide),
                    (0, -beside_y, r_x, (wide - r_y) / 2),
                    (0, beside_y, r_x, (wide - r_y) / 2),
                ]
            )
        }

    def _screen(self) -> dict[str, Any]:
        screen = self._picture.screen
        r_x, r_y = (r / self._unit for r in screen.half_width)
        to_world = np.eye(4)
        to_world[:3, :3] = screen.sides.T * [r_x, r_y, 1.0]
        to_world[:3, 3] = np.array(screen.position) / self._unit
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
        middle, r_x = np.array(screen.position) / self._unit, screen.half_width[0] / self._unit
        _, up, across = screen.sides
        behind = middle + _AWAY * r_x * self._scene.optic.onwards * across
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


_Make = Callable[[MitsubaScene, Mapping[str, Array]], dict[str, Any]]
_BODIES: Mapping[type, tuple[_Make, int]] = {
    Lens: (MitsubaScene._body, 4),
    Mirror: (MitsubaScene._mirror, 4),
}
"""What stands for an optic, and segments of the way: source, faces, screen, camera.

From a mirror light may go through the sheet that it came from."""


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


def _grid(net: ControlNet) -> list[Array]:
    """Places in [-1, 1] along each axis; knots of the net are among them."""
    spans = [n - p for n, p in zip(net.shape, net.degree, strict=True)]
    return [np.linspace(-1, 1, count * -(-_CELLS // count) + 1) for count in spans]


def _stacked(x: Any, y: Any, z: Any) -> Array:
    return np.stack(np.broadcast_arrays(x, y, z), axis=-1).astype(np.float64)


def _triangles(rows: int, columns: int) -> Indices:
    """Two for each cell of a grid of vertices."""
    index = np.arange(rows * columns, dtype=np.uint32).reshape(rows, columns)
    a, b = index[:-1, :-1].ravel(), index[1:, :-1].ravel()
    c, d = index[1:, 1:].ravel(), index[:-1, 1:].ravel()
    return np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
