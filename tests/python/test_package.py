"""The package itself: its type hints, its documentation and how fast it starts."""

import ast
import importlib
import inspect
import os
import pathlib
import statistics
import subprocess
import sys

import pytest

import geneva

PACKAGE = pathlib.Path(geneva.__file__).parent


def names_in_stub(body):
    """Names that a stub declares, those of classes with their members."""
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.name
        if isinstance(node, ast.AnnAssign):
            yield node.target.id
        if isinstance(node, ast.ClassDef):
            yield from (f"{node.name}.{name}" for name in names_in_stub(node.body))


def names_in_module(module):
    for name, value in vars(module).items():
        if name.startswith("_"):
            continue
        yield name
        if inspect.isclass(value) and value.__module__ == module.__name__:
            yield from (f"{name}.{member}" for member in vars(value) if not member.startswith("_"))


@pytest.mark.parametrize("extension", ["_core", "_solver"])
def test_every_public_name_of_an_extension_is_in_its_stub_and_no_other(extension):
    module = importlib.import_module(f"geneva.{extension}")
    tree = ast.parse((PACKAGE / f"{extension}.pyi").read_text())
    declared = {name for name in names_in_stub(tree.body)
                if not any(part.startswith("_") for part in name.split("."))}
    assert declared == set(names_in_module(module))


def test_the_parameters_of_every_function_of_an_extension_are_those_of_its_stub():
    for extension in ("_core", "_solver"):
        module = importlib.import_module(f"geneva.{extension}")
        for node in ast.parse((PACKAGE / f"{extension}.pyi").read_text()).body:
            if isinstance(node, ast.FunctionDef):
                signature = getattr(module, node.name).__doc__.splitlines()[0]
                for argument in node.args.args:
                    assert f"{argument.arg}:" in signature, (node.name, signature)


def test_the_package_says_that_it_has_type_hints():
    assert (PACKAGE / "py.typed").exists()


def test_the_type_hints_agree_with_each_other_and_the_scripts(tmp_path):
    scripts = sorted((pathlib.Path(os.environ["GENEVA_SOURCE"]) / "doc" / "python").glob("*.py"))
    for what in (["--strict", "-p", "geneva"], [str(script) for script in scripts]):
        done = subprocess.run([sys.executable, "-m", "mypy", "--cache-dir", str(tmp_path), *what], capture_output=True,
                              text=True, check=False, cwd=PACKAGE.parent, env={**os.environ, "MYPYPATH": str(PACKAGE.parent)})
        assert done.returncode == 0, done.stdout + done.stderr


def test_everything_public_is_exported_and_explained():
    for name in geneva.__all__:
        value = getattr(geneva, name)
        if name != "__version__":
            assert inspect.getdoc(value), name
        if inspect.isfunction(value):
            hints = inspect.signature(value)
            assert hints.return_annotation is not inspect.Signature.empty, name
            assert all(one.annotation is not inspect.Parameter.empty for one in hints.parameters.values()), name
        if inspect.isclass(value) and value.__module__.startswith("geneva._"):
            for member, function in vars(value).items():
                if not member.startswith("_") and (inspect.isfunction(function) or isinstance(function, property)):
                    assert inspect.getdoc(function) or value.__name__ in ("Check", "Result", "_Handle"), (name, member)


def test_the_version_is_that_of_the_command():
    printed = subprocess.run([os.environ["GENEVA_PROGRAM"], "--version"], capture_output=True, text=True, check=True)
    assert geneva.__version__ in printed.stdout


def test_import_takes_less_than_half_a_second_of_the_processor():
    """Of the processor, since others may take their share of it: the median of five, after one to warm up."""
    script = "import time, geneva; print(time.process_time())"
    taken = [float(subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout)
             for _ in range(6)][1:]
    assert statistics.median(taken) < 0.5, taken
