# SPDX-License-Identifier: GPL-3.0-or-later
"""What units of FMI give beside their motion: energies, points, poses of frames, reactions, against the runtime's kernels."""

import os
import re
import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile

import numpy as np
import pytest

from conftest import command, scene
from fmi_importer import CO_SIMULATION, DISCARD, ERROR, MODEL_EXCHANGE, OK, Unit2, Unit3, assert_slopes_by_parameters, doubles

# Planar with motors; in space with a quaternion, a law of time, a constraint and a motor.
OUTPUTS = {"loading_robot": ("--points", "O2", "--frames", "S3,S1", "--reactions", "Y12"),
           "lamp": ("--points", "all", "--frames", "lamp", "--reactions", "all")}
KERNELS = "forward_dynamics,energy,frames,poses,reactions,constraints"


@pytest.fixture(scope="module", params=[(name, kind) for name in OUTPUTS for kind in (Unit2, Unit3)],
                ids=lambda p: f"{p[0]}-{p[1].version}")
def unit(request, tmp_path_factory):
    name, kind = request.param
    return kind(name, tmp_path_factory.mktemp(name), "--flags=-O0", *OUTPUTS[name])


@pytest.fixture(scope="module")
def mechanisms():
    return {name: scene(name, "--kernels", KERNELS) for name in OUTPUTS}


@pytest.fixture(scope="module")
def mechanism(unit, mechanisms):
    return mechanisms[unit.description.attrib["modelName"]]


FRAMES = {"loading_robot": ("ground", "S1", "guide", "S2", "S3"), "lamp": ("ground", "shaken", "rail", "trolley", "lamp", "plane")}


def expected(mechanism, name, time, y, u):
    """The outputs by their names, by the C++ runtime's kernels."""
    q, v = y[:len(mechanism.coordinates)], y[len(mechanism.coordinates):]
    motion = mechanism.forward_dynamics(q, v, u, time=time)
    energy = mechanism.energy(q, v, u, time=time)
    frames, poses = mechanism.frames(q, v, time=time), mechanism.poses(q, time=time)
    values = {"energy.kinetic": energy.kinetic, "energy.potential": -energy.force_function,
              "energy.total": energy.kinetic - energy.force_function}
    values |= {f"multiplier.{m}": value for m, value in zip(mechanism.multipliers, motion.multipliers)}
    for point in ("O2",) if name == "loading_robot" else ("foot", "bulb"):
        values |= {f"point.{point}.{c}": value for c, value in zip("xyz", getattr(frames, f"{point}_position"))}
    for frame in ("S3", "S1") if name == "loading_robot" else ("lamp",):
        k = FRAMES[name].index(frame)
        values |= {f"frame.{frame}.{c}": value for c, value in zip("xyz", poses.origins[:, k])}
        turn = poses.rotations[:, k].reshape(3, 3, order="F")
        values |= {f"frame.{frame}.rotation[{i + 1},{j + 1}]": turn[i, j] for i in range(3) for j in range(3)}
    reactions = mechanism.reactions(q, v, motion.accelerations, motion.multipliers, u, time=time)
    values |= {f"reaction.{r}": value for r, value in zip(["Y12"] if name == "loading_robot" else ["lift"], np.atleast_1d(reactions))}
    return values


def pushed(unit, component):
    """Inputs that matter, set."""
    inputs = [v["name"] for v in unit.variables if v["causality"] == "input"]
    values = 3.0 + np.arange(len(inputs))
    assert unit.set(component, inputs, values) == OK
    return values


def assert_outputs(unit, mechanism, component, time, y, u):
    wanted = expected(mechanism, unit.description.attrib["modelName"], time, y, u)
    names = [unit.by_reference[k]["name"] for k in unit.outputs]
    assert sorted(names) == sorted(wanted)
    wanted = np.array([wanted[name] for name in names], dtype=float)
    # The same formulas, in another order where a kernel of fewer results shares other products.
    np.testing.assert_allclose(unit.get(component, names), wanted, rtol=1e-12, atol=1e-12 * np.abs(wanted).max())


def test_outputs_are_those_of_the_runtime_in_model_exchange(unit, mechanism):
    component = unit.continuous()
    u, y, time = pushed(unit, component), unit.state(component), 0.0
    for _ in range(40):
        assert_outputs(unit, mechanism, component, time, y, u)
        time += 0.01
        unit.right_side(component, time, y + 0.01 * unit.right_side(component, time - 0.01, y))
        assert unit.complete_step(component)[0] == OK
        y = unit.state(component)
    unit.FreeInstance(component)


