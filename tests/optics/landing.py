"""Where light lands on a screen in lengths, from the pixels in which the tracers count."""

from workbench.optics.images import reconstruct


def places_of(arrival, screen):
    """x and y on a screen of rays that have arrived."""
    (r_x, r_y), (n_x, n_y) = screen.half_width, screen.pixels
    return arrival.column * (2 * r_x / n_x) - r_x, r_y - arrival.row * (2 * r_y / n_y)


def image_at(x, y, weight, screen, filter):
    """The image of rays at places on a screen."""
    return reconstruct(*screen.to_pixels(x, y), weight, screen.pixels, filter)
