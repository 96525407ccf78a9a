"""Draws milky_way.png, the light of the sky without its single stars, from the outlines of the Milky Way in five steps of brightness by
Jose R. Vieira, as d3-celestial has them: npm pack d3-celestial@0.7.35, then python3 milky_way.py package/data/mw.json milky_way.png.

Brightness is in stars of tenth magnitude per square degree (S10). White is 650 S10, or 5.4e-4 cd/m²; the outlines have no scale, so that
their steps are estimates (after Leinert et al., Astron. Astrophys. Suppl. 127, 1998). The map is equirectangular, in right ascension and
declination, as stars.png."""

import json
import sys

import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import distance_transform_edt, gaussian_filter, map_coordinates

WIDTH, HEIGHT = 2048, 1024  # halved at the end
PLANE, SPAN = 10240, 4.2  # a stereographic map from the galactic south pole, in which all outlines are closed
WHITE = 650.0


def unit(ra, dec):
    ra, dec = np.radians(ra), np.radians(dec)
    return np.stack([np.cos(dec) * np.cos(ra), np.cos(dec) * np.sin(ra), np.sin(dec)], -1)


north = unit(192.85948, 27.12825)
center = unit(266.40510, -28.93617)
center = center - (center @ north) * north
center /= np.linalg.norm(center)
galactic = np.stack([center, np.cross(north, center), north])


def to_plane(directions):
    d = directions @ galactic.T
    return (d[..., :2] / (1 + d[..., 2:]) + SPAN) / (2 * SPAN) * PLANE


def outlined(feature):
    inside = np.zeros((PLANE, PLANE), bool)
    for ring in (ring for polygon in feature["geometry"]["coordinates"] for ring in polygon):
        points = to_plane(unit(*np.array(ring).T))
        image = Image.new("1", (PLANE, PLANE))
        ImageDraw.Draw(image).polygon([tuple(point) for point in points], fill=1)
        inside ^= np.asarray(image)
    return inside


def distance_to(mask):
    """Returns the distance to the nearest pixel of the mask, in degrees of the map."""
    pad = WIDTH // 4
    wrapped = np.concatenate([mask[:, -pad:], mask, mask[:, :pad]], 1)
    return distance_transform_edt(~wrapped)[:, pad:-pad] * 360 / WIDTH


def blurred(values, degrees):
    return gaussian_filter(values, degrees * WIDTH / 360, mode=["nearest", "wrap"])


def smooth_level(level):
    """Interpolates between outlines by the distances to both; outside the first one the level falls by 1 in 7 degrees."""
    smooth = 1 - distance_to(level >= 1) / 7
    for step in range(1, 6):
        out = distance_to(level < step)
        further = np.minimum(distance_to(level > step), 7) if step < 5 else 2
        smooth = np.where(level == step, step + np.clip(out / (out + further), 0, 0.999), smooth)
    return smooth


def galaxies(directions):
    """Returns the Magellanic Clouds and the Andromeda galaxy as Gaussians of their total brightness."""
    light = 0
    for ra, dec, magnitude, major, minor, angle in [
        (80.9, -69.8, 0.4, 2.0, 2.0, 0),
        (13.2, -72.8, 2.2, 1.0, 1.0, 0),
        (10.68, 41.27, 3.4, 0.7, 0.25, 35),
    ]:
        d, turn = unit(ra, dec), np.radians(angle)
        east = np.cross([0, 0, 1], d) / np.linalg.norm(np.cross([0, 0, 1], d))
        x, y = np.degrees(directions @ east), np.degrees(directions @ np.cross(d, east))
        along, across = x * np.sin(turn) + y * np.cos(turn), x * np.cos(turn) - y * np.sin(turn)
        peak = 1e4 * 10 ** (-0.4 * magnitude) / (2 * np.pi * major * minor)
        shape = np.exp(-0.5 * ((along / major) ** 2 + (across / minor) ** 2))
        light = light + np.where(directions @ d > 0, peak * shape, 0)
    return light


ra = (0.5 - (np.arange(WIDTH) + 0.5) / WIDTH) * 360
dec = (0.5 - (np.arange(HEIGHT) + 0.5) / HEIGHT) * 180
directions = unit(*np.meshgrid(ra, dec))
plane = to_plane(directions)
outlines = sum(outlined(feature).astype(np.float32) for feature in json.load(open(sys.argv[1]))["features"])
level = np.rint(map_coordinates(outlines, [plane[..., 1], plane[..., 0]], order=1, mode="constant"))
steps = np.log([0.05, 18, 52, 115, 190, 290, 420, 600])
light = np.exp(np.interp(smooth_level(level), [-6, 0, 1, 2, 3, 4, 5, 6], steps))
band = 0.7 * blurred(light, 0.4) + 0.3 * blurred(light, 1.2)
d = directions @ galactic.T
longitude, latitude = np.degrees(np.arctan2(d[..., 1], d[..., 0])), np.degrees(np.arcsin(np.clip(d[..., 2], -1, 1)))
bulge = np.exp(-((longitude / 50) ** 2))
rest = 14 + 16 * np.exp(-abs(latitude) / 25) + 25 * np.exp(-abs(latitude) / 12) * bulge
# Old stars near the center are redder.
warm = (np.clip(blurred(band, 3) / 350, 0, 1) * np.exp(-((longitude / 60) ** 2)))[..., None]
color = np.concatenate([1 + 0.14 * warm, 0.98 + 0 * warm, 1 - 0.28 * warm], -1)
color /= (color @ [0.2126, 0.7152, 0.0722])[..., None]
linear = np.clip((band + rest + galaxies(directions))[..., None] * color / WHITE, 0, 1)
linear = linear.reshape(HEIGHT // 2, 2, WIDTH // 2, 2, 3).mean((1, 3))
srgb = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
Image.fromarray((255 * srgb + 0.5).astype(np.uint8)).save(sys.argv[2], optimize=True)