def test_outputs_are_those_of_the_runtime_in_co_simulation(unit, mechanism):
    component = unit.initialised(CO_SIMULATION, tolerance=1e-10)
    u = pushed(unit, component)
    for k in range(20):
        assert_outputs(unit, mechanism, component, 0.02 * k, unit.get(component, unit.states), u)
        assert unit.step(component, 0.02 * k, 0.02) == OK
    unit.FreeInstance(component)


def test_outputs_are_there_during_the_initialisation(unit, mechanism):
    component = unit.instantiate(MODEL_EXCHANGE)
    assert unit.initialise(component) == OK
    u = pushed(unit, component)
    assert_outputs(unit, mechanism, component, 0.0, unit.get(component, unit.states), u)
    # A start value that is set is seen at once.
    before = unit.get(component, unit.outputs)
    assert unit.set(component, [unit.states[0]], [0.3]) == OK
    assert not np.array_equal(unit.get(component, unit.outputs), before)
    unit.FreeInstance(component)


@pytest.mark.parametrize("kind", [CO_SIMULATION, MODEL_EXCHANGE])
def test_nothing_is_computed_of_parameters_that_no_mechanism_has(unit, kind):
    """It is refused with what is wrong, and not with numbers, where one that is read is computed of it."""
    if not [v for v in unit.variables if v["causality"] == "parameter"]:
        pytest.skip("no run-time parameters")
    said = b"body 'lamp' has the mass m = -2 kg: a mass is never negative"
    component = unit.initialised(kind)
    computed, given = unit.derivatives + unit.outputs, [k for k in unit.by_reference if k not in unit.derivatives + unit.outputs]
    pointer, _ = doubles(np.zeros(len(computed)))
    refused = [lambda k=k: unit.get_numbers(component, unit.references([k]), 1, pointer) for k in computed]
    refused += [lambda k=k: unit.directional(component, [k], unit.states[:1], [1.0], pointer) for k in computed]
    if kind == MODEL_EXCHANGE:
        refused.append(lambda: unit.get_derivatives(component, pointer))
    if unit.version == 3:
        refused.append(lambda: unit.adjoint(component, unit.derivatives[:1], unit.states[:1], [1.0], pointer))
    for mass, answer in ((-2.0, DISCARD), (2.0, OK)):
        assert unit.set(component, ["parameter.m"], [mass]) == OK
        unit.get(component, given)
        unit.messages.clear()
        assert [call() for call in refused] == [answer] * len(refused)
        assert all(text.split(b": ", 1)[1].startswith(said) for _, text in unit.messages)
        assert len(unit.messages) == (len(refused) if answer == DISCARD else 0)
    unit.FreeInstance(component)


def test_outputs_have_units(unit):
    wanted = {"energy": "J", "point": "m", "reaction": "N", "multiplier": "N"}
    for k in unit.outputs:
        name = unit.by_reference[k]["name"]
        assert unit.by_reference[k].get("unit") == (None if "rotation" in name else wanted.get(name.split(".")[0], "m"))


def generic(unit, component, mechanism):
    """A state that nothing is special about, on its constraints."""
    y = unit.state(component) + 0.1 * np.random.default_rng(5).normal(size=unit.n)
    for i in mechanism.quaternions:
        y[i:i + 4] /= np.linalg.norm(y[i:i + 4])
    return y


def test_directional_derivatives_of_outputs_are_slopes(unit, mechanism):
    component = unit.continuous()
    u, y = pushed(unit, component), generic(unit, component, mechanism)
    inputs = [v["name"] for v in unit.variables if v["causality"] == "input"]
    known = unit.states + [unit.reference[name] for name in inputs]

    def values(at):
        unit.right_side(component, 0.2, at[:unit.n])
        assert unit.set(component, inputs, at[unit.n:]) == OK
        return unit.get(component, unit.outputs)

    at = np.concatenate([y, u])
    scale = np.abs(values(at)).max()
    for k in range(len(known)):
        seed = np.zeros(len(known))
        seed[k] = 1.0
        for i in mechanism.quaternions:  # along the sphere of unit quaternions, where motions are
            seed[i:i + 4] -= y[i:i + 4] * (y[i:i + 4] @ seed[i:i + 4])
        h = 1e-5
        slope = (values(at + h * seed) - values(at - h * seed)) / (2 * h)
        values(at)
        pointer, exact = doubles(np.zeros(len(unit.outputs)))
        assert unit.directional(component, unit.outputs, known, seed, pointer) == OK
        # Central differences: h^2/6 of third derivatives, a thousand times the values, and roundings of values over h.
        np.testing.assert_allclose(exact, slope, rtol=0, atol=scale * (1e3 * h**2 + 1e-15 / h))
        # Asked for one by one, each by the kernels that it needs alone.
        for j, output in enumerate(unit.outputs):
            pointer, alone = doubles(np.zeros(1))
            assert unit.directional(component, [output], known, seed, pointer) == OK
            assert alone[0] == exact[j]
    unit.FreeInstance(component)


