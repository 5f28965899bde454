"""Trains of all kinds, and what comparisons of their traces start from."""

import math
from typing import NamedTuple

import numpy as np
import torch

from tests.scenes import changed
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Ellipse, Rectangle
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Reflection, Refraction, TransmittanceLaw, laws_of
from workbench.optics.path import Path
from workbench.optics.receivers import PlaneReceiver
from workbench.optics.samples import Corners
from workbench.optics.sources import Origins
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Conic, Plane
from workbench.scene import Scene

INDEX = 1.6
SQUARE = Rectangle((1.0, 1.0))
# Light along +z goes to +y behind a mirror in this frame, into elements in that one.
FOLD, ASIDE = (45.0, 0.0, 0.0), (-90.0, 0.0, 0.0)


class Light(NamedTuple):
    """An emitter as far as samples of a face need one."""

    origins: Origins
    samples: Corners


def from_far(count, spread, tilt=(0.0, 0.0), waist=math.inf, seed=0):
    """Directions within a cone about a tilted axis, radians, of equal flux."""
    angle = np.random.default_rng(seed).uniform(-spread, spread, (2, count))
    x, y = (np.sin(tilt[axis] + angle[axis]) for axis in (0, 1))
    places = np.stack([x, y, np.sqrt(1 - x**2 - y**2)], axis=1)
    return Origins(places, True, np.full(count, 0.25 / count), waist=waist)


def from_near(count, middle, spread, lambertian=False, seed=0):
    """Points within a square across the axis, of equal flux."""
    aside = np.random.default_rng(seed).uniform(-spread, spread, (count, 2))
    places = np.column_stack([middle[:2] + aside, np.full(count, middle[2])])
    return Origins(places, False, np.full(count, 1 / (2 * math.pi * count)), lambertian)


LIGHTS = {
    "directions": from_far(3, 0.03, (0.1, -0.05)),
    "beam": from_far(3, 0.05, waist=0.7),
    "points": from_near(3, (0.1, 0, -3), 0.3, lambertian=True),
}


def all_losses(**changes):
    """The small scene with all losses of a lens and a wide screen."""
    losses = {"lens.reflection": "fresnel", "lens.absorption": 0.2, "version": 2}
    return Scene.from_data(changed(losses | {"screen.half_width": [3, 3]} | changes))


def plate(outline, front, back, index=INDEX, absorption=0.1):
    """A fixed or freeform lens between two faces."""
    into = Refraction(TransmittanceLaw.fresnel(1 / index), "fresnel_entrance")
    leaving = Refraction(TransmittanceLaw.fresnel(index), "fresnel_exit", absorption)
    return [FaceStep(front, into, "missed_lens"), FaceStep(back, leaving, "left_side")]


def window(front, back, outline, **options):
    """A plate between two planes."""
    return plate(outline, Plane("front", front, outline), Plane("back", back, outline), **options)


def conics(outline, front, back):
    """A lens of conics, each given by z, curvature and conic constant."""
    return plate(outline, Conic("front", *front, outline), Conic("back", *back, outline))


def in_frame(steps, position, tilt=(0.0, 0.0, 0.0)):
    """Faces of one element, with z of its own."""
    frame = Frame.at(position, tilt)
    return [step._replace(frame=frame) for step in steps]


def second(dtype, outline=SQUARE):
    """A lens with a conic front and a freeform back, in its own coordinates."""
    net = ControlNet((6, 5), (2, 3), (1.0, 1.0))
    back = BSplineSurface("second", net, 0.0, dtype, outline=outline, level=0.7)
    return plate(outline, Conic("front", 0.0, 0.2, -0.5, outline), back)


def asphere(outline=SQUARE):
    front = Conic("front", 0.0, 0.3, -0.7, outline, [0.05, -0.02, 0.003])
    return plate(outline, front, Conic("back", 0.4, 0.0, 0.0, outline, [-0.03, 0.0, 0.01]))


def mirror(surface, position, tilt, reflectance=0.9):
    step = FaceStep(surface, Reflection(reflectance, "absorbed_mirror"), "missed_mirror")
    return in_frame([step], position, tilt)


class TurnedTo(PlaneReceiver):
    """A screen in a frame, as elements are."""

    def __init__(self, screen, frame, datum=0.0):
        super().__init__(screen, datum)
        frame = Frame(frame.position - [0, 0, datum], frame.rotation)
        self._right, self._up, self._away = (tuple(map(float, each)) for each in frame.rotation.T)
        self._middle = tuple(map(float, frame.position))

    def numbers(self):
        (r_x, r_y), (n_x, n_y) = self.part.half_width, self.part.pixels
        column, row = np.array(self._right) * n_x / (2 * r_x), np.array(self._up) * -n_y / (2 * r_y)
        return super().numbers()._replace(column=tuple(column), row=tuple(row))


