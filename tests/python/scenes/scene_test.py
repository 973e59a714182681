# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes in Python: exact numbers, units, errors in the words of C++, commands, compiled kernels."""

import fractions
import functools
import math
import os
import pathlib
import re
import subprocess
import sys
from decimal import Decimal

import numpy as np
import pytest

import torsor
from torsor import scene as ts
from torsor.scene import Inertia, Rotation, Scene, axis, cos, piecewise, quantity, sin, sqrt, tanh


def crane():
    """A trolley with a pendulum, and a motor that pushes it: the README's."""
    scene = Scene("crane", "A trolley with a load")
    M, m = scene.parameter("M", "kg", 4), scene.parameter("m", "kg", 1)
    l, g = scene.run_time_parameter("l", "m", "0.5"), scene.parameter("g", "m/s^2", 9.81)
    x, theta = scene.coordinate("x", "m"), scene.coordinate("theta", "rad")
    trolley = scene.prismatic("trolley", scene.ground, axis.x, x)
    rod = scene.revolute("rod", trolley, axis.y, theta)
    scene.body("trolley", trolley, Inertia.point(M))
    scene.body("rod", rod, Inertia.rod(m, l, 2).at((0, 0, -l / 2)))
    scene.gravity((0, 0, -g))
    scene.motor("drive", x)
    scene.initial(x, 1)
    return scene


def test_a_parameter_takes_another_value():
    scene = crane()
    M = scene.parameter("N", "kg", 2)
    scene.set_parameter(M, quantity(3, "kg"))
    assert "N = 3 kg" in scene.run("equations")
    with pytest.raises(torsor.scene.SceneError, match="depends on 'N' itself"):
        scene.set_parameter(M, 2 * M)


