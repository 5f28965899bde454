"""Icons, example scenes, target images and measured lights that ship with the program."""

from dataclasses import dataclass
from importlib import resources
from pathlib import Path


def path(*parts: str) -> Path:
    """Where a shipped file lies, in a source tree as well as in an installed wheel.

    Parameters
    ----------
    *parts : str
        Folder and file name below this package, such as ``"icons", "start.svg"``.
    """
    return Path(str(resources.files(__name__).joinpath(*parts)))


@dataclass(frozen=True)
class Example:
    """An example scene.

    Attributes
    ----------
    name : str
        Its file is ``examples/{name}.json``.
    group : str
        What it belongs to.
    title : str
        What a person reads; no other example has it.
    look : str
        What to look for: one sentence.
    dock : str
        The window's dock that shows it, if it is not there from the start.
    """

    name: str
    group: str
    title: str
    look: str
    dock: str = ""

    @property
    def file(self) -> Path:
        """The scene file."""
        return path("examples", f"{self.name}.json")


_FIRST = "First lenses"
_FINE = "First lenses, twice as fine"
_NETWORKS = "Top hat: networks and starts"
_SIZES = "Flame and ball: magnifications"
_SOURCES = "Flame: point and extended source"
_RECEIVERS = "Walls and streets"
_TWO_FACES = "Two freeform faces"
_TRAINS = "Several elements"
_DERIVATIVES = "Derivative maps of a flat lens"
_LIGHTS = "Real lights"

