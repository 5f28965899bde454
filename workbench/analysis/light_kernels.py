"""Loops of the independent trace over rays: from points through the entrance face."""

import math

from numba import njit


@njit(cache=True, nogil=True, error_model="numpy")
def enter(  # type: ignore[no-untyped-def]
    points, axes, number, a, b, upwards, entrance, half_width, index, start, direction, flux
):
    """Emit rays into cones and refract those that meet the entrance face.

    Directions are uniform in solid angle around axes whose length is the cosine of the rim. They
    are made around +z and mirrored onto the axis, in the plane halfway between the two.

    Parameters
    ----------
    points, axes : array, shape (k, 3)
        Where light comes from, and the axes of the cones.
    number : array of int64, shape (m,)
        Which of the points each ray comes from.
    a, b : array, shape (m,)
        Places in [0, 1]²: from axis to rim, and around.
    upwards : array, shape (3,)
        Flux goes with the cosine to this vector; 0 for light that is even.
    entrance, half_width, index
        Entrance face: height, half-widths (2,), refractive index behind it.
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
        point = number[ray]
        x, y, z = axes[point, 0], axes[point, 1], axes[point, 2]
        rim = math.sqrt(x * x + y * y + z * z)
        x, y, z = x / rim, y / rim, z / rim + 1
        cosine = 1 - a[ray] * (1 - rim)
        sine, azimuth = math.sqrt(max(1 - cosine * cosine, 0.0)), 2 * math.pi * b[ray]
        d_x, d_y, d_z = sine * math.cos(azimuth), sine * math.sin(azimuth), cosine
        share = 2 * (d_x * x + d_y * y + d_z * z) / (x * x + y * y + z * z)
        d_x, d_y, d_z = share * x - d_x, share * y - d_y, share * z - d_z

        power = 1.0
        if lambertian:
            power = max(d_x * upwards[0] + d_y * upwards[1] + d_z * upwards[2], 0.0)
        emitted += power
        far = (entrance - points[point, 2]) / d_z
        x, y = points[point, 0] + d_x * far, points[point, 1] + d_y * far
        if d_z <= 0 or abs(x) > half_width[0] or abs(y) > half_width[1]:
            missed += power
            continue
        loss = power * (head_on + (1 - head_on) * (1 - d_z) ** 5)
        reflected += loss
        start[entered, 0], start[entered, 1] = x, y
        # Snell's law at a face across z: sines are divided by the index.
        d_x, d_y = d_x / index, d_y / index
        direction[entered, 0], direction[entered, 1] = d_x, d_y
        direction[entered, 2] = math.sqrt(1 - d_x * d_x - d_y * d_y)
        flux[entered] = power - loss
        entered += 1
    return entered, emitted, missed, reflected
