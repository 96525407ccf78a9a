"""Checks the world coordinates of a.fits, an image of a black hole, and of its part b.fits, with astropy."""

import numpy as np
from astropy import constants, units
from astropy.io import fits
from astropy.wcs import WCS
from astropy.wcs.utils import proj_plane_pixel_scales

hdus = fits.open("a.fits")
sky = WCS(hdus[0].header).celestial
across, up = proj_plane_pixel_scales(sky) * units.deg
assert np.isclose(across, up, rtol=1e-12)

# The shadow is a disk of 2 sqrt(27) M.
shadow = (1 - hdus[0].data[0].astype(float)).sum()
diameter = (2 * np.sqrt(shadow / np.pi) * across).to(units.uas)
mass = constants.G * 4.3e6 * constants.M_sun / constants.c**2
expected = (2 * np.sqrt(27) * mass / (8.2 * units.kpc)).to(units.uas, equivalencies=units.dimensionless_angles())
print(diameter, expected)
assert abs(diameter / expected - 1) < 1e-4

# The center of the image is at the origin, north is up, and east is left.
height, width = hdus[0].data.shape[1:]
center = sky.pixel_to_world((width - 1) / 2, (height - 1) / 2)
assert np.hypot(center.ra.wrap_at("180d").uas, center.dec.uas) < 1e-6
corner = sky.pixel_to_world(0, height - 1)
assert corner.ra.wrap_at("180d") > 0 and corner.dec > 0

# A part has the coordinates of the whole: its first column and its last row from the top.
part = WCS(fits.open("b.fits")["DEPTH"].header)
here, there = part.pixel_to_world(0, 0), sky.pixel_to_world(150, height - 130)
assert here.separation(there).uas < 1e-3

# Lengths have a unit, and other layers have none.
assert np.isclose(units.Unit(hdus["DEPTH"].header["BUNIT"]).to(units.m), mass.to_value(units.m), rtol=1e-5)
assert "BUNIT" not in hdus["STEPS"].header
