# SPDX-License-Identifier: MIT
"""Projective Affine Body Dynamics: simulate, tune, look, from Python.

    import pabd

    sim = pabd.load("pyramid")
    sim.params["contact.d_hat"] = 0.02   # m
    sim.step(60)
    print(sim.report["status"], sim.positions.mean(axis=0))
    sim.plot()                           # a notebook shows it

Units are SI, y is up; vectors are in world axes. A simulation makes the same states, to the last bit, as the program
does for the same scene, parameters and steps, with any number of threads. Steps are made without the interpreter's
lock. Everything that is refused is a pabd.Error with the line that the program would print.
"""

import json as _json
import sys as _sys
from collections.abc import MutableMapping as _MutableMapping
from pathlib import Path as _Path

from pabd import _pabd
from pabd._pabd import Error, Figure, Scene, State, __version__

__all__ = ["Error", "Figure", "Parameters", "Scene", "SceneBuilder", "Simulation", "State", "load", "parameters",
           "parse", "plot_barrier", "read_png", "scenes", "write_png"]

# OpenGL drivers are tried in a process of their own: one that crashes takes nobody along.
if _sys.executable:
    _pabd._set_context_trial([_sys.executable, "-I", "-c",
                              "import sys; sys.path.insert(0, sys.argv[1]); import _pabd; "
                              "_pabd._try_contexts(sys.argv[2:])", str(_Path(_pabd.__file__).parent)])


def _plain(value):
    """What JSON has in place of a number or an array of NumPy."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{type(value).__name__}: expected numbers, text, lists and mappings")


def _text(value):
    """JSON; what is no number, or has no end, is refused."""
    try:
        return _json.dumps(value, default=_plain, allow_nan=False)
    except (TypeError, ValueError, RecursionError) as error:
        raise ValueError(str(error)) from None


def _settings(values):
    """"key=value" as the program's --set takes them."""
    return [f"{key}={value if isinstance(value, str) else _text(value)}" for key, value in dict(values).items()]


def load(scene, *, set=None, threads=0):
    """A Simulation of a scene: a file, one of a robot (URDF, MJCF) too, or the name of a shipped one (scenes()).

    set: a mapping of keys of the scene file to values, as the program's --set takes them, before the scene is read:
    {"contact.kappa": 50, "joints_default.kappa": 20, "bodies.1.density": 300}.
    threads: of a step; 0: every CPU that may be used. Results do not depend on it.
    """
    return Simulation(_pabd.load_scene(str(scene), _settings(set or {})), threads)


def parse(scene, *, name="scene", folder=".", set=None, threads=0):
    """A Simulation of a scene given as JSON text, or as the mapping that a scene file holds.

    name: of the scene in messages. folder: what files of meshes are relative to. set, threads: as for load().
    """
    text = scene if isinstance(scene, str) else _text(scene)
    return Simulation(_pabd.parse_scene(text, name, _Path(folder), _settings(set or {})), threads)


def scenes():
    """Names of the shipped scenes, sorted."""
    return _pabd.scenes()


def parameters():
    """The table of parameters: a list of dicts with key, label, symbol, unit, help, expected, default, choices."""
    return _pabd.parameters()


class Parameters(_MutableMapping):
    """The parameters of a simulation by their keys ("contact.d_hat"), for the steps that follow.

    Values are float (SI), int, a word, or a tuple of three floats; contact.kappa may be "auto". A value out of range is
    refused with an Error, a key that is none with a KeyError where it is read.
    """

    def __init__(self, simulation):
        """Those of a simulation."""
        self._simulation = simulation

    def __getitem__(self, key):
        """The value."""
        return self._simulation._parameter(key)

    def __setitem__(self, key, value):
        """Another value, from the next step on."""
        self._simulation._set(_settings({key: value}))

    def __delitem__(self, key):
        """Parameters do not go."""
        raise TypeError("parameters cannot be deleted; set another value, or reset() the simulation")

    def __iter__(self):
        """Keys in the order of scene files."""
        return (row["key"] for row in _pabd.parameters())

    def __len__(self):
        """How many there are."""
        return len(_pabd.parameters())

    def update(self, *mappings, **values):
        """Several values at once: all of them, or none where one is refused."""
        self._simulation._set(_settings(dict(*mappings, **values)))

    def __repr__(self):
        return f"Parameters({dict(self)})"


