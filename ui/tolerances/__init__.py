"""What becomes of the image when the lens on show is a little off."""
