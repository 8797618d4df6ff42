# SPDX-License-Identifier: MIT
"""Pictures and plots from Python: those of the program."""
import xml.etree.ElementTree as xml

import numpy as np
import pytest

import pabd


@pytest.mark.parametrize("words", [{}, {"camera": "front,ortho", "overlay": "contacts,series", "theme": "dark"}])
def test_render_draws_what_the_program_draws(pabd_program, tmp_path, words):
    options = [word for key, value in words.items() for word in ("--" + key, value)]
    out = pabd_program("render", "stack", "-o", "end.png", "--time", "0.25", "--size", "320x180", "--quiet", *options)
    assert out.returncode == 0, out.stderr
    sim = pabd.load("stack")
    sim.render(320, 180, **words)  # what was drawn before does not matter
    sim.run(0.25)
    picture = sim.render(320, 180, **words)
    assert (picture.shape, picture.dtype) == ((180, 320, 4), np.uint8)
    assert np.array_equal(picture, pabd.read_png(tmp_path / "end.png"))
    assert picture[..., :3].std() > 5  # there is something to be seen


def test_transparent_pictures_have_opacity():
    picture = pabd.load("stack").render(160, 90, theme="transparent", quality="draft")
    assert picture[0, 0, 3] == 0
    assert picture[..., 3].max() == 255


def test_png_files(tmp_path):
    picture = np.random.default_rng(1).integers(0, 256, (7, 5, 4), dtype=np.uint8)
    picture[..., 3] = 255
    pabd.write_png(tmp_path / "a.png", picture)
    assert np.array_equal(pabd.read_png(tmp_path / "a.png"), picture)
    with pytest.raises(pabd.Error, match="force=True") as caught:
        pabd.write_png(tmp_path / "a.png", picture)
    assert caught.value.kind == "exists"
    pabd.write_png(tmp_path / "a.png", picture[::-1, :, :3], force=True)  # no contiguous array
    assert np.array_equal(pabd.read_png(tmp_path / "a.png"), picture[::-1])
    for shape in ((5, 5), (5, 5, 2), (0, 5, 3)):
        with pytest.raises(pabd.Error):
            pabd.write_png(tmp_path / "b.png", np.zeros(shape, np.uint8))
    assert not (tmp_path / "b.png").exists()


@pytest.mark.parametrize("words", [{"width": 1}, {"height": 10**6}, {"camera": "sideways"}, {"overlay": "all,x"},
                                   {"theme": "pink"}, {"quality": "superb"}])
def test_pictures_of_unknown_words_are_refused(words):
    with pytest.raises(pabd.Error) as caught:
        pabd.load("drop").render(**words)
    assert caught.value.code == 2


def test_plots_are_svg():
    sim = pabd.load("two_boxes")
    sim.step(10)
    for figure in (sim.plot(), sim.plot_quantity("kinetic"), sim.plot_quantity("min_gap", "max_penetration"),
                   pabd.load("two_boxes").plot_convergence(["sissm", "descent"], 20), pabd.plot_barrier(kappa=[50], onset=0.2)):
        root = xml.fromstring(figure._repr_svg_())
        assert root.tag.endswith("svg")
        assert {"text", "polyline"} <= {element.tag.split("}")[1] for element in root.iter()}
        assert xml.fromstring(figure.svg(400, 300, "screen")).get("width") == "400"
        assert figure.pdf().startswith(b"%PDF")


def test_plots_have_the_numbers_of_the_history():
    sim = pabd.load("drop")
    sim.step(20)
    rows = [line.split(",") for line in sim.plot_quantity("kinetic").csv().splitlines()[1:]]
    numbers = np.array([[float(x) for x in row[-2:]] for row in rows])
    assert np.array_equal(numbers[:, 0], sim.history["time"])
    assert np.array_equal(numbers[:, 1], sim.history["kinetic"])


def test_barrier_plot_is_that_of_the_program(pabd_program, tmp_path):
    out = pabd_program("plot", "barrier", "-o", "b.csv", "--N", "2,3", "--kappa", "50", "--onset", "0.2")
    assert out.returncode == 0, out.stderr
    figure = pabd.plot_barrier(N=[2, 3], kappa=[50], onset=0.2)
    figure.save(tmp_path / "c.csv")
    assert (tmp_path / "c.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()
    with pytest.raises(pabd.Error, match="force=True"):
        figure.save(tmp_path / "c.csv")


def test_plots_of_unknown_words_are_refused(tmp_path):
    sim = pabd.load("drop")
    for call in (lambda: sim.plot_quantity("beauty"), lambda: sim.plot_convergence(["jacobi"]),
                 lambda: sim.plot_convergence(iterations=0), lambda: pabd.plot_barrier(N=[0]),
                 lambda: pabd.plot_barrier(N=[]), lambda: pabd.plot_barrier(d_hat=[float("nan")]),
                 lambda: sim.plot().svg(style="pink"), lambda: sim.plot().svg(1, 1),
                 lambda: sim.plot().save(tmp_path / "a.gif")):
        with pytest.raises(pabd.Error) as caught:
            call()
        assert caught.value.code == 2
