"""Loops over rays of the check's tracer, but for those over B-splines; see `spline_kernels`."""

import math

from workbench.compiled import jit

_SCHLICK, _CONSTANT, _FRESNEL = range(3)
LAWS = {"schlick": _SCHLICK, "constant": _CONSTANT, "fresnel": _FRESNEL}
"""Laws of reflectance by name."""
RIM2 = 1 + 1e-12
"""Sum of the squares of x and y over the semi-axes of an ellipse on its rim, with rounding."""


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


@jit(error_model="numpy")
def meet_plane(  # type: ignore[no-untyped-def]
    position, direction, flux, z, half_width, curved, place, met
):
    """Get places (m, 3) and the flux (m,) that meets a plane at z within an outline."""
    r_x, r_y = half_width
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        d_z = direction[ray * step, 2]
        path = (z - position[ray, 2]) / d_z
        x = position[ray, 0] + path * direction[ray * step, 0]
        y = position[ray, 1] + path * direction[ray * step, 1]
        across, up = x / r_x, y / r_y
        within = across * across + up * up <= RIM2 if curved else abs(x) <= r_x and abs(y) <= r_y
        if d_z > 0 and within:
            place[ray, 0], place[ray, 1], place[ray, 2] = x, y, z
            met[ray] = flux[ray]
        else:
            met[ray] = 0.0


@jit(error_model="numpy")
def refract(direction, normal, flux, face, turned, passed, total):  # type: ignore[no-untyped-def]
    """Get directions (m, 3) and flux (m,) behind a face.

    Parameters
    ----------
    direction, normal : array, shape (m, 3) or (1, 3)
        Unit vectors before the face, and of the face.
    flux : array, shape (m,)
        Flux before it; rays that have none are left as they are.
    face : tuple of float, int, float
        Refractive index before the face over that behind it, the law of its reflectance, and that
        at normal incidence.
    turned, passed, total : array, shapes (m, 3), (m,), (m,)
        Get direction and flux behind it, and the flux that is totally reflected.
    """
    ratio, law, head_on = face
    step, step_n = int(direction.shape[0] > 1), int(normal.shape[0] > 1)
    for ray in range(len(flux)):
        passed[ray] = total[ray] = 0.0
        if flux[ray] == 0:
            continue
        k, k_n = ray * step, ray * step_n
        d_x, d_y, d_z = direction[k, 0], direction[k, 1], direction[k, 2]
        n_x, n_y, n_z = normal[k_n, 0], normal[k_n, 1], normal[k_n, 2]
        # Snell's law changes the angle between ray and normal, in the plane that holds both.
        along = d_x * n_x + d_y * n_y + d_z * n_z
        a_x, a_y, a_z = d_x - along * n_x, d_y - along * n_y, d_z - along * n_z
        sine = ratio * math.sqrt(a_x * a_x + a_y * a_y + a_z * a_z)
        if sine >= 1 or along <= 0:
            total[ray] = flux[ray]
            continue
        cosine = math.sqrt((1 - sine) * (1 + sine))
        turned[ray, 0] = cosine * n_x + ratio * a_x
        turned[ray, 1] = cosine * n_y + ratio * a_y
        turned[ray, 2] = cosine * n_z + ratio * a_z
        reflectance = head_on
        if law == _SCHLICK:
            # Schlick (1994), eq. 24: the cosine is that in the thinner medium.
            thinner = cosine if ratio > 1 else along
            reflectance += (1 - head_on) * (1 - thinner) ** 5
        elif law == _FRESNEL:
            across = (ratio * along - cosine) / (ratio * along + cosine)
            within = (along - ratio * cosine) / (along + ratio * cosine)
            reflectance = (across * across + within * within) / 2
        passed[ray] = flux[ray] * (1 - reflectance)


@jit(error_model="numpy")
def count_on_planes(  # type: ignore[no-untyped-def]
    position, direction, flux, turn, shift, planes, pixels, image, beside
):
    """Add flux to pixels.

    Parameters
    ----------
    position, direction, flux
        The rays, see `TracedRays`.
    turn, shift : array, shapes (3, 3) and (3,)
        From the lens to the scene.
    planes : array, shape (k, 4, 3)
        Where screens are; see `PlaneDetector`.
    pixels : tuple[int, int]
        Along x and y.
    image, beside : array, shapes (k, n_y n_x), (k,)
        Get the flux in the pixels and that beside each screen added.
    """
    n_x, n_y = pixels
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] == 0:
            continue
        start, way = _in_scene(turn, shift, position[ray], direction[ray * step])
        for plane in range(len(planes)):
            column, row = _column_and_row(start, way, planes[plane], pixels)
            # Also not a number, of a ray along the screen, is not in there.
            if 0 <= column < n_x and 0 <= row < n_y:
                image[plane, int(row) * n_x + int(column)] += flux[ray]
            else:
                beside[plane] += flux[ray]


