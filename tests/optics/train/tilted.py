"""Tilted and shifted elements for tests of trains."""

import numpy as np
import torch

from tests.optics.train.test_behind_glass import Light, from_far, from_near
from tests.optics.train.test_elements import faces, plate
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Rectangle
from workbench.geometry.surface import ControlNet
from workbench.optics.interfaces import Reflection
from workbench.optics.path import Path
from workbench.optics.receivers import PlaneReceiver
from workbench.optics.samples import Corners
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Conic, Plane

LIGHTS = {
    "directions": from_far(3, 0.03, (0.1, -0.05)),
    "points": from_near(3, (0.1, 0, -3), 0.3, lambertian=True),
}
SQUARE = Rectangle((1.0, 1.0))
# Light along +z goes to +y behind a mirror in this frame, into elements in that one.
FOLD, ASIDE = (45.0, 0.0, 0.0), (-90.0, 0.0, 0.0)


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


def folded(dtype, outline=SQUARE):
    flat = Plane("mirror", 0.0, Rectangle((1.2, 1.6)))
    return [
        *mirror(flat, (0, 0, 1.5), FOLD),
        *in_frame(second(dtype, outline), (0, 1.6, 1.5), ASIDE),
    ]


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


def train(scene, light, cells, behind, screen=None, dtype=torch.float64):
    """The path of a scene with further elements behind its lens."""
    flat = Path.of(scene, ControlNet.of(scene.optic), dtype)
    receiver = TurnedTo(scene.receiver, Frame.at(*screen), flat.datum) if screen else flat.receiver
    steps = [*flat.steps, *behind]
    return Path(Light(light, Corners(*cells)), steps, receiver, flat.datum, flat.outline, 0, dtype)


def own_faces(scene, seed=1):
    """Heights of both freeform faces; of the second in its own coordinates."""
    return faces(scene, seed) | {"second": own_second(seed)}


def own_second(seed):
    noise = np.random.default_rng(seed).normal(size=(6, 5))
    return torch.tensor(0.7 + 0.01 * noise)


def level_faces(scene):
    """Heights of a plate that lets light along the axis pass straight on."""
    return {"lens.back": torch.full(scene.optic.net_shape, 0.5, dtype=torch.float64)}
