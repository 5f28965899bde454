"""How light is lost at any lens."""

from collections.abc import Mapping

from workbench.scene.losses import Loss

LENS_LOSSES: Mapping[str, Loss] = {
    "missed_lens": Loss(
        "Missed the lens",
        "Light that passes the entrance face by. The cone of a point source is round and just "
        "covers the rectangle around the face; of that, an elliptic lens leaves the corners open.",
        "misses the lens",
        "a larger lens catches it",
        always=True,
    ),
    "left_side": Loss(
        "Out of the side",
        "Light that entered the lens so slanted that it meets a side wall before the exit face.",
        "leaves by the side",
        "a thinner lens, or a source farther away or nearer to the axis, keeps it",
        always=True,
    ),
    "total_reflection": Loss(
        "Totally reflected",
        "Light that meets the exit face too steeply to leave the lens there.",
        "is totally reflected",
        "{flatter}thicker stock, a lower index or a target that needs less bending lets it out",
        always=True,
    ),
    "fresnel_entrance": Loss(
        "Reflected on entry",
        "The part that the entrance face reflects of the light that it refracts.",
        "is reflected at the entrance",
        "an antireflection coating, a lower index or a source nearer to the axis lets it in",
        always=True,
    ),
    "fresnel_exit": Loss(
        "Reflected on exit",
        "The part that the exit face reflects of the light that it refracts.",
        "is reflected at the exit",
        "an antireflection coating, {flatter}a lower index or a target that needs less bending "
        "lets it out",
        always=True,
    ),
}