def train(scene, light, cells, behind=(), screen=None, dtype=torch.float64):
    """The path of a scene in given light, with further elements behind its lens."""
    flat = Path.of(scene, ControlNet.of(scene.optic), dtype)
    receiver = TurnedTo(scene.receiver, Frame.at(*screen), flat.datum) if screen else flat.receiver
    steps = [*flat.steps, *behind]
    return Path(Light(light, Corners(*cells)), steps, receiver, flat.datum, flat.outline, 0, dtype)


def before(scene, light, cells, fixed, outline, front_z=-2.0, dtype=torch.float64):
    """The path of a scene with fixed faces before its lens; ``fixed(datum)`` makes them."""
    flat = Path.of(scene, ControlNet.of(scene.optic), dtype)
    emitter, steps = Light(light, Corners(*cells)), [*fixed(flat.datum), *flat.steps]
    return Path(emitter, steps, flat.receiver, flat.datum, outline, 0, dtype, front_z=front_z)


def two_faces(scene, light, cells, dtype=torch.float64):
    """The path of a scene with a B-spline in place of its flat entrance face."""
    flat = Path.of(scene, ControlNet.of(scene.optic), dtype)
    net, level = ControlNet((5, 6), (3, 2), scene.optic.half_width), scene.optic.entrance_z
    surface = BSplineSurface(
        "lens.front", net, flat.datum, dtype, outline=flat.outline, level=level
    )
    law, _ = laws_of(scene.optic)
    steps = FaceStep(surface, Refraction(law, "fresnel_entrance"), "missed_lens"), flat.steps[1]
    emitter, given = Light(light, Corners(*cells)), (flat.receiver, flat.datum, flat.outline, 0)
    return Path(emitter, steps, *given, dtype, front_z=level - 0.007)  # the aperture


def biconvex(datum, outline):
    return conics(outline, (-2.0 - datum, 0.2, -0.5), (-1.2 - datum, -0.25, 0.3))


def _freeform_mirror(dtype):
    """A freeform mirror that light meets from behind, and a lens in the light that comes back."""
    net = ControlNet((6, 5), (2, 3), (1.0, 1.0))
    surface = BSplineSurface("second", net, 0.0, dtype, outline=Ellipse((0.9, 0.8)), level=0.7)
    (step,) = mirror(surface, (0.05, 0.0, 2.5), (160.0, 10.0, 5.0))
    lens = in_frame(asphere(), (0.0, -0.85, 1.1), (140.0, 0.0, 0.0))
    return [step.facing(step.frame.position), *lens]


def _second_on_the_axis(datum, dtype, outline):
    """A lens with a plane front and a freeform back that counts z as the scene does."""
    net = ControlNet((6, 5), (2, 3), (1.0, 1.0))
    back = BSplineSurface("second", net, datum, dtype, outline=outline, level=2.2)
    return plate(outline, Plane("front", 1.2, outline), back)


BEHIND = {
    "lens": lambda *_: [],
    "plate": lambda datum, dtype, outline: window(0.7, 1.1, outline),
    "conics": lambda datum, dtype, outline: conics(outline, (0.9, 0.3, -0.5), (1.5, -0.4, 0.7)),
    "second lens": _second_on_the_axis,
    "plate and second lens": lambda *given: [
        *window(0.7, 1.1, given[2]),
        *_second_on_the_axis(*given),
    ],
    "tilted and shifted": lambda datum, dtype, outline: in_frame(
        second(dtype), (0.1, -0.2, 1.2), (12.0, -8.0, 30.0)
    ),
    "fold": lambda datum, dtype, outline: [
        *mirror(Plane("mirror", 0.0, Rectangle((1.2, 1.6))), (0, 0, 1.5), FOLD),
        *in_frame(second(dtype), (0, 1.6, 1.5), ASIDE),
    ],
    "asphere": lambda *_: in_frame(asphere(), (0.0, 0.1, 0.9), (0.0, 5.0, 0.0)),
    "asphere on the axis": lambda *_: in_frame(asphere(), (0.0, 0.0, 0.9)),
    "outlines": lambda datum, dtype, outline: [
        *in_frame(asphere(Ellipse((0.9, 0.6))), (0.1, 0.0, 0.9)),
        *in_frame(second(dtype, Rectangle((0.5, 0.8))), (0.0, 0.1, 1.6), (0.0, 0.0, 20.0)),
    ],
    "mirror from behind": lambda datum, dtype, outline: _freeform_mirror(dtype),
}
"""Elements behind the lens, by its datum, the float type and the outline."""

# Where the light of some of them goes.
SCREENS = {
    "fold": ((0, 6, 1.5), ASIDE),
    "mirror from behind": ((0, -3.2, -1.7), (140.0, 0.0, 0.0)),
}

