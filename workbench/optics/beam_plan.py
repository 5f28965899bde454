"""Beams of light of a scene, ready to be traced through lens after lens."""

import torch
from torch import Tensor

from workbench.geometry.surface import ControlNet
from workbench.optics.account import Account
from workbench.optics.beams import beam_image
from workbench.optics.kernels import ready
from workbench.optics.light import BeamTracer, Light
from workbench.optics.path import Path
from workbench.optics.plan import device_of
from workbench.optics.precision import precision_of
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners
from workbench.optics.ways import beam_kernel_of
from workbench.scene import Scene


class BeamPlan:
    """Images of beams, by fused kernels where there are some, else by the torch reference.

    Parameters
    ----------
    scene : Scene
        What is traced.
    cells : tuple[int, int]
        Cells along x and y between the rays of each point of the source.
    net : ControlNet, optional
        Control net of the heights to come; the scene's own by default.
    dtype : torch.dtype, optional
        Float type of the trace; by default the one that the scene needs, see `precision_of`.
    fused : bool
        False asks for the reference.

    Raises
    ------
    Refused
        If the scene asks for a device that is not there.
    """

    def __init__(
        self,
        scene: Scene,
        cells: tuple[int, int],
        net: ControlNet | None = None,
        dtype: torch.dtype | None = None,
        fused: bool = True,
    ) -> None:
        net = net or ControlNet.of(scene.lens)
        self._dtype, device = dtype or precision_of(scene, net), device_of(scene)
        self._pixels, self._fused = scene.screen.pixels, fused and device.type == "cpu"
        path = Path.of(scene, net, self._dtype, device, Corners(*cells))
        self._splits = path.emitter.splits
        self._missed = path.steps[0].missed
        kernel = beam_kernel_of(path)
        compiled = self._fused and kernel is not None and ready.obtain(kernel.name, self._dtype)
        self._tracer: BeamTracer = kernel(path) if kernel and compiled else Reference(path)

    def trace(self, heights: Tensor, margin: tuple[int, int] = (0, 0)) -> Light:
        """Image and light account of a lens.

        Parameters
        ----------
        heights : Tensor, shape (n_u, n_v)
            Control heights, scene units.
        margin : tuple[int, int]
            Pixels (m_x, m_y) that the image has beyond the screen on each side.

        Returns
        -------
        Light
            With an image of shape (n_y + 2 m_y, n_x + 2 m_x).
        """
        hits, account = self._tracer.nodes(heights)
        (n_x, n_y), (m_x, m_y) = self._pixels, margin
        shift = hits.new_tensor([m_x, m_y, 0.0])[:, None, None]
        wide = (n_x + 2 * m_x, n_y + 2 * m_y)
        image, landed = beam_image(hits + shift, wide, self._splits, self._fused)
        on_screen = image.detach()[m_y : m_y + n_y, m_x : m_x + n_x].sum(dtype=torch.float64).item()
        lost = dict(account.lost)
        lost["off_screen"] += landed - on_screen
        # Of a cell of which some rays are refracted, the rest stands for all.
        lost["total_reflection"] += account.on_screen - landed
        # Light that no ray stands for passes the lens by.
        lost[self._missed] += 1 - account.on_screen - sum(account.lost.values())
        return Light(image, Account(on_screen, lost))
