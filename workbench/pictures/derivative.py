"""Derivative of the irradiance with respect to one control height, as an image."""

from typing import TYPE_CHECKING

import numpy as np
from matplotlib import colormaps

from workbench.arrays import Array
from workbench.pictures.images import receiver_map
from workbench.pictures.maps import SIGNED, colour_bar
from workbench.pictures.updated import UpdatedPicture
from workbench.scene import Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_UNAFFECTED = "#a8a8a8"  # neither of the colours of gain and loss, nor their white


class DerivativeImage(UpdatedPicture):
    """A derivative map on axes that the caller owns.

    Gains are red, losses blue; what the control point does not reach is grey. The scale is
    symmetric about zero and no wider than the map: losses are faint beside the gains already.
    """

    def __init__(self, axes: "Axes", scene: Scene) -> None:
        colours = colormaps[SIGNED].with_extremes(bad=_UNAFFECTED)
        self._image = receiver_map(axes, "derivative", scene, colours)
        self._scale = 1.0
        self._image.set_clim(-self._scale, self._scale)
        density = scene.receiver.density_words(scene.unit)
        colour_bar(axes, self._image, f"{density} per {scene.unit}", extend="neither")
        self.update(None)
        self.artists = [self._image]

    def update(self, derivative: Array | None) -> bool:
        """Show another map.

        Parameters
        ----------
        derivative : ndarray, shape (n_y, n_x), optional
            Flux per area per scene unit of height; None for none.
        """
        if derivative is None:
            derivative = np.zeros(self._image.get_array().shape)
        self._image.set_data(np.ma.masked_equal(derivative, 0))
        scale = float(np.abs(derivative).max()) or 1.0
        if scale == self._scale:
            return False
        self._scale = scale
        self._image.set_clim(-scale, scale)
        return True
