# SPDX-License-Identifier: MIT
"""Simulations from Python: the same bits as the program, views that live, threads, signals, errors."""
import _thread
import gc
import json
import threading
import time

import numpy as np
import pytest

import pabd


def falling(height=10.0, **keys):
    builder = pabd.SceneBuilder("falling").sphere("ball", 0.5, position=[0, height, 0], **keys)
    return builder.set("time_step", 0.01).build()


@pytest.mark.parametrize("scene, settings", [("stack", {}), ("pendulum", {}),
                                             ("drop", {"contact.N": 5, "contact.kappa": 80.5})])
def test_hash_is_that_of_the_program(pabd_program, scene, settings):
    sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    out = pabd_program("run", scene, "--steps", "30", "--quiet", "--json", *sets)
    summary = json.loads(out.stdout)
    sim = pabd.load(scene, set=settings, threads=1)
    sim.step(30)
    assert sim.hash == summary["state"]
    assert sim.scene.hash == summary["scene_hash"]
    assert (sim.steps, sim.time) == (30, summary["time"])
    # Set afterwards, and one by one, it is the same.
    again = pabd.load(scene, threads=2)
    again.params.update(settings)
    for _ in range(30):
        again.step()
    assert again.hash == sim.hash


def test_the_thickness_of_contacts_follows_from_small_bodies():
    def die(**keys):
        return pabd.SceneBuilder("die").box("die", [0.001, 0.001, 0.001], **keys)

    sim = die().build(threads=1)
    assert sim.params["contact.d_hat"] == pytest.approx(1e-4)
    assert sim.scene.notes == ['contact.d_hat is 0.0001 m, a tenth of the thickness of "die" (0.001 m): '
                               'the scene states none']
    stated = die().set("contact.d_hat", 0.01).build(threads=1)
    assert stated.params["contact.d_hat"] == 0.01
    assert '"die" (0.001 m)' in stated.scene.notes[0]
    assert pabd.load("stack", threads=1).scene.notes == []


def test_robots_are_scenes(source):
    sim = pabd.load(source / "tests/import/models/pendulum.urdf", threads=1)
    height = sim.positions[:, 1].copy()
    sim.run(0.2)
    assert len(sim.scene.joints) > 0
    assert np.any(sim.positions[:, 1] < height)


def test_free_fall():
    sim = falling()
    report = sim.step(50)
    # Symplectic Euler: v = −g t, y = y₀ − g h² n (n + 1) / 2.
    assert sim.velocities[0] == pytest.approx([0, -9.81 * 0.5, 0], abs=1e-12)
    assert sim.positions[0] == pytest.approx([0, 10 - 9.81 * 1e-4 * 50 * 50 / 2, 0], abs=1e-12)
    mass = 1000 * 4 / 3 * np.pi * 0.5**3
    assert sim.masses == pytest.approx([mass])
    assert report["kinetic"] == pytest.approx(mass * (9.81 * 0.5) ** 2 / 2)
    assert sim.energies["potential"] == pytest.approx(mass * 9.81 * sim.positions[0, 1])
    assert sum(sim.energies[k] for k in ("kinetic", "potential", "elastic")) == sim.energies["total"]


def test_a_report_is_a_summary_of_the_step_and_counts_are_whole_numbers():
    sim = pabd.load("two_boxes")
    report = sim.step(3)
    fields = sim.history.dtype.fields
    numbers = {name: kind for name, (kind, _) in fields.items() if name not in ("converged", "milliseconds")}
    whole = {name for name, kind in numbers.items() if kind.kind == "i"}
    real = numbers.keys() - whole | {"total"}
    assert {"iterations", "contacts", "halvings"} <= whole and {"kinetic", "min_gap", "drive_work"} <= real
    assert set(report) == whole | real | {"method", "status", "times", "islands"}
    assert {key for key in report if type(report[key]) is int} == whole
    assert {key for key in report if type(report[key]) is float} == real
    assert {key: sim.history[-1][key] for key in numbers} == {key: report[key] for key in numbers}
    assert (report["step"], report["contacts"] > 0) == (3, True)
    assert report["total"] == report["kinetic"] + report["potential"] + report["elastic"]


def test_rotations_turn_bodies():
    builder = pabd.SceneBuilder("turning").box("box", [1, 2, 3], angular_velocity=[0, 90, 0])
    sim = builder.set("gravity", [0, 0, 0]).set("time_step", 0.001).build()
    sim.step(500)  # 45° about y
    half = np.sqrt(0.5)
    assert sim.rotations.shape == (1, 3, 3)
    assert sim.rotations[0] == pytest.approx(np.array([[half, 0, half], [0, 1, 0], [-half, 0, half]]), abs=1e-3)
    assert np.linalg.det(sim.rotations[0]) == pytest.approx(1, abs=1e-12)
    assert sim.angular_velocities[0] == pytest.approx([0, np.pi / 2, 0], abs=1e-9)


VIEWS = ["positions", "rotations", "velocities", "angular_velocities", "masses", "fixed"]


