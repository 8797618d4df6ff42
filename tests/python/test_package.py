# SPDX-License-Identifier: MIT
"""The package: every public name has words and types, and the examples run."""
import ast
import doctest
import inspect
import json
import runpy
import subprocess
import sys
from pathlib import Path

import pytest

import pabd


def members(cls):
    """Public names of a class of ours, and of what it is made of."""
    return {name: value for base in cls.__mro__ if base.__module__.startswith(("pabd", "_pabd"))
            for name, value in vars(base).items() if not name.startswith("_") or name == "_repr_svg_"}


def stub():
    tree = ast.parse(Path(pabd.__file__).with_name("__init__.pyi").read_text())
    return {node.name: node for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}


def test_every_public_name_has_a_docstring_and_a_type():
    types = stub()
    assert set(types) == set(pabd.__all__)
    for name in pabd.__all__:
        value = getattr(pabd, name)
        assert inspect.getdoc(value), name
        if not inspect.isclass(value):
            continue
        typed = {node.name if isinstance(node, ast.FunctionDef) else node.target.id
                 for node in types[name].body if not isinstance(node, ast.Expr)}
        assert set(members(value)) - {"update"} <= typed | {"add_note", "with_traceback", "args"}, name
        for member, what in members(value).items():
            if name != "Error":
                assert inspect.getdoc(what), f"{name}.{member}"
        for member in typed:
            assert hasattr(value, member) or member in ("name", "folder"), f"{name}.{member} is only in the stub"


def test_parameters_in_the_stub_are_those_of_the_code():
    for name, node in stub().items():
        pairs = [(getattr(pabd, name), node)] if isinstance(node, ast.FunctionDef) else [
            (vars(getattr(pabd, name))[part.name], part) for part in node.body
            if isinstance(part, ast.FunctionDef) and inspect.isfunction(vars(getattr(pabd, name)).get(part.name))]
        for function, typed in pairs:
            expected = [argument.arg for argument in [*typed.args.args, *typed.args.kwonlyargs]]
            has = [parameter.name for parameter in inspect.signature(function).parameters.values()
                   if parameter.kind not in (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL)]
            assert has == expected, f"{name}: {function.__name__}"


def test_units_are_told_where_there_are_some():
    for name in ("positions", "velocities", "masses", "energies", "contacts", "joint_forces"):
        words = inspect.getdoc(getattr(pabd.Simulation, name))
        assert any(unit in words.replace(";", " ").replace(",", " ").split() for unit in ("m", "m/s", "kg", "J", "N")), name


def test_types_fit_for_mypy(tmp_path, source):
    """mypy takes the stub, and a program that uses it right, and refuses one that does not."""
    right = "import pabd\nsim = pabd.load('stack', set={'contact.N': 4})\nx: float = sim.positions[0, 1]\n" \
            "svg: str = sim.plot().svg(400, 300)\nsim.params['contact.kappa'] = 50\n"
    wrong = "import pabd\npabd.load(3)\npabd.load('stack').step('one')\n"

    def check(program):
        (tmp_path / "program.py").write_text(program)
        return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path / "cache",
                               tmp_path / "program.py"], capture_output=True, text=True, cwd=tmp_path,
                              env={"MYPYPATH": str(Path(pabd.__file__).parent.parent), "PATH": "/usr/bin:/bin"})

    out = check(right)
    assert out.returncode == 0, out.stdout + out.stderr
    assert check(wrong).stdout.count("error:") == 2


def test_what_the_readme_shows_is_so(source, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    outcome = doctest.testfile(str(source / "app/python/README.md"), module_relative=False)
    assert (outcome.failed, outcome.attempted) == (0, 9)


@pytest.mark.parametrize("name", ["first_steps", "tune_contact"])
def test_examples_run(source, tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(source / f"assets/python/{name}.py"), run_name="__main__")
    made = list(tmp_path.iterdir())
    assert made and all(path.stat().st_size > 1000 for path in made)


def test_the_notebook_runs(source, tmp_path, monkeypatch):
    """Its cells in their order, as a notebook would; what it says about them stands in it."""
    monkeypatch.chdir(tmp_path)
    notebook = json.loads((source / "assets/python/notebook.ipynb").read_text())
    assert (notebook["nbformat"], notebook["nbformat_minor"]) == (4, 5)
    assert len({cell["id"] for cell in notebook["cells"]}) == len(notebook["cells"])
    space, shown = {}, 0
    for cell in notebook["cells"]:
        assert set(cell) >= {"cell_type", "id", "metadata", "source"}
        if cell["cell_type"] != "code":
            continue
        assert cell["outputs"] == [] and cell["execution_count"] is None
        tree = ast.parse("".join(cell["source"]))
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, "cell", "exec"), space)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), space)
            shown += hasattr(value, "_repr_svg_") and value._repr_svg_().startswith(("<svg", "<?xml"))
    assert shown == 3
