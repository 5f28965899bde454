"""What pictures have in common that are drawn once and then changed."""

from matplotlib.artist import Artist


class UpdatedPicture:
    """A picture on axes that the caller owns.

    Its ``update`` shows something else, and returns whether more than `artists` changed, so that
    the whole figure has to be drawn.

    Attributes
    ----------
    artists : list of matplotlib.artist.Artist
        What ``update`` changes; the caller may blit them.
    """

    artists: list[Artist]