def test_directional_derivatives_by_parameters_are_slopes(unit, mechanism):
    if not [v for v in unit.variables if v["causality"] == "parameter"]:
        pytest.skip("no run-time parameters")
    component = unit.continuous()
    pushed(unit, component)
    unit.right_side(component, 0.2, generic(unit, component, mechanism))
    assert unit.EnterEventMode(component) == OK
    assert_slopes_by_parameters(unit, component)
    unit.FreeInstance(component)


def test_outputs_depend_on_what_the_description_says(unit, mechanism):
    """Neither on less nor on more: of a pose not on velocities, of no energy on inputs."""
    component = unit.continuous()
    pushed(unit, component)
    y, time = generic(unit, component, mechanism), 0.2
    listed = {k: on for k, on in unit.dependencies().items() if on is not None}
    assert [unit.by_reference[k]["name"].split(".")[0] for k in unit.dependencies() if k not in listed] == [
        *["multiplier"] * len(mechanism.multipliers), "reaction"]
    inputs = [int(v["valueReference"]) for v in unit.variables if v["causality"] == "input"]
    unit.right_side(component, time, y)
    before = unit.get(component, list(listed))
    for k in unit.states + inputs:
        changed = y.copy()
        if k in inputs:
            unit.right_side(component, time, y)
            assert unit.set(component, [k], [17.0]) == OK
        else:
            changed[unit.states.index(k)] += 0.01
            unit.right_side(component, time, changed)
        for (output, on), value, old in zip(listed.items(), unit.get(component, list(listed)), before):
            assert (value != old) == (k in on), (unit.by_reference[output]["name"], unit.by_reference[k]["name"])
    if unit.version == 3:
        unit.right_side(component, time + 0.01, y)
        for (output, on), value, old in zip(listed.items(), unit.get(component, list(listed)), before):
            assert (value != old) == (unit.reference["time"] in on)
    unit.FreeInstance(component)


def test_initial_unknowns_depend_on_parameters_too(unit, mechanism):
    listed = {k: on for k, on in unit.dependencies(initially=True).items() if on is not None}
    always = unit.dependencies()
    assert sorted(listed) == sorted(k for k, on in always.items() if on is not None)
    tuned = [int(v["valueReference"]) for v in unit.variables if v["causality"] == "parameter"]
    for k, on in listed.items():
        # FMI 2.0 knows of parameters at the start alone.
        assert set(on) - set(tuned) == set(always[k]) - set(tuned)
        assert unit.version == 3 and on == always[k] or unit.version == 2 and not set(always[k]) & set(tuned)
    component = unit.continuous()
    y = generic(unit, component, mechanism)
    unit.right_side(component, 0.2, y)
    assert unit.EnterEventMode(component) == OK
    before = unit.get(component, list(listed))
    for k in tuned:
        kept = unit.get(component, [k])
        assert unit.set(component, [k], 1.1 * kept) == OK
        for (output, on), value, old in zip(listed.items(), unit.get(component, list(listed)), before):
            assert (value != old) == (k in on), (unit.by_reference[output]["name"], unit.by_reference[k]["name"])
        assert unit.set(component, [k], kept) == OK
    unit.FreeInstance(component)


# Of what units of these scenes are written in.
BASES = {"m": {"m": 1}, "kg": {"kg": 1}, "s": {"s": 1}, "rad": {"rad": 1}, "N": {"kg": 1, "m": 1, "s": -2},
         "J": {"kg": 1, "m": 2, "s": -2}, "W": {"kg": 1, "m": 2, "s": -3}}


def base_of(text):
    """Exponents of "kg m^2/s": products by spaces, what is divided by behind slashes."""
    total = {}
    for sign, part in [(1 if k == 0 else -1, part) for k, part in enumerate(text.split("/"))]:
        for factor in part.strip("()").split():
            name, _, power = factor.partition("^")
            for base, exponent in ({} if name == "1" else BASES[name]).items():
                total[base] = total.get(base, 0) + sign * exponent * int(power or 1)
    return {base: exponent for base, exponent in total.items() if exponent}


def test_units_have_their_base_units(unit):
    seen = set()
    for each in unit.description.find("UnitDefinitions"):
        bases = {base: int(exponent) for base, exponent in each.find("BaseUnit").attrib.items()}
        assert bases == base_of(each.attrib["name"]), each.attrib["name"]
        seen.add(each.attrib["name"])
    assert {"J", "m", "rad/s", "N"} <= seen


