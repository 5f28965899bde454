"""What a camera would see on the screen: the image in colour, traced at several wavelengths."""
