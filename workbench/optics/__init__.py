"""Where the light goes: source, refraction, screen, irradiance, and an account of all flux."""
