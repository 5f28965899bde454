"""The loop that emits rays into cones."""

import math

from workbench.compiled import jit


@jit(error_model="numpy")
def emit(cones, number, a, b, upwards, position, direction, flux):  # type: ignore[no-untyped-def]
    """Emit rays into cones.

    Directions are uniform in solid angle. They are made around +z and mirrored onto the axis, in
    the plane halfway between the two. All points have the same intensity: a ray's flux goes with
    the solid angle of its cone.

    Parameters
    ----------
    cones : Cones
        The cones.
    number : array of int64, shape (m,)
        Which of the cones each ray is in.
    a, b : array, shape (m,)
        Places in [0, 1]²: from axis to rim, and around.
    upwards : array, shape (3,)
        Flux goes with the cosine to this vector; 0 for light that is even.
    position, direction, flux : array, shapes (m, 3), (m, 3), (m,)
        Get the rays, where they cross the plane of the face: z = 0.
    """
    lambertian = upwards[0] != 0 or upwards[1] != 0 or upwards[2] != 0
    for ray in range(len(a)):
        cone = number[ray]
        x, y, z = cones.axis[cone, 0], cones.axis[cone, 1], cones.axis[cone, 2]
        # 1 − cosine: of a far point the cosine itself has no digits left.
        versine = a[ray] * cones.versine[cone]
        cosine, sine = 1 - versine, math.sqrt(versine * (2 - versine))
        azimuth = 2 * math.pi * b[ray]
        # Across the axis: (cos, sin, 0) of the azimuth in the mirror.
        w_x, w_y = math.cos(azimuth), math.sin(azimuth)
        share = (w_x * x + w_y * y) / (1 + z)
        w_x, w_y, w_z = share * x - w_x, share * y - w_y, share * (1 + z)
        d_x, d_y, d_z = cosine * x + sine * w_x, cosine * y + sine * w_y, cosine * z + sine * w_z

        power = cones.versine[cone]
        if lambertian:
            power *= max(d_x * upwards[0] + d_y * upwards[1] + d_z * upwards[2], 0.0)
        aside = cones.distance[cone] * sine / d_z
        position[ray, 0] = cones.centre[cone, 0] + aside * (z * w_x - w_z * x)
        position[ray, 1] = cones.centre[cone, 1] + aside * (z * w_y - w_z * y)
        position[ray, 2] = 0.0
        direction[ray, 0], direction[ray, 1], direction[ray, 2] = d_x, d_y, d_z
        flux[ray] = power
