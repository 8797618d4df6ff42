# SPDX-License-Identifier: MIT
"""Reads an .npz as a user would and compares it with what the test wrote of the same run: check_npz.py NPZ EXPECTED.json"""
import json
import sys

import numpy as np

data = np.load(sys.argv[1], allow_pickle=False)
with open(sys.argv[2]) as file:
    expected = json.load(file)

about = json.loads(data["about.json"])
assert about["format"] == "pabd-states" and about["version"] == 1, about
arrays = [name for name in data.files if name != "about.json"]
assert sorted(arrays) == sorted(about["arrays"]), "about.json names the arrays"
for name in arrays:
    assert list(data[name].shape) == about["arrays"][name]["shape"], name
    assert data[name].flags.c_contiguous, name

# Every number of the run is there, bit by bit.
for name, values in expected["exact"].items():
    have = data[name]
    want = np.array(values, dtype=have.dtype).reshape(have.shape)
    assert np.array_equal(have, want, equal_nan=have.dtype.kind == "f"), name

# Quaternions w x y z are the rotations, which are orthonormal.
q, A = data["orientation"], data["A"]
w, x, y, z = np.moveaxis(q, -1, 0)
R = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
              2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
              2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], -1).reshape(A.shape)
assert np.abs(R - A).max() < 1e-14, np.abs(R - A).max()
assert np.abs(A @ np.swapaxes(A, -1, -2) - np.eye(3)).max() < 1e-12
assert (np.sum(q[1:] * q[:-1], axis=-1) > 0).all(), "the nearer of two signs"

# Contacts are ragged: the rows of a state.
offset = data["contact_offset"]
assert offset[0] == 0 and offset[-1] == len(data["contact_gap"]) and (np.diff(offset) >= 0).all()
assert list(np.diff(offset)) == expected["contacts"], "contacts of each state"
assert offset[-1] > 0
gap = np.einsum("ij,ij->i", data["contact_point_b"] - data["contact_point_a"], data["contact_normal"])
assert np.abs(gap - data["contact_gap"]).max() < 1e-12
load, friction = data["contact_normal_force"], np.linalg.norm(data["contact_friction"], axis=1)
assert (load >= 0).all() and load.max() > 0

# Newton's second law of the arm, which touches nothing: the step's change of momentum is weight and joint.
arm = [body["name"] for body in about["bodies"]].index("arm")
assert not ((data["contact_a"] == arm) | (data["contact_b"] == arm)).any()
h, g, mass = np.diff(data["time"]), np.array(expected["gravity"]), data["mass"][arm]
push = mass * np.diff(data["velocity"][:, arm], axis=0) / h[:, None] - mass * g
assert np.abs(push - data["joint_force"][1:, 0]).max() < expected["tolerance"], np.abs(push - data["joint_force"][1:, 0]).max()
assert np.isnan(data["joint_force"][0]).all()

# A hull and a compound: their mass is that of their volume, and they touch the ground with corners that they have.
names = [body["name"] for body in about["bodies"]]
for name, solid in expected["polyhedra"].items():
    i, ground = names.index(name), names.index("ground")
    assert abs(data["mass"][i] - 1000 * solid["volume"]) < 1e-9, data["mass"][i]
    corners = np.array(solid["corners"]).reshape(-1, 3)
    met = set()
    for k in range(len(data["time"])):
        for row in range(offset[k], offset[k + 1]):
            a, b = data["contact_a"][row], data["contact_b"][row]
            if {a, b} != {i, ground}:
                continue
            point = data["contact_point_a" if a == i else "contact_point_b"][row]
            away = np.linalg.norm(corners - data["A"][k, i].T @ (point - data["position"][k, i]), axis=1)
            assert away.min() < 1e-12, (name, k, away.min())
            met.add(int(away.argmin()))
    assert met, name
