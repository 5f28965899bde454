"""Forms bound to the parts of a scene."""
