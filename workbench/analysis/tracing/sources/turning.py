"""How a lamp of a file is turned in the scene."""

from scipy.spatial.transform import Rotation


def file_axes(degrees: tuple[float, float, float]) -> Rotation:
    """Return the rotation about x, new y and new z from the axes of a file to the scene's."""
    return Rotation.from_euler("XYZ", degrees, degrees=True)
