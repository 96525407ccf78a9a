"""Checks that the arrays of a.npz, a.npy, a.fits and a.h5 have the bits of the channels of a.exr, with NumPy, astropy and h5py."""

import json

import h5py
import numpy as np
import OpenEXR
from astropy.io import fits

CHANNELS = {
    "color": ["R", "G", "B"],
    "alpha": ["A"],
    "depth": ["Z"],
    "object": ["id.object"],
    "status": ["id.status"],
    "position": ["position.X", "position.Y", "position.Z"],
    "normal": ["normal.X", "normal.Y", "normal.Z"],
    "accumulated": ["accumulated.R", "accumulated.G", "accumulated.B"],
    "image_order": ["image_order.0", "image_order.1", "image_order.2"],
}

with OpenEXR.File("a.exr", separate_channels=True) as file:
    header = dict(file.header())
    channels = {name: channel.pixels.copy() for name, channel in file.channels().items()}


def planes(name):
    return [channels.pop(channel) for channel in CHANNELS.get(name, [name])]


def same(own, other):
    assert own.shape == other.shape and own.dtype.itemsize == other.dtype.itemsize == 4, (own.shape, other.shape)
    assert np.array_equal(own.view(np.uint32), other.view(np.uint32))


arrays = np.load("a.npz")
tables = fits.open("a.fits")
tables.verify("exception")
datasets = h5py.File("a.h5")
names = [name for name in arrays.files if name != "metadata.json"]
assert [table.name for table in tables] == [name.upper() for name in names], tables.info()
assert set(datasets) == set(names), list(datasets)
for name, table in zip(names, tables):
    expected = planes(name)
    array = arrays[name]
    same(array, np.stack(expected, axis=-1) if len(expected) > 1 else expected[0])
    same(datasets[name][()], array)
    # The first row of FITS is the bottom, and all of its numbers are big-endian.
    image = np.ascontiguousarray(table.data[..., ::-1, :]).astype(table.data.dtype.newbyteorder("="))
    same(image, np.stack(expected) if len(expected) > 1 else expected[0])
assert not channels, channels.keys()

settings = json.loads(arrays["metadata.json"])
assert settings == json.loads(tables[0].header["SETTINGS"]) == json.loads(datasets.attrs["metadata"])
for key in ["method", "scene", "rays", "device", "Software"]:
    assert settings[key] == header[key], key
if "alpha" not in names:
    same(np.load("a.npy"), arrays["color"])
print(len(names), "arrays")