BEFORE = {
    "plate before": (Ellipse((1.5, 1.4)), lambda d, o: window(-2.0 - d, -1.6 - d, o)),
    "biconvex before": (Ellipse((0.9, 0.8)), biconvex),
    "biconvex and plate before": (
        Rectangle((0.9, 0.8)),
        lambda d, o: [*biconvex(d, o), *window(-0.8 - d, -0.5 - d, o)],
    ),
}
"""Fixed elements before the lens, with their outline."""

MIRROR_FIRST = {
    "mirror": {"half_width": [1.0, 0.8], "control_points": [9, 7], "reflectance": 0.9},
    "source": {"kind": "collimated"},
    "screen": {"z": -6.0, "half_width": [3.0, 3.0], "pixels": [32, 32]},
    "target": {"builtin": "tophat"},
}


def _before_tilted_lens(light, cells, dtype):
    """The first face is that of a mirror."""
    lens = in_frame(second(dtype), (0.1, 0.2, -1.5), (175.0, 5.0, 20.0))
    return train(Scene.from_data(MIRROR_FIRST | {"version": 2}), light, cells, lens, dtype=dtype)


def _to_directions(onwards, light, cells, dtype):
    """One mirror sends light to −z and aside; the second one, if there is one, to +z again."""
    far_field = {"half_angle": [60, 50], "center": [5, 10], "pixels": [40, 30]}
    changes = {"screen": None, "far_field": far_field, "lens.absorption": 0.2, "version": 2}
    flat = Plane("mirror", 0.0, Rectangle((1.5, 1.5)))
    behind = mirror(flat, (0, 0, 1.6), (10.0, -5.0, 0.0))
    if onwards > 0:
        behind += mirror(flat, (0.2, 0.4, 0.2), (190.0, 10.0, 0.0))
    path = train(Scene.from_data(changed(changes)), light, cells, behind, dtype=dtype)
    path.receiver._onwards = onwards
    return path


OTHERS = {
    "two faces": lambda light, cells, dtype: two_faces(all_losses(), light, cells, dtype),
    "mirror before a tilted lens": _before_tilted_lens,
    "directions behind a mirror": lambda *given: _to_directions(-1, *given),
    "directions behind two mirrors": lambda *given: _to_directions(1, *given),
}

NAMES = [*BEHIND, *BEFORE, *OTHERS]


def path_of(name, light, cells, dtype=torch.float64, outline="rectangle"):
    """The path of one of the trains of this file in one of its lights."""
    origins, scene = LIGHTS[light], all_losses(**{"lens.outline": outline})
    if name in BEHIND:
        flat = Path.of(scene, ControlNet.of(scene.optic), dtype)
        behind = BEHIND[name](flat.datum, dtype, flat.outline)
        return train(scene, origins, cells, behind, SCREENS.get(name), dtype)
    if name in BEFORE:
        if light == "points":
            origins = from_near(3, (0.1, 0, -5), 0.3, lambertian=True)
        own, fixed = BEFORE[name]
        return before(scene, origins, cells, lambda datum: fixed(datum, own), own, dtype=dtype)
    return OTHERS[name](origins, cells, dtype)


def heights_of(path, seed=1, amplitude=0.01):
    """Control heights of all freeform faces of a path, about their levels."""
    rng, found = np.random.default_rng(seed), {}
    for surface in (step.surface for step in path.shaped if step.surface.freeform):
        level = -surface.level if surface.behind else surface.level
        noise = rng.normal(size=surface.net.shape)
        found[surface.name] = torch.tensor(level + amplitude * noise)
    return found


def level_faces(scene):
    """Heights of a plate that lets light along the axis pass straight on."""
    return {"lens.back": torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64)}


def cotangent_of(path, seed=0):
    corners, count = path.emitter.samples, len(path.emitter.origins.flux)
    shape = 4, count * (corners.y + 1), corners.x + 1
    return torch.tensor(np.random.default_rng(seed).normal(size=shape))


def landed(tracer, heights, cotangent):
    """Nodes within the rims, their account, and gradients of a product with a cotangent."""
    leaves = {name: each.clone().requires_grad_() for name, each in heights.items()}
    hits, account, rim = tracer.nodes(leaves)
    lands = hits.isfinite().all(dim=0) & (hits[2] > 0)
    rim = torch.zeros_like(hits[2]) if rim is None else rim
    hits = torch.cat([hits, rim[None]])
    weighed = torch.where(lands, hits, 0.0) * torch.where(lands, cotangent, 0.0)
    gradients = torch.autograd.grad(weighed.sum(), list(leaves.values()))
    return torch.where(lands, hits.detach(), 0.0), account.to_data(), gradients
