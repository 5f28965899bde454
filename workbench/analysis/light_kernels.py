"""Loops of the independent trace over rays: from points through the entrance face."""

import math

from workbench.compiled import jit


@jit(error_model="numpy")
def enter(  # type: ignore[no-untyped-def]
    axes,
    centres,
    distances,
    versines,
    number,
    a,
    b,
    upwards,
    half_width,
    index,
    start,
    direction,
    flux,
):
    """Emit rays into cones and refract those that meet the entrance face.

    Directions are uniform in solid angle. They are made around +z and mirrored onto the axis, in
    the plane halfway between the two. All points have the same intensity: a ray's flux goes with
    the solid angle of its cone.

    A ray is followed from where the axis of its cone crosses the plane of the face, not from its
    point, which may be so far that only the first digits of a way from there would be right.

    Parameters
    ----------
    axes, centres, distances, versines : array, shapes (k, 3), (k, 2), (k,), (k,)
        The cones, see `workbench.analysis.cones.Cones`.
    number : array of int64, shape (m,)
        Which of the cones each ray is in.
    a, b : array, shape (m,)
        Places in [0, 1]²: from axis to rim, and around.
    upwards : array, shape (3,)
        Flux goes with the cosine to this vector; 0 for light that is even.
    half_width, index
        Entrance face: half-widths (2,), refractive index behind it.
    start, direction, flux : array, shapes (m, 2), (m, 3), (m,)
        Get the rays that entered, one after the other.

    Returns
    -------
    entered : int
        How many these are.
    emitted, missed, reflected : float
        Flux of all rays, of those that missed the face, and of what it reflected.
    """
    lambertian = upwards[0] != 0 or upwards[1] != 0 or upwards[2] != 0
    head_on = ((index - 1) / (index + 1)) ** 2
    emitted = missed = reflected = 0.0
    entered = 0
    for ray in range(len(a)):
        cone = number[ray]
        x, y, z = axes[cone, 0], axes[cone, 1], axes[cone, 2]
        # 1 − cosine: of a far point the cosine itself has no digits left.
        versine = a[ray] * versines[cone]
        cosine, sine = 1 - versine, math.sqrt(versine * (2 - versine))
        azimuth = 2 * math.pi * b[ray]
        # Across the axis: (cos, sin, 0) of the azimuth in the mirror.
        w_x, w_y = math.cos(azimuth), math.sin(azimuth)
        share = (w_x * x + w_y * y) / (1 + z)
        w_x, w_y, w_z = share * x - w_x, share * y - w_y, share * (1 + z)
        d_x, d_y, d_z = cosine * x + sine * w_x, cosine * y + sine * w_y, cosine * z + sine * w_z

        power = versines[cone]
        if lambertian:
            power *= max(d_x * upwards[0] + d_y * upwards[1] + d_z * upwards[2], 0.0)
        emitted += power
        aside = distances[cone] * sine / d_z
        cross_x = centres[cone, 0] + aside * (z * w_x - w_z * x)
        cross_y = centres[cone, 1] + aside * (z * w_y - w_z * y)
        if d_z <= 0 or abs(cross_x) > half_width[0] or abs(cross_y) > half_width[1]:
            missed += power
            continue
        loss = power * (head_on + (1 - head_on) * (1 - d_z) ** 5)
        reflected += loss
        start[entered, 0], start[entered, 1] = cross_x, cross_y
        # Snell's law at a face across z: sines are divided by the index.
        d_x, d_y = d_x / index, d_y / index
        direction[entered, 0], direction[entered, 1] = d_x, d_y
        direction[entered, 2] = math.sqrt(1 - d_x * d_x - d_y * d_y)
        flux[entered] = power - loss
        entered += 1
    return entered, emitted, missed, reflected
