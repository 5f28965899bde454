"""Light of point sources, through the flat entrance face to the exit face and on to the screen."""

from typing import NamedTuple

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
from workbench.scene import CollimatedSource, ExactMethod, MeshMethod, Scene, of_points


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
        self._scene, self._net, self.screen = scene, net, scene.screen
        self._dtype, self._device = dtype, device
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
        scene, bundle, search = self._scene, self.bundle, self._search()
        patches = search.patches
        # Counted from the entrance face, float32 keeps the digits that make the shape.
        heights = (heights - scene.lens.entrance_z).to(self._dtype)
        table = patches.table(heights)
        met = search.intersection.meet(heights, table)
        x = bundle.x + bundle.slope_x * met.depth
        y = bundle.y + bundle.slope_y * met.depth
        _, face_x, face_y = patches.evaluate(table, patches.place(x, y))

        length = (face_x.square() + face_y.square() + 1).rsqrt()
        normal = (-face_x * length, -face_y * length, length)
        out = refract(search.direction, normal, scene.lens.index)
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
        search = self._search()
        return search.intersection.meet(heights, search.patches.table(heights)).depth

    def _drawn(self) -> InLens:
        scene = self._scene
        return enter(
            emit(of_points(scene.source), scene.lens, scene.run.seed, self._draw), scene.lens
        )

    def _load(self, rays: InLens) -> None:
        self.missed_lens, self.fresnel_entrance = rays.missed, rays.reflected

        def constant(values: np.ndarray) -> Tensor:
            return torch.as_tensor(values, dtype=self._dtype, device=self._device)

        parts = (rays.x, rays.y, rays.slope_x, rays.slope_y, rays.flux)
        self.bundle = Bundle(*map(constant, parts))
        self._searching: _Search | None = None

    def _search(self) -> "_Search":
        """What only a trace by torch needs; the kernel takes nothing but the bundle."""
        if self._searching is None:
            source = self._scene.source
            how = None if isinstance(source, CollimatedSource) else source.intersection
            self._searching = _Search.of(self.bundle, self._net, how)
        return self._searching


class _Search(NamedTuple):
    """What finds where rays meet the exit face."""

    patches: Patches
    intersection: ExactIntersection | MeshIntersection
    direction: tuple[Tensor, Tensor, Tensor]

    @classmethod
    def of(cls, bundle: Bundle, net: ControlNet, how: ExactMethod | MeshMethod | None) -> "_Search":
        """For some rays, by the method that a source asks for."""
        dtype, device = bundle.x.dtype, bundle.x.device
        patches = Patches(net, dtype, device)
        intersection: ExactIntersection | MeshIntersection
        if isinstance(how, MeshMethod):
            mesh = TriangleMesh(net, how.subdivisions, dtype, device)
            intersection = MeshIntersection(bundle, mesh)
        else:
            intersection = ExactIntersection(bundle, net.half_width, patches)
        slope_x, slope_y = bundle.slope_x.double(), bundle.slope_y.double()
        cos = (1 + slope_x.square() + slope_y.square()).rsqrt()
        x, y, z = ((part * cos).to(dtype) for part in (slope_x, slope_y, torch.ones_like(cos)))
        return cls(patches, intersection, (x, y, z))