EXAMPLES = (
    Example(
        "tophat", _FIRST, "Top hat", "A uniform disc of light; see how soon its edge is sharp."
    ),
    Example(
        "flame", _FIRST, "Flame", "A flame-like logo on black; see light leave what shall be dark."
    ),
    Example(
        "ball", _FIRST, "Ball", "A faceted ball; see whether each grey comes out evenly bright."
    ),
    Example(
        "photo",
        _FIRST,
        "Photograph",
        "Every grey from black to white; see texture and shadow come.",
    ),
    Example(
        "letter", _FIRST, "Letter", "A bold letter on black; see its straight edges and corners."
    ),
    Example(
        "flame-512",
        _FINE,
        "Flame, 512 × 512",
        "The flame with four times the detail; see its thin parts.",
    ),
    Example(
        "ball-512",
        _FINE,
        "Ball, 512 × 512",
        "The ball with four times the detail; see the facets' edges.",
    ),
    Example(
        "tophat-none-zeros",
        _NETWORKS,
        "No network, flat start",
        "The yardstick for the three networks: a smooth lens that keeps the target's symmetry.",
    ),
    Example(
        "tophat-sparse-uniform",
        _NETWORKS,
        "Sparse network, faint start",
        "Weights a ten-thousandth off zero; compare speed and symmetry with no network.",
    ),
    Example(
        "tophat-sparse-random",
        _NETWORKS,
        "Sparse network, random start",
        "A rough initial lens; see how much of its roughness remains at the end.",
    ),
    Example(
        "tophat-dense-uniform",
        _NETWORKS,
        "Dense network, faint start",
        "Two million weights for a thousand heights; compare loss and time with the sparse one.",
    ),
    Example(
        "sun-plate",
        _LIGHTS,
        "Sun plate",
        "Acrylic to hold into the sun, whose disc blurs by 4.7 mm: compare error and bound.",
    ),
    Example(
        "phone-torch",
        _LIGHTS,
        "Phone torch",
        "The LED of a telephone, close to the lens, blurs the letter's edges.",
    ),
    Example(
        "led-rectangle",
        _LIGHTS,
        "LED to a rectangle",
        "Light as wide as can be bent; see what is totally reflected, and how even the rest is.",
    ),
    Example(
        "beam-shaper",
        _LIGHTS,
        "Beam shaper",
        "A Gaussian laser beam becomes an even disc; see that hardly any light is lost.",
    ),
    Example(
        "measured-led",
        _LIGHTS,
        "Measured LED",
        "A file of 9,000 rays lights the lens; see how their grain shows in the check.",
    ),
    Example(
        "white-light",
        _LIGHTS,
        "White light",
        "Polycarbonate turns blue light more than red; see coloured edges in the predicted photo.",
    ),
    *(
        Example(
            f"{shape}-x{magnification}",
            _SIZES,
            f"{shape.capitalize()}, magnification {magnification}",
            look,
        )
        for shape in ("flame", "ball")
        for magnification, look in (
            (1, "A screen as large as the lens, far away: a few hundredths of height do it all."),
            (3, "The concave base just fills the screen; see the corners, where rays are steep."),
            (5, "Steeper still: compare the loss, and the light beside the screen, with 1 and 3."),
        )
    ),
    Example(
        "flame-point",
        _SOURCES,
        "Point source",
        "Light from one point; see in the light account how much of the cone passes the square "
        "lens by.",
    ),
    Example(
        "flame-grid",
        _SOURCES,
        "Extended source of 25 × 25 points",
        "The flame is put together from images of the square source: details smaller than these "
        "stay blurred.",
    ),
    Example(
        "flame-stages",
        _SOURCES,
        "Point source, then the extended one",
        "The loss jumps when the extended source takes over at iteration 200; see what is won "
        "back.",
    ),
    Example(
        "wall-washer",
        _RECEIVERS,
        "Wall washer",
        "A picture on a wall that leans away from the lamp; see that it comes out straight.",
    ),
    Example(
        "street-light",
        _RECEIVERS,
        "Street light",
        "An LED's IES file; see intensity rise to both ends, so that the road below is even.",
    ),
    Example(
        "mirror-letter",
        _RECEIVERS,
        "Mirror: letter on a wall",
        "Sunlight from below, thrown back to a wall beside it; see the mirror lean towards it.",
    ),
    Example(
        "mirror-photo",
        _RECEIVERS,
        "Mirror: photograph beside the lamp",
        "Light from one point, drawn on a screen beside that point; see what misses the mirror.",
    ),
    Example(
        "thin-plate",
        _TWO_FACES,
        "Photograph from a thin plate",
        "Both faces bend the light; compare their slopes with those of one face alone.",
    ),
    Example(
        "wide-angle",
        _TWO_FACES,
        "Wide angle: disc from a near point",
        "Light comes in at up to 60°; see how little of what is in the glass leaves by the side.",
    ),
    Example(
        "led-dome",
        _TWO_FACES,
        "LED close by: square through a dome",
        "The entrance face comes towards the LED in its middle; compare with a flat one.",
    ),
    Example(
        "two-distances",
        _TWO_FACES,
        "Photograph at two distances",
        "Thick glass moves the light, its exit face makes it parallel; compare both images.",
    ),
    Example(
        "dome-cover",
        _TRAINS,
        "LED with dome, freeform lens and cover plate",
        "The lens is designed with the dome before it and the plate behind it; see the rays.",
    ),
    Example(
        "led-collimator",
        _TRAINS,
        "Collimated LED and freeform plate",
        "A stock lens makes the light parallel, a thin plate forms the letter; see its soft edges.",
    ),
    Example(
        "one-lens",
        _TRAINS,
        "Wide photograph by one lens",
        "One face bends light by up to 47°; see in the light account what is reflected.",
    ),
    Example(
        "two-lenses",
        _TRAINS,
        "Wide photograph by two lenses",
        "Each lens bends light by about half; compare error and light account with one lens.",
    ),
    Example(
        "diffuser-screen",
        _TRAINS,
        "Diffuser before the screen",
        "A film 4 mm before the screen blurs the letter; see the lens sharpen what the film blurs.",
    ),
    Example(
        "diffuser-lens",
        _TRAINS,
        "Diffuser behind the lens",
        "A film that scatters by 0.3° blurs over 1 mm at the screen; compare with the photograph.",
    ),
    Example(
        "fold-mirror",
        _TRAINS,
        "Fold mirror",
        "A plane mirror turns the light by 90° before the freeform lens; see the folded axis.",
    ),
    Example(
        "mirror-and-lens",
        _TRAINS,
        "Mirror and lens",
        "The mirror is designed for the light behind a stock lens; see where the rays cross it.",
    ),
    Example(
        "tilted-lens",
        _TRAINS,
        "Tilted lens",
        "The lens is tilted and shifted, and is designed as it stands; see the image come out "
        "straight.",
    ),
    *(
        Example(
            f"derivative-degree{degree}-filter{size}",
            _DERIVATIVES,
            f"Degrees ({degree}, 3), filter {size} × {size}",
            look,
            dock="derivative",
        )
        for degree, size, look in (
            (3, 3, "As a control point rises it gathers light: a mountain in a valley, sum zero."),
            (3, 11, "The same mountain, smoother: each ray's light is spread over 11 × 11 pixels."),
            (5, 3, "Wider along x: the valley meets the screen's border, and the sum leaves zero."),
        )
    ),
)
"""All example scenes, in the order in which menus show them."""
