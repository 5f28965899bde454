"""Manufacturing processes: what each leaves of a face, as a small description in the scene."""