def test_a_command_overwrites_no_file_that_the_scene_was_made_by(tmp_path):
    (tmp_path / "length.py").write_text("length = 2\n")
    (tmp_path / "rod.py").write_text("""
import sys
import length
from torsor.scene import Inertia, Scene, axis, quantity
scene = Scene("rod")
rod = scene.revolute("rod", scene.ground, axis.y, scene.coordinate("theta", "rad"))
scene.body("rod", rod, Inertia.rod(quantity(1, "kg"), quantity(length.length, "m"), 0))
if sys.argv[1] == "generate":
    scene.generate(sys.argv[2])
else:
    scene.main()
""")
    for words in (["generate", "rod.py"], ["generate", "length.py"], ["equations", "-o", "rod.py"]):
        done = subprocess.run([sys.executable, "rod.py", *words], cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode != 0, words
        assert f"would overwrite '{tmp_path / words[-1]}', which the command reads" in done.stderr
    assert (tmp_path / "length.py").read_text() == "length = 2\n"


@pytest.fixture
def scene():
    return Scene("rod")


# Numbers

@pytest.mark.parametrize("number, exact", [
    (3, "3"), ("1/3", "1/3"), ("9.81", "981/100"), (0.1, "1/10"), (fractions.Fraction(2, 7), "2/7"), (Decimal("1E+2"), "100"),
    (-1.5e-3, "-3/2000"), (10**40, str(10**40)), (np.float64(0.25), "1/4"), (np.int64(-7), "-7"), (1e300, str(10**300)), (0.0, "0")])
def test_numbers_are_exact(number, exact):
    assert str(ts.Expression(number)) == exact


def test_rounded_floats_are_refused_and_written_ones_are_not():
    """Of sqrt(k) and 1/k only those with a finite decimal pass: 1/2, 1/5, 1/256."""
    for k in range(1, 500):
        for value, exact in ((math.sqrt(k), math.isqrt(k) ** 2 == k), (1 / k, fractions.Fraction(repr(1 / k)) * k == 1)):
            if exact:
                assert str(ts.Expression(value)) == str(fractions.Fraction(repr(value)))
            else:
                with pytest.raises(ts.Error, match="rounded number"):
                    ts.Expression(value)


@pytest.mark.parametrize("rounded", [1 / 3, 0.1 + 0.2, math.pi, math.sqrt(2), np.float64(2) / 3])
def test_a_float_that_nobody_wrote_is_refused_unless_it_is_meant(rounded, scene):
    with pytest.raises(ts.Error, match="rounded number"):
        scene.parameter("a", "1", rounded)
    assert str(quantity(rounded)) == str(fractions.Fraction(repr(float(rounded))))


def test_a_start_takes_what_a_message_proposes():
    """Its numbers have all digits of a double."""
    scene = crane()
    y, e = scene.coordinate("y", "m"), scene.attitude("e")
    scene.initial(y, 0.24711653583058787, np.float64(-0.386491220150572))
    scene.initial(e, (math.sqrt(0.75), 0.5, 0, "0"), (1 / 3, 0, 0))
    ball = scene.free("ball", scene.ground, (y, 0, 0), e)
    scene.body("ball", ball, Inertia.solid_sphere(quantity(1, "kg"), quantity(1, "m")))
    motion = scene.simulate(0.1)
    assert (motion["y"][0], motion["y'"][0]) == (0.24711653583058787, -0.386491220150572)
    assert motion["e_omega_x"][0] == 1 / 3
    with pytest.raises(ts.Error, match="finite"):
        scene.initial(y, math.nan)
    with pytest.raises(TypeError):
        scene.initial(e, "1000")


@pytest.mark.parametrize("wrong, words", [("abc", "cannot read"), ("1/0", "denominator"), (math.nan, "finite"), (math.inf, "finite"),
                                          (Decimal("NaN"), "cannot read"), ("\udc80", r"cannot read '\\udc80'")])
def test_what_is_no_number_is_refused(wrong, words):
    with pytest.raises(ts.Error, match=words):
        ts.Expression(wrong)


@pytest.mark.parametrize("wrong", [True, None, [1], 1j, np.float32(1), np.array([1.0])])
def test_other_objects_are_no_formulas(wrong):
    with pytest.raises(TypeError):
        ts.Expression(wrong)


def test_integers_are_read_by_their_value_and_not_by_how_they_print():
    class Named(int):
        def __str__(self):
            return "7"

        __repr__ = __str__

    assert str(ts.Expression(Named(3))) == "3"
    assert str(ts.Expression(fractions.Fraction(Named(3), 4))) == "3/4"


def test_text_is_no_vector(scene):
    angle = scene.coordinate("q", "rad")
    for text in ("123", b"123", bytearray(b"123")):
        with pytest.raises(TypeError, match="revolute"):
            scene.revolute("r", scene.ground, text, angle)
    scene.revolute("r", scene.ground, ["0", "3/5", "4/5"], angle)


def test_formulas_are_not_compared_by_chance(scene):
    q = scene.coordinate("q", "m")
    for compare in (lambda: q == q, lambda: q != 2, lambda: q == scene.coordinate("x", "m")):
        with pytest.raises(TypeError, match="equal"):
            compare()
    assert {q: "kept"}[q] == "kept"


def test_numpys_numbers_and_text_may_stand_on_the_left(scene):
    x = scene.coordinate("x", "m")
    for product in (2 * x, np.float64(2) * x, np.int64(2) * x, "2" * x, fractions.Fraction(2) * x):
        assert str(product) == "2*x"
        assert product.unit == "m"


# Units

def test_units_are_checked_where_a_sum_is_written(scene):
    x, theta = scene.coordinate("x", "m"), scene.coordinate("theta", "rad")
    with pytest.raises(ts.UnitError, match="m"):
        x + theta
    with pytest.raises(ts.UnitError):
        sin(x)
    with pytest.raises(ts.UnitError, match="mm"):
        quantity(1, "mm")
    assert (quantity("9.81", "m/s^2") * x).unit == "m^2 s^-2"
    assert sqrt(x * x).unit == "m"
    assert tanh(x / quantity(1, "m")).unit == "1"


# Errors

def test_errors_have_the_words_of_cpp(scene):
    scene.coordinate("x", "m")
    with pytest.raises(ts.SceneError, match="duplicate name 'x'"):
        scene.coordinate("x", "m")
    assert issubclass(ts.SceneError, ts.Error) and issubclass(ts.Error, ValueError)
    with pytest.raises(TypeError, match="revolute"):
        scene.revolute("rod", scene.ground)


def test_handles_of_another_scene_are_refused(scene):
    other = Scene("other")
    frame = other.weld("far", other.ground)
    point = other.point("tip", frame)
    with pytest.raises(ts.SceneError, match="'far' belongs to another scene than 'rod'"):
        scene.body("rod", frame, Inertia.point(1))
    with pytest.raises(ts.SceneError, match="'tip' belongs to another"):
        scene.point_in_plane("floor", point, scene.ground)
    with pytest.raises(ts.SceneError, match="another scene"):
        scene.contact("floor", ts.shape.Sphere(frame, 1), ts.shape.Plane(scene.ground))
    with pytest.raises(ts.SceneError, match="another scene"):
        scene.spherical("ball", scene.ground, other.attitude("e"))


def test_formulas_of_another_scene_are_refused(scene):
    """The name is that of a coordinate of this scene too: without a check the equations were wrong without a word."""
    q, q2 = scene.coordinate("q", "m"), Scene("other").coordinate("q", "m")
    scene.body("b", scene.prismatic("b", scene.ground, axis.x, q), Inertia.point(1))
    scene.spring("sp", q2, quantity(1, "N/m"))
    with pytest.raises(ts.SceneError, match="'q' belongs to another scene than 'rod', whose action 'sp'"):
        scene.equations()


def test_a_condition_is_for_piecewise_only(scene):
    x = scene.coordinate("x", "m")
    with pytest.raises(TypeError, match="piecewise"):
        if x < quantity(1, "m"):
            pass
    assert piecewise([(x < quantity(1, "m"), x)], quantity(2, "m")).unit == "m"


@pytest.mark.parametrize("number", [fractions.Fraction(1, 3), Decimal("0.5"), fractions.Fraction(3, 2), Decimal("1.9"), 0.5, "2"])
def test_what_is_no_integer_does_not_become_one(scene, number):
    """Python's int() would cut it off: a root would be the power 0."""
    length = scene.parameter("length", "m", 1)
    with pytest.raises(TypeError):
        length**number
    for axis_and_turn in ((number, 1), (1, number)):
        with pytest.raises(TypeError):
            Rotation.about(*axis_and_turn)
    with pytest.raises(TypeError):
        ts.AngleSequence([2, number, 0])
    assert str(length**np.int64(2)) == str(length**2) == "length^2"


def test_types_of_joints_that_close_loops(scene):
    with pytest.raises(ts.SceneError, match="point_contact"):
        scene.loop_joint("pin", type="hinge", a=scene.ground, b=scene.ground)


def test_rotations_are_exact():
    quarter = Rotation.matrix([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    a, b = crane(), crane()
    a.weld("w", "rod", rotation=quarter)
    b.weld("w", "rod", rotation=Rotation.about(2, 3) * Rotation.about(2, 3))
    assert a.generate(kernels="kinematics") == b.generate(kernels="kinematics")
    with pytest.raises(ts.SceneError):
        Rotation.matrix([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 2]])
    for no_axis in (-2000000, -1, 3):
        with pytest.raises(ts.SceneError, match="no axis"):
            Rotation.about(no_axis, 1)


# Commands

def test_equations_are_those_of_the_readme():
    text = crane().equations()
    assert "(M + m) x'' - 1/2 m l cos(theta) theta'' + 1/2 m l sin(theta) theta'^2 = drive" in text
    assert r"\cos" in crane().equations(format="latex")
    shown = crane()._repr_latex_()
    # MathJax sets what is within such environments and nothing else.
    assert r"\cos" in shown and "section" not in shown and r"\par" not in shown
    assert r"$$\textbf{Lagrange's equations}$$" in shown
    rest = re.sub(r"\\begin\{align\*\}.*?\\end\{align\*\}|\$\$.*?\$\$", "", shown, flags=re.DOTALL)
    assert not rest.strip()


def test_every_command_of_a_program_is_there(tmp_path):
    scene = crane()
    assert scene.run("check", digits=30, states=3).startswith("crane")
    page = scene.report(1)
    assert "A trolley with a load" in page and "function poses(precomputed" in page
    with pytest.raises(ts.UsageError, match="unknown command 'equation'.*equations"):
        scene.run("equation")
    with pytest.raises(ts.UsageError, match="no_such_kernel"):
        scene.generate(kernels=["no_such_kernel"])
    path = tmp_path / "crane.hpp"
    assert scene.generate(path, kernels=["energy", "bias"]) == ""
    assert "bias" in path.read_text() and "mass_matrix" not in path.read_text()
    with pytest.raises(ts.FileError):
        scene.generate(tmp_path / "no" / "folder" / "crane.hpp", kernels="energy")
    assert "usage" in scene.run("fmu", "--help").lower()


def test_simulates_from_the_scene_itself():
    scene = Scene("ball")
    z = scene.coordinate("z", "m")
    ball = scene.prismatic("ball", scene.ground, axis.z, z)
    scene.body("ball", ball, Inertia.point(quantity(1, "kg")))
    scene.gravity((0, 0, quantity(-10, "m/s^2")))
    scene.contact("floor", ts.shape.Point(scene.point("foot", ball)), ts.shape.Plane(scene.ground), restitution="1/2")
    motion = scene.simulate(1.0, step=0.25, initial={"z": 0.8})
    assert motion["time"][-1] == 1.0
    # It falls 0.8 m in 0.4 s and leaves at 2 m/s, for 0.4 s: at 0.75 s the height is 2 * 0.35 - 5 * 0.35^2.
    at = motion[np.isclose(motion["time"], 0.75)][0]
    assert at["z"] == pytest.approx(2 * 0.35 - 5 * 0.35**2, abs=1e-8)


def test_options_of_formulas_are_given_one_by_one(tmp_path):
    """Two balls that nothing acts on, at 1 m/s from -0.25 m and -0.5 m: they pass zero at 0.25 s and 0.5 s."""
    scene = Scene("balls")
    for name, start in (("x", "-1/4"), ("y", "-1/2")):
        q = scene.coordinate(name, "m")
        scene.body(name, scene.prismatic(name, scene.ground, axis.x, q), Inertia.point(quantity(1, "kg")))
        scene.spring(f"s_{name}", q, scene.parameter(f"k_{name}", "N/m", 0))
        scene.initial(q, start, 1)
    for about in ({"x": 2, "y": 3}, ["x=2", "y=3"]):
        assert "About x = 2, y = 3;" in scene.equations(about=about)
    assert "With k_x = 7, k_y = 8." in scene.run("statics", set={"k_x": 7, "k_y": 8}, about=["x=0", "y=0"])
    motion = scene.simulate(1.0, step=1.0, events=["a: min(x, 2*x)", "b: y"])
    # Rows of events stand among those of the steps, located as the motion is: within 1e-10 a step.
    np.testing.assert_allclose(motion["time"], [0, 0.25, 0.5, 1], atol=1e-8)
    scene.run("simulate", to=1, step=0.5, plot=[tmp_path / "motion.svg", "x,y"])
    assert "<svg" in (tmp_path / "motion.svg").read_text()
    with pytest.raises(ts.UsageError, match="--about names 'x' twice: give it one value"):
        scene.equations(about=["x=1", "x=2"])
    for option in ("initial", "run_time"):
        with pytest.raises(ts.UsageError, match=f"--{option.replace('_', '-')} names 'x' twice: give it one value"):
            scene.simulate(1.0, **{option: ["x=1", "x=2"]})


def test_a_scene_has_one_gravity():
    scene = crane()
    with pytest.raises(ts.SceneError, match="the scene 'crane' has a gravity already"):
        scene.gravity((0, 0, quantity(-1, "m/s^2")))


def test_a_motion_that_ends_early_has_its_rows():
    """x' = x^2 from x = 1 is 1 / (1 - t): it reaches every bound before 1 s."""
    scene = Scene("blow_up")
    x = scene.coordinate("x", "m")
    scene.body("b", scene.prismatic("b", scene.ground, axis.x, x), Inertia.point(quantity(1, "kg")))
    scene.generalised_force("push", x, quantity(2, "N/m^3") * x * x * x)
    scene.initial(x, 1, 1)
    with pytest.raises(ts.CheckError, match=r"^It ends before 2 s: [^\n]*$") as early:
        scene.simulate(2.0, step=0.125)
    assert early.value.text.startswith("# Motion of the scene blow_up")
    assert early.value.motion["x"][4] == pytest.approx(2, rel=1e-8)
    with pytest.raises(ts.UsageError, match="drop output"):
        scene.simulate(1.0, output="motion.csv")


def test_a_loaded_scene_has_kernels():
    scene = crane()
    mechanism = torsor.load(scene, kernels=["mass_matrix"], run_time="all", flags="-O0")
    # (M + m), -m l/2 cos, m l^2/3
    assert mechanism.mass_matrix([0.0, 0.0]) == pytest.approx(np.array([[5, -0.25], [-0.25, 1 / 12]]), rel=1e-15)
    assert "theta" in mechanism._repr_latex_()
    with pytest.raises(ts.UsageError):
        torsor.load(scene, kernels=["no_such_kernel"])


def test_a_file_of_python_is_a_program(tmp_path):
    file = os.path.join(os.environ["TORSOR_SOURCE_DIR"], "examples/double_pendulum/scene.py")

    def run(*words, **options):
        return subprocess.run([sys.executable, file, *words], **{"capture_output": True, "text": True, "check": False, **options})

    assert run("equations").stdout == subprocess.run(
        [os.path.join(os.environ["TORSOR_PROGRAM_DIR"], "double_pendulum_scene"), "equations"], capture_output=True, text=True,
        check=True).stdout
    assert run("equation").returncode == 2
    assert run("generate", "-o", str(tmp_path / "no" / "x.hpp")).returncode == 3
    with open("/dev/full", "w", encoding="utf-8") as full:
        told = run("equations", capture_output=False, stdout=full, stderr=subprocess.PIPE)
    assert told.returncode == 3 and "cannot write the output" in told.stderr and "Traceback" not in told.stderr
    told = run("equations", "--language", b"\xff")
    assert told.returncode in (2, 3) and "Traceback" not in told.stderr
    ascii_only = {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    told = run("report", "--to", "0.1", text=False, env=ascii_only)
    assert told.returncode == 0 and not told.stdout.isascii() and told.stdout.decode().rstrip().endswith("</html>")


def test_the_snippet_of_the_documentation_runs_where_it_is_copied(tmp_path, monkeypatch):
    text = (pathlib.Path(os.environ["TORSOR_SOURCE_DIR"]) / "docs/python.md").read_text(encoding="utf-8")
    snippet = re.search(r"## Scenes in Python.*?```python\n(.*?)```", text, re.S)[1]
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(torsor, "load", functools.partial(torsor.load, flags="-O0"))
    names = {}
    exec(snippet, names)
    assert names["motion"]["theta"][0] == 0.3 and (tmp_path / "crane.hpp").stat().st_size > 1000
    assert names["crane"].mass_matrix([0.0, 0.0]).shape == (2, 2)


def test_the_snippet_of_the_docstring_runs(monkeypatch):
    monkeypatch.setattr(torsor, "load", functools.partial(torsor.load, flags="-O0"))
    names = {}
    exec("\n".join(re.findall(r"^>>> (.*)", ts.__doc__, re.M)), names)
    assert names["arm"].mass_matrix([0.0]).shape == (1, 1)


def test_names_are_those_that_users_import():
    for name in ("SceneError", "UnitError", "UsageError", "Expression", "Frame", "Inertia"):
        assert getattr(ts, name).__module__ == "torsor.scene"


def test_a_compiled_module_of_another_version_is_refused(tmp_path):
    """A module that was left behind: what it would do is not what the package says."""
    for text, said in (('__version__ = "0.0.9"', "0.0.9"), ("", "an older one")):
        (tmp_path / "_torsor_scene.py").write_text(text)
        path = os.pathsep.join([str(tmp_path), *sys.path])
        answer = subprocess.run([sys.executable, "-c", "import torsor.scene"], env={**os.environ, "PYTHONPATH": path},
                                capture_output=True, text=True, check=False)
        assert answer.returncode == 1
        assert f"_torsor_scene.py is of version {said} and this package torsor of {torsor.__version__}: install" in answer.stderr
