"""What a shop asks of freeform faces, as a term that a run minimises besides the image's error.

It is there only if a scene asks for it: ``run.smoothness`` weighs how much the face bends,
``run.min_radius`` keeps it from bending more sharply than a tool can follow, and
``run.min_tool_radius``, or milling among the processes, keeps its hollows, as seen from outside,
wide enough for a ball cutter.
"""

from collections.abc import Mapping

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.lens_state import Step
from workbench.design.loss import share
from workbench.geometry.basis import basis_matrix
from workbench.geometry.curvature import mean_and_gaussian
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.scene import Scene

# The descent keeps to a radius that is larger by this part: a penalty gives a little, and bends
# between the places that are looked at can be sharper.
_RESERVE = 0.08
# Price of sharper bends: a face that is everywhere twice as sharp as allowed costs this much.
_PRICE = 1e4
# Part of the largest allowed curvature that rounds off where the two principal ones are equal.
_UMBILIC = 1e-3


class Smoothness:
    """Penalty of the faces of a lens for their bends; dimensionless, the same in any unit.

    `scene`: the design task, which asks something of bends; `target` (n_y, n_x):
    the wanted image in any scale; `device`: where the heights are. `faces`: the freeform faces by
    their names.
    """

    def __init__(self, scene: Scene, target: Array, device: torch.device) -> None:
        run = scene.run
        self.faces = {}
        for element in scene.elements:
            for face, net in freeform_nets(element).items():
                x, y = net.positions
                base = element.place_of(face, x[:, None], y[None, :])
                self.faces[face] = FaceCurvature(net, base, device, element.outwards(face))
        self._weight, self._radius = run.smoothness or 0.0, run.min_radius
        self._tool = scene.bends.get("min_tool_radius")
        wanted = share(target)
        self._loss_of_1 = float(np.sqrt(np.square(wanted).mean()))

    @classmethod
    def of(cls, scene: Scene, target: Array, device: torch.device) -> "Smoothness | None":
        """The penalty that a scene asks for, if it asks for one."""
        return cls(scene, target, device) if scene.bends else None

    def penalty(self, heights: Mapping[str, Tensor]) -> Tensor:
        """What is added to the square of the image's relative error.

        `heights` (n_u, n_v).
        """
        penalty = torch.zeros((), dtype=torch.float64)
        for face, curvature in self.faces.items():
            if self._weight:
                penalty = penalty + self._weight * curvature.bending(heights[face])
            if self._radius is not None:
                violation = curvature.curvature_violation(
                    heights[face], self._radius * (1 + _RESERVE)
                )
                penalty = penalty + _PRICE * violation
            if self._tool is not None:
                violation = curvature.concavity_violation(
                    heights[face], self._tool * (1 + _RESERVE)
                )
                penalty = penalty + _PRICE * violation
        return penalty

    def merit(self, loss: Tensor, penalty: Tensor) -> Tensor:
        """Loss and penalty as one number, in the measure of the loss: the best lens has the least.

        `loss`: Paper's loss of the image; `penalty`: of the same lens.
        """
        return (loss.double().square() + self._loss_of_1**2 * penalty).sqrt()

    def judged(self, step: Step, penalty: Tensor) -> Step:
        """A step with its merit."""
        if step.merit is not None:
            return step  # no light is on the screen
        merit = self.merit(torch.tensor(step.state.loss), penalty.detach())
        return step._replace(merit=merit.item())


class FaceCurvature:
    """How much a face bends, and how sharply.

    `net`: where its control heights sit; `base` (n_u, n_v): control heights from which its bending
    is counted; `device`: where the heights are; `outward`: 1 if it is seen from +z, -1 if from -z.
    """

    def __init__(self, net: ControlNet, base: Array, device: torch.device, outward: int) -> None:
        self._outward = outward
        self._base = torch.as_tensor(base, device=device)
        self._products = [_products(net, axis, device) for axis in (0, 1)]
        self._derivatives = [_derivatives(net, axis, device) for axis in (0, 1)]

    def bending(self, heights: Tensor) -> Tensor:
        """Bending energy ∫ (d_xx² + 2 d_xy² + d_yy²) dx dy of the deviation d from the base.

        Exact: the products of basis functions are integrated by Gauss's rule, span by span. The
        energy is that of a thin plate of unit stiffness and has no unit.
        """
        d = heights - self._base
        along_x, along_y = self._products
        return sum(
            (
                factor * (d * (along_x[m] @ d @ along_y[2 - m])).sum()
                for m, factor in ((0, 1.0), (1, 2.0), (2, 1.0))
            ),
            start=heights.new_zeros(()),
        )

    def curvature_violation(self, heights: Tensor, radius: float) -> Tensor:
        """Mean square by which the principal curvatures exceed 1 / ``radius``, relative to that.

        Looked at where knot lines cross and halfway between: second derivatives of cubics are
        largest on knot lines.
        """
        mean, apart = self._curvatures(heights, radius)
        # The principal curvatures are mean ± apart, both at most mean.abs() + apart.
        return ((mean.abs() + apart) * radius - 1).clamp_min(0).square().mean()

    def concavity_violation(self, heights: Tensor, radius: float) -> Tensor:
        """As `curvature_violation`, of hollows alone: where the face bends outwards."""
        mean, apart = self._curvatures(heights, radius)
        return ((self._outward * mean + apart) * radius - 1).clamp_min(0).square().mean()

    def _curvatures(self, heights: Tensor, radius: float) -> tuple[Tensor, Tensor]:
        """Mean curvature towards +z, and how far the principal ones are from it."""
        along_x, along_y = self._derivatives
        p, q, r, s, t = (
            along_x[i] @ heights @ along_y[j].T for i, j in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
        )
        mean, gauss = mean_and_gaussian(p, q, r, s, t)
        return mean, ((mean * mean - gauss).clamp_min(0) + (_UMBILIC / radius) ** 2).sqrt()


def _products(net: ControlNet, axis: int, device: torch.device) -> list[Tensor]:
    """Integrals of all products of two basis functions' derivatives of order 0, 1, 2 along an axis.

    Shape (n, n) each; scene units.
    """
    knots, degree, r = net.knots[axis], net.degree[axis], net.half_width[axis]
    spans = net.shape[axis] - degree
    nodes, weights = np.polynomial.legendre.leggauss(degree + 1)
    places = ((np.arange(spans)[:, None] + (nodes + 1) / 2) / spans).ravel()
    lengths = np.tile(weights * (r / spans), spans)
    basis = [basis_matrix(knots, degree, places, derivative=m) / (2 * r) ** m for m in range(3)]
    return [torch.as_tensor(b.T @ (lengths[:, None] * b), device=device) for b in basis]


def _derivatives(net: ControlNet, axis: int, device: torch.device) -> list[Tensor]:
    """Derivatives of order 0, 1, 2 of the basis functions at knots and halfway, scene units."""
    knots, degree, r = net.knots[axis], net.degree[axis], net.half_width[axis]
    places = np.linspace(0, 1, 2 * (net.shape[axis] - degree) + 1)
    return [
        torch.as_tensor(basis_matrix(knots, degree, places, derivative=m) / (2 * r) ** m).to(device)
        for m in range(3)
    ]