@jit(error_model="numpy")
def hits_on_plane(position, direction, flux, turn, shift, plane, pixels, places):  # type: ignore[no-untyped-def]
    """Get columns and rows, shape (m, 2), on one screen; see `count_on_planes`."""
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] == 0:
            continue
        start, way = _in_scene(turn, shift, position[ray], direction[ray * step])
        places[ray, 0], places[ray, 1] = _column_and_row(start, way, plane, pixels)


@jit(error_model="numpy", inline="always")  # a call costs as much
def _in_scene(turn, shift, position, direction):  # type: ignore[no-untyped-def]
    """Position and direction of a ray in the scene."""
    return _turned(turn, position, shift), _turned(turn, direction, (0.0, 0.0, 0.0))


@jit(error_model="numpy", inline="always")  # a call costs as much
def _turned(turn, vector, shift):  # type: ignore[no-untyped-def]
    """A vector in the scene."""
    x, y, z = vector[0], vector[1], vector[2]
    return (
        turn[0, 0] * x + turn[0, 1] * y + turn[0, 2] * z + shift[0],
        turn[1, 0] * x + turn[1, 1] * y + turn[1, 2] * z + shift[1],
        turn[2, 0] * x + turn[2, 1] * y + turn[2, 2] * z + shift[2],
    )


@jit(error_model="numpy", inline="always")  # a call costs as much
def _column_and_row(start, way, plane, pixels):  # type: ignore[no-untyped-def]
    """Column and row where a ray meets a screen; not finite where it does not."""
    ahead = along = 0.0
    for k in range(3):
        ahead += (plane[0, k] - start[k]) * plane[1, k]
        along += way[k] * plane[1, k]
    path = ahead / along if along > 0 or ahead * along > 0 else math.inf
    column = row = 0.0
    for k in range(3):
        from_middle = start[k] + way[k] * path - plane[0, k]
        column += from_middle * plane[2, k]
        row += from_middle * plane[3, k]
    return column + pixels[0] / 2, row + pixels[1] / 2


@jit(error_model="numpy")
def count_directions(direction, flux, turn, scales, pixels, image, beside):  # type: ignore[no-untyped-def]
    """Add flux to pixels; for the parameters see `count_on_planes`."""
    n_x, n_y = pixels
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] == 0:
            continue
        for far_field in range(len(scales)):
            column, row = _pixel(turn, direction[ray * step], scales[far_field])
            if 0 <= column < n_x and 0 <= row < n_y:
                image[far_field, int(row) * n_x + int(column)] += flux[ray]
            else:
                beside[far_field] += flux[ray]


@jit(error_model="numpy")
def hits_of_directions(direction, flux, turn, scale, places):  # type: ignore[no-untyped-def]
    """Get columns and rows, shape (m, 2)."""
    step = int(direction.shape[0] > 1)
    for ray in range(len(flux)):
        if flux[ray] != 0:
            places[ray, 0], places[ray, 1] = _pixel(turn, direction[ray * step], scale)


@jit(error_model="numpy", inline="always")
def _pixel(turn, way, scale):  # type: ignore[no-untyped-def]
    """Column and row of a direction; not finite where it goes back."""
    x, y, z = way[0], way[1], way[2]
    d_x = turn[0, 0] * x + turn[0, 1] * y + turn[0, 2] * z
    d_y = turn[1, 0] * x + turn[1, 1] * y + turn[1, 2] * z
    d_z = turn[2, 0] * x + turn[2, 1] * y + turn[2, 2] * z
    if d_z <= 0:
        return math.inf, math.inf
    return (
        scale[0, 0] * math.atan2(d_x, d_z) + scale[0, 1],
        scale[1, 0] * math.atan2(d_y, math.hypot(d_x, d_z)) + scale[1, 1],
    )