def test_views_are_no_copies_and_are_refreshed():
    sim = pabd.load("stack")
    views = {name: getattr(sim, name) for name in VIEWS}
    places = {name: view.__array_interface__["data"][0] for name, view in views.items()}
    start = sim.save()

    def check():
        for name, view in views.items():
            now = getattr(sim, name)
            assert now.__array_interface__["data"][0] == places[name], name
            assert np.array_equal(now, view), name

    for _ in range(5):
        before = views["velocities"].copy()
        sim.step()
        check()
        assert not np.array_equal(before, views["velocities"])
    moved = views["positions"].copy()
    sim.restore(start)
    check()
    assert not np.array_equal(moved, views["positions"])
    sim.step(5)
    assert np.array_equal(moved, views["positions"])
    sim.reset()
    check()
    assert sim.hash == start.hash


@pytest.mark.parametrize("name", VIEWS)
def test_views_are_read_only_and_outlive_their_owner(name):
    sim = pabd.load("stack")
    sim.step(3)
    view, expected = getattr(sim, name), getattr(sim, name).copy()
    with pytest.raises(ValueError):
        view[...] = 0
    with pytest.raises(ValueError):
        view.setflags(write=True)
    part = view[1:]
    del sim, view
    gc.collect()
    junk = [np.full(1000, 7.0) for _ in range(200)]  # would lie where the state was
    assert np.array_equal(part, expected[1:])
    del junk


def test_contacts_carry_the_weight():
    sim = pabd.load("stack")
    sim.run(2)
    contacts = sim.contacts
    assert contacts.dtype.names == ("a", "b", "y_a", "y_b", "n", "d", "normal_force", "friction", "sticking", "mu")
    assert len(contacts) == sim.report["contacts"]
    ground = sim.scene.bodies.index("ground")
    below = contacts[(contacts["a"] == ground) | (contacts["b"] == ground)]
    sign = np.where(below["a"] == ground, 1.0, -1.0)
    up = (below["normal_force"] * below["n"][:, 1] * sign).sum()
    assert up == pytest.approx(9.81 * sim.masses.sum(), rel=1e-3)
    assert contacts["d"] == pytest.approx(((contacts["y_b"] - contacts["y_a"]) * contacts["n"]).sum(axis=1), abs=1e-12)
    # A copy: a step leaves it.
    kept = contacts.copy()
    sim.step(10)
    assert np.array_equal(kept, contacts)


def test_iterations_are_those_of_the_program(pabd_program, tmp_path):
    out = pabd_program("run", "two_boxes", "--steps", "1", "--iterations", "it.csv", "--quiet",
                       "--set", "solver.method=sissm")
    assert out.returncode == 0, out.stderr
    table = np.genfromtxt(tmp_path / "it.csv", delimiter=",", names=True)
    sim = pabd.load("two_boxes", set={"solver.method": "sissm"})
    with pytest.raises(pabd.Error, match="observe"):
        sim.iterations
    sim.observe(iterations=True)
    report = sim.step()
    rows = sim.iterations
    assert len(rows) == report["iterations"] + 1
    column = next(name for name in table.dtype.names if name.startswith("energy"))
    assert np.array_equal(rows["energy"][-len(table):], table[column])


def test_joint_forces_hold_a_pendulum():
    builder = pabd.SceneBuilder("hanging").sphere("bob", 0.1, mass=2, position=[0, -1, 0])
    sim = builder.joint("spherical", None, "bob", anchor=[0, 0, 0], kappa=1e6).build()
    sim.step(200)
    assert sim.joint_forces["force"][0] == pytest.approx([0, 2 * 9.81, 0], rel=1e-3, abs=1e-3)


def test_parameters():
    sim = pabd.load("stack")
    assert set(sim.params) == {row["key"] for row in pabd.parameters()}
    assert sim.params["contact.d_hat"] == 0.02
    assert sim.params["contact.kappa"] == "auto"
    assert sim.params["gravity"] == (0, -9.81, 0)
    sim.params["contact.kappa"] = 50
    sim.params["gravity"] = np.array([0, -1.62, 0])
    sim.params["solver.method"] = "newton"
    assert (sim.params["contact.kappa"], sim.kappa) == (50.0, 50.0)
    assert sim.params["gravity"] == (0, -1.62, 0)
    assert sim.params["solver.method"] == "newton"
    with pytest.raises(KeyError):
        sim.params["contact.stiffness"]
    before = dict(sim.params)
    with pytest.raises(pabd.Error):
        sim.params.update({"contact.N": 4, "contact.d_hat": -1})
    assert dict(sim.params) == before  # all or none
    for bad in (float("nan"), object(), {"a": 1}):
        with pytest.raises((pabd.Error, ValueError)):
            sim.params["contact.d_hat"] = bad
    sim.reset()
    assert sim.params["contact.kappa"] == "auto"


