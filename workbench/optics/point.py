"""Light of point sources, through the flat entrance face to the exit face and on to the screen."""

import numpy as np
import torch
from torch import Tensor

from workbench.geometry.patches import Patches
from workbench.geometry.surface import ControlNet
from workbench.optics.emission import InLens, emit, enter
from workbench.optics.hits import Hits
from workbench.optics.intersection import Bundle, ExactIntersection
from workbench.optics.mesh import MeshIntersection, TriangleMesh
from workbench.optics.refraction import refract, schlick_transmittance
from workbench.scene import CollimatedSource, GridSource, MeshMethod, PointSource, Scene


class PointRays:
    """One set of rays, with everything that does not depend on the control heights.

    Parameters
    ----------
    scene : Scene
        The scene; source kind "point" or "grid".
    net : ControlNet
        Where the control heights sit.
    in_lens : InLens, optional
        Rays behind the entrance face; those of the scene's source by default.
    dtype, device
        Float type and device of the trace.
    """

    emitted = 1.0

    def __init__(
        self,
        scene: Scene,
        net: ControlNet,
        in_lens: InLens | None = None,
        dtype: torch.dtype = torch.float32,
        device: torch.device | str = "cpu",
    ) -> None:
        self._scene, self.screen = scene, scene.screen
        self._dtype, self._device = dtype, device
        self._patches = Patches(net, dtype, device)
        how = None if isinstance(scene.source, CollimatedSource) else scene.source.intersection
        self._mesh = (
            TriangleMesh(net, how.subdivisions, dtype, device)
            if isinstance(how, MeshMethod)
            else None
        )
        self._draw = 0
        self._load(self._drawn() if in_lens is None else in_lens)

    def redraw(self) -> None:
        """Take another sample of the source's rays."""
        self._draw += 1
        self._load(self._drawn())

    def trace(self, heights: Tensor) -> Hits:
        """Follow the rays from the entrance face to the screen plane.

        Parameters
        ----------
        heights : Tensor, shape (n_u, n_v)
            Control heights, float64 or the trace's float type.
        """
        scene, bundle, patches = self._scene, self.bundle, self._patches
        # Counted from the entrance face, float32 keeps the digits that make the shape.
        heights = (heights - scene.lens.entrance_z).to(self._dtype)
        table = patches.table(heights)
        met = self._intersection.meet(heights, table)
        x = bundle.x + bundle.slope_x * met.depth
        y = bundle.y + bundle.slope_y * met.depth
        _, face_x, face_y = patches.evaluate(table, patches.place(x, y))

        length = (face_x.square() + face_y.square() + 1).rsqrt()
        normal = (-face_x * length, -face_y * length, length)
        out = refract(self._direction, normal, scene.lens.index)
        out_x, out_y, out_z = out.direction
        # A face that folds light back, or sideways for ever, sends it past any screen.
        onward = out_z > 1e-6
        path = (scene.screen.z - scene.lens.entrance_z - met.depth) / torch.where(onward, out_z, 1)
        reaches = met.found & out.passes & onward
        weight = bundle.flux * schlick_transmittance(out.cos_out, scene.lens.index)
        return Hits(
            x=torch.where(reaches, x + out_x * path, torch.inf),
            y=torch.where(reaches, y + out_y * path, torch.inf),
            weight=torch.where(met.found & out.passes, weight, 0.0),
            arriving=torch.where(met.found, bundle.flux, 0.0),
            passes=out.passes,
            left_side=torch.where(met.found, 0.0, bundle.flux).sum(dtype=torch.float64),
        )

    def depths(self, heights: Tensor) -> Tensor:
        """Where the rays leave the lens, by face or side, above the entrance face, shape (m,)."""
        heights = (heights - self._scene.lens.entrance_z).to(self._dtype)
        return self._intersection.meet(heights, self._patches.table(heights)).depth

    def _drawn(self) -> InLens:
        scene = self._scene
        assert isinstance(scene.source, (PointSource, GridSource))
        return enter(emit(scene.source, scene.lens, scene.run.seed, self._draw), scene.lens)

    def _load(self, rays: InLens) -> None:
        self.missed_lens, self.fresnel_entrance = rays.missed, rays.reflected

        def constant(values: np.ndarray) -> Tensor:
            return torch.as_tensor(values, dtype=self._dtype, device=self._device)

        parts = (rays.x, rays.y, rays.slope_x, rays.slope_y, rays.flux)
        self.bundle = Bundle(*map(constant, parts))
        self._intersection: ExactIntersection | MeshIntersection
        if self._mesh:
            self._intersection = MeshIntersection(self.bundle, self._mesh)
        else:
            self._intersection = ExactIntersection(
                self.bundle, self._scene.lens.half_width, self._patches
            )
        cos = 1 / np.sqrt(1 + rays.slope_x**2 + rays.slope_y**2)
        direction = rays.slope_x * cos, rays.slope_y * cos, cos
        self._direction = constant(direction[0]), constant(direction[1]), constant(direction[2])