def test_angles_keep_their_unit_wherever_it_stands(tmp_path):
    (tmp_path / "spring.cpp").write_text(r"""
        #include "torsor/generator/torsor.hpp"
        torsor::Scene spring_scene() {
          using namespace torsor;
          Scene scene("spring", "A disk on a torsional spring");
          const Expression c = scene.parameter("c", "N m/rad", 2), b = scene.parameter("b", "N m s/rad", 1);
          const Expression d = scene.parameter("d", "N m/(rad/s)", 1), e = scene.parameter("e", "N m/(rad s)/s^(-2)", 1);
          const Expression theta = scene.coordinate("theta", "rad");
          scene.body("disk", scene.revolute("disk", scene.ground(), axis::y, theta), Inertia::disk(scene.parameter("m", "kg", 1),
                     scene.parameter("r", "m", 1), 1));
          scene.spring("spring", theta, c);
          scene.damper("damper", theta, b + d + e);
          return scene;
        }
        TORSOR_SCENE(spring_scene)""")
    path = tmp_path / "spring.fmu"
    subprocess.run([os.environ["TORSOR"], "fmu", tmp_path / "spring.cpp", "--sources-only", "--run-time", "all", "-o", path], check=True)
    with zipfile.ZipFile(path) as archive:
        root = ElementTree.fromstring(archive.read("modelDescription.xml"))
    units = {u.attrib["name"]: {k: int(v) for k, v in u.find("BaseUnit").attrib.items()} for u in root.find("UnitDefinitions")}
    assert units["N m/rad"] == {"kg": 1, "m": 2, "s": -2, "rad": -1}
    assert units["N m s/rad"] == units["N m/(rad/s)"] == units["N m/(rad s)/s^(-2)"] == {"kg": 1, "m": 2, "s": -1, "rad": -1}
    assert units["rad/s^2"] == {"s": -2, "rad": 1} and units["rad"] == {"rad": 1}


def test_names_that_do_not_exist_are_refused(tmp_path):
    for option, name, text in (("--points", "O3", "unknown point 'O3' in --points: .*the scene 'loading_robot' has Oo, O2"),
                               ("--frames", "giude", "unknown frame 'giude' in --frames: did you mean 'guide'?"),
                               ("--reactions", "alpha", "unknown released coordinate 'alpha' in --reactions: .* has Y12")):
        said = subprocess.run(command("loading_robot", "fmu", option, name, "-o", tmp_path / "x.fmu"), capture_output=True,
                              text=True, check=False)
        assert said.returncode == 2 and re.search(text, said.stderr), said.stderr
        assert said.stderr.count("\n") == 1 and not (tmp_path / "x.fmu").exists()


def test_what_is_not_asked_for_is_not_there(tmp_path):
    path = tmp_path / "x.fmu"
    subprocess.run(command("loading_robot", "fmu", "--sources-only", "-o", path), check=True)
    with zipfile.ZipFile(path) as archive:
        text = archive.read("sources/loading_robot.h").decode()
        description = archive.read("modelDescription.xml").decode()
    assert "energy_derivatives(" in text
    assert not re.search(r"loading_robot_(output_places|output_reactions|kinematics|frames|poses|reactions)\(", text)
    assert not re.search(r'name="(point|frame|reaction)\.', description)


def test_names_are_structured(tmp_path):
    """Frames of a joint of several freedoms are hoop.x to hoop.2: a digit is no name."""
    path = tmp_path / "x.fmu"
    subprocess.run(command("rolling_hoop", "fmu", "--sources-only", "--points", "all", "--frames", "all", "-o", path), check=True)
    with zipfile.ZipFile(path) as archive:
        names = re.findall(r'<ScalarVariable name="([^"]*)"', archive.read("modelDescription.xml").decode())
    assert {"frame.hoop.'2'.x", "frame.hoop.x.z", "frame.ground.rotation[3,3]", "point.I.y"} <= set(names)
    part = r"([A-Za-z_]\w*|'[^']+')(\[\d+(,\d+)*\])?"
    for name in names:
        assert re.fullmatch(rf"({part}(\.{part})*|der\({part}(\.{part})*\))", name), name


def test_links_of_a_robot_are_outputs(tmp_path):
    """--points of the file's own options."""
    path = tmp_path / "x.fmu"
    subprocess.run(command("cart_pole", "fmu", "--sources-only", "--points", "pole", "--frames", "cart", "-o", path), check=True)
    with zipfile.ZipFile(path) as archive:
        names = re.findall(r' name="([^"]*)" .*causality="output"', archive.read("modelDescription.xml").decode())
    assert names[:6] == ["energy.kinetic", "energy.potential", "energy.total", "point.pole_origin.x",
                         "point.pole_origin.y", "point.pole_origin.z"]
    assert names[6:10] == ["frame.cart.x", "frame.cart.y", "frame.cart.z", "frame.cart.rotation[1,1]"] and len(names) == 18
