"""Faces, sources and losses of one's own, in torch: rays through them, and gradients by any number.

All numbers may be tensors: control heights, radii, refractive indices, the place of the source, the
distance of the screen. Whatever is computed from the rays or from their image has a gradient by
them. Nothing is compiled, so that a trace takes some ten times as long as one of a design.

A face is a function z = sag(x, y) in `Sag`, a source is a function that returns `rays`, a loss is a
function of the image. What has the methods of `workbench.optics.surfaces.Surface`,
`workbench.optics.interfaces.Interface` or `workbench.optics.sources.Emitter` serves as well.

Examples
--------
A sphere of glass focuses light; its focal length, and how it changes with the index:

>>> import torch
>>> index, radius = torch.tensor([1.5, 20.0], requires_grad=True, dtype=torch.float64)
>>> def light():
...     x = torch.tensor([0.01], dtype=torch.float64)
...     return rays(x, 0 * x, -5.0, flux=1.0)
>>> def front(x, y):
...     r2 = x**2 + y**2
...     return r2 / (radius + (radius**2 - r2).sqrt())
>>> inside = trace(light, [refracting(Sag(front, Rectangle((1, 1))), 1.0, index)], at(50.0)).rays
>>> (x, _, z), (d_x, _, d_z) = inside.position, inside.direction
>>> focal_length = (z - x / d_x * d_z).sum()
>>> round(focal_length.item(), 3)  # n R / (n − 1)
60.0
>>> change, = torch.autograd.grad(focal_length, index)
>>> round(change.item(), 2)  # −R / (n − 1)²
-80.0
"""

from collections.abc import Callable, Mapping, Sequence
from typing import cast

import torch
from torch import Tensor

from workbench.design.loss import paper_loss
from workbench.geometry.outlines import Ellipse, Outline, Rectangle
from workbench.geometry.surface import ControlNet
from workbench.optics.images import reconstruct
from workbench.optics.interfaces import Passed, Reflection, Refraction, TransmittanceLaw
from workbench.optics.path import Path
from workbench.optics.rays import Arrival, RayBundle, Vector
from workbench.optics.receivers import Receiver
from workbench.optics.sources import Emitter
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Meeting, Surface
from workbench.optics.surfaces.sag import Sag
from workbench.scene import Filter, GaussianFilter

__all__ = [
    "Arrival",
    "ControlNet",
    "Ellipse",
    "Rectangle",
    "Sag",
    "Screen",
    "at",
    "bspline",
    "image",
    "paper_loss",
    "rays",
    "reflecting",
    "refracting",
    "trace",
]

Number = float | Tensor
Rays = Callable[[], RayBundle]


def rays(
    x: Tensor,
    y: Tensor,
    z: Number,
    direction: tuple[Number, Number, Number] = (0.0, 0.0, 1.0),
    flux: Number = 1.0,
) -> RayBundle:
    """Rays of a source, for `trace`.

    Parameters
    ----------
    x, y : Tensor, shape (m,)
        Where they start.
    z : float or Tensor
        Where they start along the axis; light goes to +z.
    direction : tuple of three floats or Tensors
        Where they go, of any length.
    flux : float or Tensor
        Flux of all together, or of each: the fluxes are scaled so that their sum is 1.
    """
    like = torch.as_tensor(x)
    parts = [torch.as_tensor(part, dtype=like.dtype) for part in (x, y, z, *direction, flux)]
    x, y, z, d_x, d_y, d_z, flux = (part.expand(like.shape) for part in parts)
    length = (d_x.square() + d_y.square() + d_z.square()).sqrt()
    alive = torch.ones(like.shape, dtype=torch.bool)
    return RayBundle(
        (x, y, z), (d_x / length, d_y / length, d_z / length), flux / flux.sum(), alive
    )


def bspline(name: str, net: ControlNet, outline: Outline | None = None) -> BSplineSurface:
    """A freeform face, whose control heights (n_u, n_v) `trace` takes by its name.

    Parameters
    ----------
    name : str
        What its heights are called.
    net : ControlNet
        Numbers of control points, degrees and half-widths.
    outline : Outline, optional
        What of it is glass; the rectangle of the net by default.
    """
    return BSplineSurface(name, net, 0.0, torch.float64, outline=outline)


def refracting(surface: Surface, before: Number, behind: Number) -> FaceStep:
    """A face between media of two refractive indices; bare faces reflect by Fresnel's equations."""
    return FaceStep(surface, _Between(before, behind), f"missed {surface.name}")