def test_states_lead_to_the_same_future(tmp_path, pabd_program):
    sim = pabd.load("stack", set={"contact.d_hat": 0.01})
    sim.step(20)
    saved = sim.save()
    end = sim.step(15) and sim.hash
    sim.restore(saved)
    assert (sim.steps, sim.hash) == (20, saved.hash)
    sim.step(15)
    assert sim.hash == end
    (tmp_path / "state.json").write_text(saved.json())
    other = pabd.load("stack", set={"contact.d_hat": 0.01})
    other.load_state(tmp_path / "state.json")
    other.step(15)
    assert other.hash == end
    out = pabd_program("run", "stack", "--set", "contact.d_hat=0.01", "--from", "state.json", "--steps", "15",
                       "--json", "--quiet")
    assert json.loads(out.stdout)["state"] == end
    with pytest.raises(pabd.Error, match="use a state of this scene"):
        pabd.load("pyramid").restore(saved)
    with pytest.raises(pabd.Error):
        pabd.load("pyramid").load_state(tmp_path / "state.json")


def test_builder_gives_what_a_file_gives(source):
    file = json.loads((source / "assets/scenes/stack.json").read_text())
    builder = pabd.SceneBuilder("stack", description=file["description"], duration=4)
    builder.plane().generate("stack", name="cube", count=10, size=np.ones(3)).camera([9, 8, 14], [0, 4.9, 0], 42)
    builder.set("contact.d_hat", 0.02)
    shipped = pabd.load("stack")
    built = builder.build()
    assert built.scene.hash == shipped.scene.hash == pabd.parse(file, name="stack").scene.hash
    built.step(10), shipped.step(10)
    assert built.hash == shipped.hash


def test_history():
    sim = pabd.load("drop")
    times = [sim.step()["time"] for _ in range(7)]
    history = sim.history
    assert history["time"].tolist() == times
    assert history["step"].tolist() == list(range(1, 8))
    assert history["kinetic"][-1] == sim.energies["kinetic"]
    sim.reset()
    assert len(sim.history) == 0


def test_another_thread_runs_while_a_step_is_made():
    sim = pabd.load("pile")
    refused, done = [], threading.Event()

    def ask():
        positions = sim.positions
        while not done.is_set():
            assert np.isfinite(positions).all()  # a view is there at any time
            try:
                sim.hash
            except pabd.Error as error:
                refused.append(str(error))
            time.sleep(1e-4)

    other = threading.Thread(target=ask)
    other.start()
    while not refused and sim.steps < 1000:
        sim.step(10)
    done.set()
    other.join()
    # Only between the beginning and the end of a step is anything refused: Python ran in between.
    assert refused and "another thread" in refused[0]
    alone = pabd.load("pile")
    alone.step(sim.steps)
    assert sim.hash == alone.hash


def test_interrupt_ends_a_long_step_between_two():
    sim = pabd.load("stack")
    timer = threading.Timer(0.3, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        sim.step(10**9)
    timer.join()
    made = sim.steps
    assert 0 < made < 10**9
    again = pabd.load("stack")
    again.step(made)
    assert sim.hash == again.hash
    sim.step()  # and it goes on
    assert sim.steps == made + 1


@pytest.mark.parametrize("arguments", [
    ("no_such_scene",),
    ("stack", "contact.d_hat", -1),
    ("stack", "contact.barrier", "cubic"),
    ("stack", "contact.thickness", 1),
    ("stack", "bodies.7.density", 1),
])
def test_errors_have_the_text_and_the_code_of_the_program(pabd_program, arguments):
    scene, *setting = arguments
    words = ["--set", f"{setting[0]}={setting[1]}"] if setting else []
    out = pabd_program("run", scene, "--steps", "1", *words)
    with pytest.raises(pabd.Error) as caught:
        pabd.load(scene, set=dict([setting]) if setting else None)
    assert f"pabd: error: {caught.value}\n" == out.stderr
    assert caught.value.code == out.returncode
    assert caught.value.kind == ("bad_input" if setting else "file")


def test_divergence_is_an_error_that_leaves_the_state(pabd_program):
    out = pabd_program("run", "two_boxes", "--steps", "3", "--quiet", "--set", "contact.barrier=log")
    sim = pabd.load("two_boxes", set={"contact.barrier": "log"})
    start = sim.hash
    with pytest.raises(pabd.Error) as caught:
        sim.step(3)
    assert (caught.value.code, out.returncode) == (5, 5)
    assert f"pabd: error: {caught.value}\n" == out.stderr
    assert (sim.hash, sim.report["status"]) == (start, "non_finite")


def test_hostile_values_are_refused():
    sim = pabd.load("stack")
    for n in (-1, 10**9 + 1):
        with pytest.raises(pabd.Error, match="expected a number"):
            sim.step(n)
    for n in (1.5, "2", None, 2**70):
        with pytest.raises(TypeError):
            sim.step(n)
    with pytest.raises(pabd.Error, match="threads"):
        pabd.load("stack", threads=-1)
    with pytest.raises(pabd.Error, match="processor"):
        sim.params["solver.device"] = "gpu"
    loop = {}
    loop["bodies"] = [loop]
    for scene in (loop, {"bodies": [float("inf")]}, {"bodies": {1, 2}}):
        with pytest.raises(ValueError):
            pabd.parse(scene)
    with pytest.raises(pabd.Error):
        pabd.parse("[" * 100000)
    assert (sim.steps, sim.params["solver.device"]) == (0, "cpu")