class Simulation(_pabd.Simulation):
    """One simulation: a scene, its parameters, where the bodies are now.

    positions, rotations, velocities and angular_velocities are views of the state itself: no copies, read-only, valid as
    long as anybody has them. Each step(), reset() and restore() refreshes them; copy() what is to stay. While another
    thread makes a step they may hold numbers of either end of it, and everything else is refused with an Error.
    contacts, iterations, joint_forces, history, report and energies are copies.
    """

    @property
    def params(self):
        """The Parameters of the next step: sim.params["contact.kappa"] = 50."""
        return Parameters(self)

    def plot(self):
        """The history: gaps and penetration, energies, joint error against time."""
        return _pabd.plot_history(self)

    def plot_quantity(self, y, x="time"):
        """A quantity of the history against another: "min_gap", "kinetic", "iterations", …; an unknown one is told all."""
        return _pabd.plot_quantity(self, y, x)

    def plot_convergence(self, methods=(), iterations=100):
        """How solvers ("sissm", "descent", "newton") converge within the next step, against its minimiser.

        The state does not change. The minimiser takes up to 20000 iterations.
        """
        return _pabd.plot_convergence(self, list(methods), iterations)

    def __repr__(self):
        return f"<pabd.Simulation {self.scene.name}: {len(self.masses)} bodies, step {self.steps}, t = {self.time:.6g} s>"


class SceneBuilder:
    """A scene put together: entries as those of a scene file, with its keys, units and defaults.

    What is wrong is told by build(), with the text that a file would be refused with. Angles are in degrees.
    """

    def __init__(self, name, *, folder=".", description="", duration=None):
        """name: of the scene. folder: what files of meshes are relative to. duration: to be shown; s."""
        self.name = name
        self.folder = folder
        self._params = {}
        self._document = {"format": "pabd-scene", "version": 1, "name": name, "description": description}
        if duration is not None:
            self._document["duration"] = duration

    def _add(self, section, entry):
        self._document.setdefault(section, []).append(entry)
        return self

    def set(self, key, value):
        """A parameter ("contact.kappa"), or any other key of the scene ("joints_default.kappa")."""
        self._params[key] = value
        return self

    def camera(self, eye, target, fov=45):
        """From where the scene wants to be seen: two places in m, world, and the vertical field of view in degrees."""
        self._document["camera"] = {"eye": eye, "target": target, "fov": fov}
        return self

    def body(self, name, shape, **keys):
        """A body. shape: {"type": "box", "size": [1, 1, 1]}, …; m. keys: mass (kg) or density, fixed, position (m), …"""
        return self._add("bodies", {"name": name, "shape": shape, **keys})

    def plane(self, name="ground", normal=(0, 1, 0), offset=0):
        """A fixed half space below the plane normal.x = offset; m."""
        return self._add("bodies", {"name": name, "shape": {"type": "plane", "normal": normal, "offset": offset}})

    def box(self, name, size=(1, 1, 1), **keys):
        """A box; edge lengths in m. keys as for body()."""
        return self.body(name, {"type": "box", "size": size}, **keys)

    def sphere(self, name, radius=0.5, **keys):
        """A ball; radius in m. keys as for body()."""
        return self.body(name, {"type": "sphere", "radius": radius}, **keys)

    def capsule(self, name, radius, length, **keys):
        """A capsule along y; radius and length of its straight part in m. keys as for body()."""
        return self.body(name, {"type": "capsule", "radius": radius, "length": length}, **keys)

    def joint(self, type, i, j, **keys):
        """A joint of a type ("spherical", "hinge", …) between two bodies by name; None is the world. keys: anchor, axis, …"""
        return self._add("joints", {"type": type, "bodies": [i, j], **keys})

    def generate(self, type, **keys):
        """Many bodies at once: a "stack", "wall", "pyramid", "pile", "chain" or "net" with the generator's keys."""
        return self._add("generate", {"type": type, **keys})

    def build(self, *, threads=0):
        """The Simulation of all that was added, which stays: more may be added for another one."""
        return parse(self._document, name=self.name, folder=self.folder, set=self._params, threads=threads)


def plot_barrier(N=(1, 2, 3, 8), d_hat=(0.01,), kappa=(), barrier=("polynomial",), onset=0.2):
    """Barrier curves B_N and their derivatives against the distance, as 'pabd plot barrier' draws them: a Figure.

    N, d_hat (m), kappa (J; empty: B_N itself), barrier (words of contact.barrier): lists; onset: 0 … 1, 0 the printed formula.
    """
    return _pabd.plot_barrier(list(N), list(d_hat), list(kappa), list(barrier), onset)


def write_png(path, image, *, force=False):
    """Write a picture, (h, w, 3) or (h, w, 4) uint8, as PNG: whole or not at all.

    A file that exists is replaced only with force=True.
    """
    _pabd.write_png(path, image, force)


def read_png(path):
    """A PNG as (h, w, 4) uint8; transparency is laid over black."""
    return _pabd.read_png(path)