def reflecting(surface: Surface, reflectance: float = 1.0) -> FaceStep:
    """A mirror; light goes on to −z, where `at` may count it."""
    return FaceStep(surface, Reflection(reflectance, "absorbed"), f"missed {surface.name}")


class Screen:
    """A plane across the axis on which light makes an image; a `Receiver`.

    Parameters
    ----------
    z : float or Tensor
        Where it stands.
    half_width : tuple[float, float]
        Half of its extent along x and y.
    pixels : tuple[int, int]
        Along x and y.
    center : tuple of two floats or Tensors
        x and y of its middle.
    """

    def __init__(
        self,
        z: Number,
        half_width: tuple[float, float],
        pixels: tuple[int, int],
        center: tuple[Number, Number] = (0.0, 0.0),
    ) -> None:
        self.z, self.half_width, self.pixels, self.center = z, half_width, pixels, center

    def places(self, rays: RayBundle) -> tuple[Tensor, Tensor]:
        """Columns and rows where rays land; infinite for those that never do."""
        (x, y, _), there = self.ends(rays), rays.alive & (rays.direction[2] != 0)
        (r_x, r_y), (n_x, n_y) = self.half_width, self.pixels
        column = ((x - self.center[0]) / r_x + 1) * n_x / 2
        row = (1 - (y - self.center[1]) / r_y) * n_y / 2
        return torch.where(there, column, torch.inf), torch.where(there, row, torch.inf)

    def ends(self, rays: RayBundle) -> Vector:
        """Where rays meet the plane."""
        (x, y, z), (d_x, d_y, d_z) = rays.position, rays.direction
        way = (self.z - z) / torch.where(d_z == 0, 1.0, d_z)
        return x + way * d_x, y + way * d_y, z + way * d_z


def at(z: Number) -> Screen:
    """A screen of no certain size, for figures of the rays alone."""
    return Screen(z, (1.0, 1.0), (1, 1))


def trace(
    source: Rays,
    faces: Sequence[FaceStep],
    screen: Screen,
    heights: Mapping[str, Tensor] | None = None,
) -> Arrival:
    """Follow the rays of a source through faces to a screen.

    Parameters
    ----------
    source : callable
        Returns `rays`; it is called at each trace.
    faces : sequence of FaceStep
        In the order in which light meets them; see `refracting` and `reflecting`.
    screen : Screen
        Where the light is wanted.
    heights : mapping of str to Tensor
        Control heights (n_u, n_v) of each `bspline` by its name, as z.

    Returns
    -------
    Arrival
        Columns and rows where rays land, the rays behind the last face, and the flux lost, by
        name.
    """
    outline = faces[0].surface.outline
    # A walk needs less than a scene of an emitter and of a receiver.
    emitter, receiver = cast(Emitter, _Source(source)), cast(Receiver, screen)
    path = Path(emitter, faces, receiver, 0.0, outline, 0, torch.float64)
    return path.walk(heights or {})


def image(arrival: Arrival, screen: Screen, filter: Filter | None = None) -> Tensor:
    """Flux in each pixel of a screen, shape (n_y, n_x), row 0 at +y.

    Parameters
    ----------
    arrival : Arrival
        See `trace`.
    screen : Screen
        The same as of the trace.
    filter : BoxFilter or GaussianFilter, optional
        How the flux of a ray is shared among pixels; by default over 3 × 3, which has a gradient.
    """
    return reconstruct(
        arrival.column, arrival.row, arrival.rays.flux, screen.pixels, filter or GaussianFilter()
    )


class _Between:
    """Refraction between two indices, which may be tensors; an `Interface`."""

    compiled = False

    def __init__(self, before: Number, behind: Number) -> None:
        self.before, self.behind = before, behind

    def turn(self, rays: RayBundle, meeting: Meeting) -> Passed:
        # A tensor serves as a number in the formulas of a law.
        law = TransmittanceLaw.fresnel(self.before / self.behind)  # type: ignore[arg-type]
        return Refraction(law, "reflected").turn(rays, meeting)


class _Source:
    """Rays of a function; an `Emitter`, as far as a walk needs one."""

    by_area = True  # faces find for themselves what passes them by

    def __init__(self, source: Rays) -> None:
        self._source = source

    def rays(self, seed: int, draw: int = 0) -> RayBundle:
        return self._source()
