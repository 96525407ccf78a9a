"""Checks that the arrays of a.npz are the columns of a.csv, with NumPy."""

import csv

import numpy as np

with open("a.csv", newline="") as file:
    rows = list(csv.DictReader(file))
arrays = np.load("a.npz")
assert arrays.files == list(rows[0]), arrays.files
for name in arrays.files:
    own = [row[name] for row in rows]
    array = arrays[name]
    assert array.shape == (len(rows),), array.shape
    if array.dtype.kind == "U":
        assert array.tolist() == own
    elif array.dtype.kind == "i":
        assert array.tolist() == [int(text) if text else -1 for text in own], name
    else:
        numbers = np.array([float(text) if text else np.nan for text in own])
        # CSV writes a number of 32 bits with the digits that such numbers need.
        singles = np.where(array == array.astype(np.float32), numbers.astype(np.float32), numbers)
        assert np.array_equal(singles, array, equal_nan=True), name
