"""How a lamp of a file is turned in the scene."""

from scipy.spatial.transform import Rotation


def file_axes(degrees: tuple[float, float, float]) -> Rotation:
    """The turn about x, then about y, then about z: from the axes of a file to the scene's."""
    return Rotation.from_euler("xyz", degrees, degrees=True)
