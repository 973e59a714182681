# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of FMI whose bodies touch: from event to event, of the unit or of the importer, against closed forms."""

import os
import subprocess
import threading
import xml.etree.ElementTree as ElementTree
import zipfile
from ctypes import CDLL, byref, c_bool, c_double, c_size_t, c_void_p

import numpy as np
import pytest

from conftest import command
from fmi_importer import CO_SIMULATION, DISCARD, ERROR, MODEL_EXCHANGE, OK, begun, doubles, exchanged

R, G, F, V, M = 0.028575, 9.81, 0.2, 2.0, 0.17  # of the example billiard
FRAME = "ball"


@pytest.fixture
def unit(fmi_billiard):
    return fmi_billiard

def test_description_tells_of_indicators(unit):
    kinds = [child.tag for child in unit.description][:2]
    assert kinds == ["ModelExchange", "CoSimulation"]
    provided = ["providesDirectionalDerivative"] if unit.version == 2 else ["providesDirectionalDerivatives", "providesAdjointDerivatives"]
    for kind in kinds:
        told = unit.description.find(kind).attrib
        assert [name for name in told if "Derivative" in name] == provided and {told[name] for name in provided} == {"true"}
    assert {name.split("/")[0] for name in unit.names} == {"modelDescription.xml", "documentation", "binaries", "sources"}
    outputs = [v["name"] for v in unit.variables if v["causality"] == "output"]
    assert outputs[:4] == ["energy.kinetic", "energy.potential", "energy.total", f"frame.{FRAME}.x"] and len(outputs) == 15
    assert [unit.by_reference[k]["name"] for k in unit.outputs] == outputs
    assert unit.listed_derivatives == unit.derivatives and unit.n == 13
    follow = [unit.reference[v["name"]] for v in unit.variables if v.get("initial") == "approx"]
    assert [unit.by_reference[k]["name"] for k in follow] == ["q.z"]  # the ball starts as high as it is wide
    assert unit.initial_unknowns == sorted(follow + unit.derivatives + unit.outputs)
    indicators = [int(v["valueReference"]) for v in unit.variables if v["name"].startswith("indicator.cloth.")]
    assert unit.indicator_count == len(indicators) == 3
    if unit.version == 3:
        assert unit.listed("EventIndicator") == indicators
        assert [child.tag for child in unit.description.find("ModelStructure")][-3:] == ["EventIndicator"] * 3
        count = c_size_t(7)
        component = unit.instantiate(MODEL_EXCHANGE)
        assert unit.GetNumberOfEventIndicators(component, byref(count)) == OK and count.value == 3
        unit.FreeInstance(component)


def test_a_step_needs_little_stack(unit):
    """Matrices have room for as many contacts as the unit has: of 32 contacts they take 2 MB."""
    component, answers = begun(unit, ["q.z", "parameter.e"], [R + 0.05, 0.5]), []

    def move():
        for k in range(10):
            answers.append(unit.step(component, 0.05 * k, 0.05))

    before = threading.stack_size(128 * 1024)
    try:
        thread = threading.Thread(target=move)
        thread.start()
        thread.join()
    finally:
        threading.stack_size(before)
    assert answers == [OK] * 10
    unit.FreeInstance(component)


def test_licences_of_what_is_compiled_in_are_told(unit):
    assert unit.description.attrib["license"] == "MIT-0 AND MIT AND MPL-2.0"
    folder = unit.folder / "documentation/licenses"
    assert sorted(file.name for file in folder.iterdir()) == ["MIT-0.txt", "MIT.txt", "license.txt"]
    assert "The above copyright notice and this permission notice shall be included" in (folder / "MIT.txt").read_text()
    assert all(name in (folder / "license.txt").read_text() for name in ("MIT-0.txt", "MIT.txt", "Eigen 3", "Mozilla Public License 2.0"))


def slid(t, f):
    """Place and velocity of a ball that is struck in its middle: it slides for 2 V/(7 f g), then rolls with 5/7 V."""
    end = 2 * V / (7 * f * G)
    at = min(t, end)
    return V * at - f * G * at**2 / 2 + 5 / 7 * V * (t - at), V - f * G * at


@pytest.mark.parametrize("f", [F, 0.35])
def test_a_ball_slides_then_rolls(unit, f):
    component = begun(unit, ["parameter.f"], [f])
    for k in range(20):
        assert unit.step(component, 0.05 * k, 0.05) == OK
        # 1e-12 a step; events are located to rounding.
        np.testing.assert_allclose(unit.get(component, ["q.x", "v.x"]), slid(0.05 * (k + 1), f), rtol=0, atol=1e-10)
        np.testing.assert_allclose(unit.get(component, ["q.z"]), R, rtol=0, atol=1e-14)
    unit.FreeInstance(component)


def spun(t):
    """Angle and angular velocity of that ball: 5 f g/(2 R) is what it gains while it slides."""
    end, gain = 2 * V / (7 * F * G), 5 * F * G / (2 * R)
    at = min(t, end)
    return gain * at**2 / 2 + gain * end * (t - at), gain * at


@pytest.mark.parametrize("kind", [CO_SIMULATION, MODEL_EXCHANGE])
def test_outputs_follow_a_ball_that_slides_then_rolls(unit, kind):
    component = begun(unit) if kind == CO_SIMULATION else exchanged(unit)
    turn = [f"frame.ball.rotation[{i},{j}]" for i in (1, 2, 3) for j in (1, 2, 3)]
    for k in range(12):
        time = 0.05 * k
        (x, v), (angle, rate) = slid(time, F), spun(time)
        kinetic, c, s = M * v**2 / 2 + 0.2 * M * R**2 * rate**2, np.cos(angle), np.sin(angle)
        found = unit.get(component, ["energy.kinetic", "energy.potential", "energy.total", *[f"frame.ball.{a}" for a in "xyz"], *turn])
        # 1e-12 a step, some hundred steps; the turn grows to 30 rad.
        np.testing.assert_allclose(found, [kinetic, M * G * R, kinetic + M * G * R, x, 0, R, c, 0, s, 0, 1, 0, -s, 0, c], rtol=0, atol=1e-9)
        if kind == CO_SIMULATION:
            assert unit.step(component, time, 0.05) == OK
        else:
            unit.integrated(component, time, time + 0.05)
    unit.FreeInstance(component)


def test_outputs_depend_on_states_and_parameters(unit):
    def named(dependencies):
        return {unit.by_reference[k]["name"]: None if of is None else {unit.by_reference[j]["name"] for j in of}
                for k, of in dependencies.items()}
    names = named(unit.dependencies(initially=True))
    moving = {v["name"] for v in unit.variables if v["name"].startswith("v.")}
    assert moving | {"parameter.R", "parameter.m"} <= names["energy.kinetic"] and len(moving) == 6
    assert not names["energy.kinetic"] & {"q.x", "q.y", "q.z", "parameter.g", "parameter.f", "parameter.e"}
    # The height at the start is no known there: it follows the radius. Later it is a state.
    constants = {"parameter.m", "parameter.g"} if unit.version == 3 else set()
    assert names["energy.potential"] is None and named(unit.dependencies())["energy.potential"] == {"q.z"} | constants
    assert names["frame.ball.x"] == {"q.x"} and names["frame.ball.rotation[2,2]"] <= {"q.turn_w", "q.turn_x", "q.turn_y", "q.turn_z"}


@pytest.mark.parametrize("f", [F, 0.35])
def test_an_importer_sees_it_slide_then_roll(unit, f):
    component = exchanged(unit, ["parameter.f"], [f])
    indicators = [v["name"] for v in unit.variables if v["name"].startswith("indicator.")]
    # The force that presses is the weight, at an unknown mass; the slip is the velocity.
    assert np.array_equal(unit.get(component, indicators), unit.indicators(component))
    np.testing.assert_allclose(unit.indicators(component)[1], V, rtol=1e-12)
    # Slope of a slip: - f g.
    np.testing.assert_allclose(unit.get(component, ["der(v.x)", "der(q.x)"]), [-f * G, V], rtol=0, atol=1e-12)
    end = 2 * V / (7 * f * G)
    times = unit.integrated(component, 0.0, 1.5)
    # 1e-12 a step; the last event is the end of the slip, after one where the slip nears it.
    assert abs(times[-1] - end) < 1e-10 and len(times) <= 2
    np.testing.assert_allclose(unit.get(component, ["q.x", "v.x"]), slid(1.5, f), rtol=0, atol=1e-10)
    np.testing.assert_allclose(unit.get(component, ["q.z"]), R, rtol=0, atol=1e-12)
    np.testing.assert_allclose(unit.get(component, ["der(v.x)"]), 0.0, atol=1e-12)
    unit.FreeInstance(component)


def test_an_importer_sees_bounces_come_to_an_end(unit):
    component = exchanged(unit, ["q.z", "v.x", "parameter.e"], [R + 0.1, 0.0, 0.5])
    fall = np.sqrt(2 * 0.1 / G)
    times = unit.integrated(component, 0.0, 4 * fall)
    np.testing.assert_allclose(times[:6], 3 * fall - 2 * fall * 0.5 ** np.arange(6), rtol=0, atol=1e-10)
    # Flights that rise by less than 1e6 roundings of R + 0.1 m, 3e-11 m, are passed at once: 2 w/g = 5e-6 s are left of them.
    assert abs(times[-1] - 3 * fall) < 1e-5
    np.testing.assert_allclose(unit.get(component, ["q.z"]), R, rtol=0, atol=1e-10)
    assert np.abs(unit.get(component, ["v.z"])).max() < 1e-12
    unit.FreeInstance(component)


def test_an_event_is_of_its_state(unit):
    """A state that was kept in model exchange has its regimes again."""
    component = exchanged(unit)
    state, end = c_void_p(), 2 * V / (7 * F * G)
    unit.integrated(component, 0.0, 0.5 * end)
    assert getattr(unit, unit.memory["get"])(component, byref(state)) == OK
    unit.integrated(component, 0.5 * end, 2 * end)
    after = unit.get(component, ["q.x", "v.x"])
    assert unit.EnterEventMode(component) == OK
    assert unit.set(component, ["parameter.f"], [0.5]) == OK
    assert getattr(unit, unit.memory["set"])(component, state) == OK
    np.testing.assert_allclose(unit.get(component, ["der(v.x)"]), -F * G, rtol=0, atol=1e-12)
    unit.integrated(component, 0.5 * end, 2 * end)
    np.testing.assert_allclose(unit.get(component, ["q.x", "v.x"]), after, rtol=0, atol=1e-10)
    getattr(unit, unit.memory["free"])(component, byref(state))
    unit.FreeInstance(component)


def test_a_parameter_of_a_surface_is_tuned_at_an_event(unit):
    component = exchanged(unit)
    assert unit.EnterEventMode(component) == OK
    assert unit.set(component, ["parameter.f"], [0.5]) == OK
    assert not unit.update(component)
    np.testing.assert_allclose(unit.get(component, ["der(v.x)"]), -0.5 * G, rtol=0, atol=1e-12)
    assert unit.set(component, ["parameter.f"], [-0.5]) == OK
    unit.messages.clear()
    with pytest.raises(AssertionError):
        unit.update(component)
    assert unit.messages[0][1].endswith(b": contact 'cloth' has the friction f = -0.5: a surface never pushes along the slip")
    unit.FreeInstance(component)


def test_a_parameter_is_tuned_at_an_event_found_late(unit):
    """A micrometre below the cloth, before the ball has struck it and after: the gap is not that of a start."""
    component = exchanged(unit, ["q.z", "v.x"], [R + 0.1, 0.0])
    kept = unit.state(component)
    states = [unit.variables[unit.state_of(unit.variables[d])]["name"] for d in unit.derivatives]
    z, rise = states.index("q.z"), states.index("v.z")
    for speed, after in ((-1.0, 0.5), (1.0, 1.0)):
        kept[z], kept[rise] = R - 1e-6, speed
        assert unit.SetContinuousStates(component, doubles(kept)[0], c_size_t(unit.n)) == OK
        assert unit.EnterEventMode(component) == OK
        assert unit.set(component, ["parameter.e"], [0.5]) == OK
        assert unit.update(component) == (speed < 0)  # it strikes, or has struck
        np.testing.assert_allclose(unit.get(component, ["v.z", "der(v.z)"]), [after, -G], rtol=0, atol=1e-12)
        assert unit.indicators(component).min() > 0
        assert unit.EnterContinuousTimeMode(component) == OK
    unit.FreeInstance(component)
    for kind in (CO_SIMULATION, MODEL_EXCHANGE):
        below = begun(unit, ["q.z"], [R - 1e-6], kind)
        unit.messages.clear()
        if kind == MODEL_EXCHANGE:
            with pytest.raises(AssertionError):
                unit.update(below)
        else:
            assert unit.step(below, 0, 0.1) == DISCARD
        (_, said), = unit.messages
        assert b": a contact starts below its surface: " in said and said.endswith(b"; contact 'cloth': its gap is -1e-06")
        unit.FreeInstance(below)


def test_bounces_come_to_an_end(unit):
    """From 0.1 m with e = 1/2: impacts at T, 2 T, 2.5 T and so on, T the time of the first fall, which tend to 3 T."""
    component = begun(unit, ["q.z", "v.x", "parameter.e"], [R + 0.1, 0.0, 0.5])
    fall = np.sqrt(2 * 0.1 / G)
    steps = [0.5 * fall, fall, 0.75 * fall, fall]
    heights = [0.075, 0.025, 0.00625, 0.0]  # on the way, at the tops of two flights, at rest
    time = 0.0
    for size, height in zip(steps, heights):
        assert unit.step(component, time, size) == OK
        time += size
        np.testing.assert_allclose(unit.get(component, ["q.z"]), R + height, rtol=0, atol=1e-10)
    assert np.abs(unit.get(component, ["v.z"])).max() < 1e-12
    unit.FreeInstance(component)


def test_a_law_that_no_surface_has_ends_the_motion(unit):
    component = begun(unit)
    assert unit.set(component, ["parameter.e"], [2.0]) == OK
    unit.messages.clear()
    assert unit.step(component, 0, 0.1) == DISCARD
    assert unit.messages[0][1].endswith(b"DoStep: contact 'cloth' has the restitution e = 2: it must lie between 0 and 1")
    unit.FreeInstance(component)


@pytest.mark.parametrize("name, value, said", [
    ("f", -1.0, b"contact 'cloth' has the friction f = -1: a surface never pushes along the slip"),
    ("m", -1.0, b"body 'ball' has the mass m = -1 kg: a mass is never negative")])
def test_nothing_is_computed_of_parameters_that_no_mechanism_has(unit, name, value, said):
    component = begun(unit, kind=MODEL_EXCHANGE)
    unit.update(component)
    pointer, _ = doubles(np.zeros(unit.n))
    indicators, _ = doubles(np.zeros(unit.indicator_count))
    computed = ["der(v.x)", "der(q.x)", "energy.kinetic", f"frame.{FRAME}.z", "indicator.cloth.opens_or_closes"]
    calls = [lambda name=name: unit.get_numbers(component, unit.references([name]), 1, pointer) for name in computed]
    calls += [lambda: unit.get_derivatives(component, pointer),
              lambda: unit.GetEventIndicators(component, indicators, c_size_t(unit.indicator_count)),
              lambda: unit.directional(component, ["energy.kinetic"], ["v.x"], [1.0], pointer)]
    for given, answer in ((value, DISCARD), (0.25, OK)):
        assert unit.set(component, [f"parameter.{name}"], [given]) == OK
        unit.messages.clear()
        assert [call() for call in calls] == [answer] * len(calls)
        assert [text.split(b": ", 1)[1].startswith(said) for _, text in unit.messages] == [True] * (len(calls) if answer else 0)
    unit.FreeInstance(component)


def test_indicators_can_be_read_while_states_are_initialised(unit):
    component = unit.instantiate(MODEL_EXCHANGE)
    assert unit.initialise(component) == OK and unit.set(component, ["q.z"], [R + 0.5]) == OK
    np.testing.assert_allclose(unit.indicators(component), [0.5, 1, 1], rtol=0, atol=1e-15)  # the gap; nothing else is watched
    assert unit.state(component)[2] == R + 0.5
    unit.FreeInstance(component)


def test_a_quaternion_of_zeros_begins_nothing(unit):
    said = b"the quaternion (q.turn_w, q.turn_x, q.turn_y, q.turn_z) is zero, which is no attitude: set one of norm 1"
    zero = [f"q.turn_{k}" for k in "wxyz"]
    component = begun(unit, zero, [0.0] * 4)
    unit.messages.clear()
    assert unit.step(component, 0, 0.1) == DISCARD
    assert [text.split(b": ", 1)[1] for _, text in unit.messages] == [said]
    assert (unit.get(component, zero) == 0).all() and unit.get(component, ["q.x"]) == 0
    unit.FreeInstance(component)
    component = begun(unit, zero, [0.0] * 4, MODEL_EXCHANGE)
    unit.messages.clear()
    pointer, _ = doubles(np.zeros(unit.n))
    assert unit.get_derivatives(component, pointer) == DISCARD
    with pytest.raises(AssertionError):
        unit.update(component)
    assert [text.split(b": ", 1)[1] for _, text in unit.messages] == [said] * 2
    unit.FreeInstance(component)


def test_states_are_restored(unit):
    component = begun(unit)
    state, names = c_void_p(), ["q.x", "v.x", "q.turn_y", "parameter.f"]
    assert unit.step(component, 0, 0.25) == OK
    assert getattr(unit, unit.memory["get"])(component, byref(state)) == OK
    assert unit.step(component, 0.25, 0.25) == OK
    after = unit.get(component, names)
    assert unit.set(component, ["parameter.f"], [0.5]) == OK
    assert getattr(unit, unit.memory["set"])(component, state) == OK
    assert unit.step(component, 0.25, 0.25) == OK
    assert np.array_equal(unit.get(component, names), after)
    getattr(unit, unit.memory["free"])(component, byref(state))
    unit.FreeInstance(component)


def test_survives_calls_in_any_order(unit):
    """Good and bad calls at random: each is answered, and an instance beside them moves as ever."""
    random = np.random.default_rng(1)
    state, info = c_void_p(), [v["name"] for v in unit.variables]
    odd = [0.0, -1.0, 1e-300, 1e300, np.inf, np.nan]

    def number():
        return odd[random.integers(6)] if random.integers(10) == 0 else random.uniform(-1, 1)

    def update(component):
        try:
            unit.update(component)
        except AssertionError:  # the motion ends, or no event was on
            pass
        return OK

    memory = {key: getattr(unit, name) for key, name in unit.memory.items()}
    calls = [lambda c: unit.set(c, [info[random.integers(len(info))]], [number()]),
             lambda c: unit.get_numbers(c, unit.references([info[random.integers(len(info))]]), 1, doubles(np.zeros(1))[0]),
             lambda c: unit.SetTime(c, c_double(abs(number()))), lambda c: unit.set(c, ["parameter.f"], [-1.0]),
             lambda c: unit.SetContinuousStates(c, doubles([R * number() for _ in range(unit.n)])[0], c_size_t(unit.n)),
             lambda c: unit.SetContinuousStates(c, doubles(known)[0], c_size_t(unit.n)),
             lambda c: unit.get_derivatives(c, doubles(np.zeros(unit.n))[0]),
             lambda c: unit.GetEventIndicators(c, doubles(np.zeros(unit.indicator_count))[0], c_size_t(unit.indicator_count)),
             lambda c: unit.complete_step(c)[0], update, lambda c: unit.EnterEventMode(c), lambda c: unit.EnterContinuousTimeMode(c),
             lambda c: unit.DoStep(c, c_double(0), c_double(number()), *rest), lambda c: memory["get"](c, byref(state)),
             lambda c: memory["set"](c, state) if state else OK, lambda c: unit.Terminate(c), lambda c: unit.Reset(c)]
    rest = [1] if unit.version == 2 else [c_bool(True), *[byref(c_bool()) for _ in range(3)], byref(c_double())]
    answers = {OK: 0, DISCARD: 0, ERROR: 0}
    for _ in range(60):
        kind = int(random.integers(2))
        component = exchanged(unit) if kind == MODEL_EXCHANGE else begun(unit)
        known = unit.state(component) if kind == MODEL_EXCHANGE else np.zeros(unit.n)
        for _ in range(25):
            answers[calls[random.integers(len(calls))](component)] += 1
        if state:
            assert memory["free"](component, byref(state)) in (OK, ERROR)
            state = c_void_p()
        unit.FreeInstance(component)
    assert answers[OK] > 300 and answers[ERROR] > 300 and answers[DISCARD] > 0
    test_a_ball_slides_then_rolls(unit, F)


def test_sources_are_those_that_the_description_names(unit):
    if unit.version == 2:
        for kind in ("ModelExchange", "CoSimulation"):
            files = [f.attrib["name"] for f in unit.description.find(kind).iter("File")]
            assert files == ["billiard_fmi2.c", "billiard_contacts.cpp", "contact_layer.cpp"]
    else:
        for build in ElementTree.parse(unit.folder / "sources/buildDescription.xml").getroot():
            assert [(s.attrib["language"], [f.attrib["name"] for f in s.iter("SourceFile")], [f.attrib["name"] for f in s.iter("IncludeDirectory")])
                    for s in build.findall("SourceFileSet")] == [
                ("C99", ["billiard_fmi3.c"], []), ("C++20", ["billiard_contacts.cpp", "contact_layer.cpp"], ["."])]
            assert "Eigen" in build.attrib["description"]
    texts = {name for name in unit.names if name.startswith("sources/") and not name.endswith(".xml")}
    assert not [name for name in texts if b"SPDX-License-Identifier: MIT" not in (unit.folder / name).read_bytes()]


def test_sources_move_as_the_binary_does(unit, tmp_path):
    """Compiled as the description says, with the headers of Eigen and without an option. The contact layer takes half a minute."""
    if unit.version == 2 or not os.environ.get("TORSOR_LONG_TESTS"):
        pytest.skip("the same files" if unit.version == 2 else "with scripts/test --long")
    sources, objects = unit.folder / "sources", []
    for variable, words, file in (("CC", ["cc", "-std=c99"], "billiard_fmi3.c"),
                                  ("CXX", ["c++", "-std=c++20", "-isystem", os.environ["EIGEN"], "-I", sources], "billiard_contacts.cpp"),
                                  ("CXX", ["c++", "-std=c++20", "-isystem", os.environ["EIGEN"], "-I", sources], "contact_layer.cpp")):
        compiler, *options = words
        objects.append(tmp_path / f"{file}.o")
        subprocess.run([os.environ.get(variable, compiler), *options, "-fPIC", "-c", "-o", objects[-1], sources / file], check=True)
    library = tmp_path / "unit.so"
    subprocess.run([os.environ.get("CXX", "c++"), "-shared", "-o", library, *objects], check=True)
    states, own = [], unit.library
    try:
        for unit.library in (own, CDLL(str(library))):
            component = begun(unit, ["parameter.f"], [0.3])
            for k in range(20):
                assert unit.step(component, 0.05 * k, 0.05) == OK
            states.append(unit.get(component, list(range(2 * unit.n))))
            unit.FreeInstance(component)
    finally:
        unit.library = own
    assert np.array_equal(*states)


def test_sources_alone_are_a_unit(tmp_path):
    subprocess.run([*command("billiard", "fmu", "--sources-only", "-o", tmp_path / "x.fmu")], check=True)
    with zipfile.ZipFile(tmp_path / "x.fmu") as archive:
        assert {name.split("/")[0] for name in archive.namelist()} == {"modelDescription.xml", "documentation", "sources"}


@pytest.fixture
def cart(fmi_cart_with_stops):
    return fmi_cart_with_stops


def test_a_stop_hears_of_inputs(cart):
    """Two inputs at one time and one state: accelerations differ by their difference over the masses."""
    run = exchanged(cart, ["input.slide_force"], [0.0])
    found = []
    for push in (0.0, 1.2):
        assert cart.set(run, ["input.slide_force"], [push]) == OK
        found.append(cart.get(run, ["der(v.slide)"])[0])
    # The pole stands still at its start: 1 kg and 0.2 kg, less what the pole turns.
    assert found[1] - found[0] > 1.0
    cart.FreeInstance(run)


def test_an_importer_reaches_the_state_of_the_runtime(cart):
    """Pushed against its stop and held there: the pole swings on, and pulls the cart off again when the push ends."""
    pushed = ["input.slide_force"]
    moved, run = begun(cart, pushed, [20.0]), exchanged(cart, pushed, [20.0])
    for k in range(8):
        assert cart.step(moved, 0.25 * k, 0.25) == OK
    events = cart.integrated(run, 0.0, 2.0)
    names = ["q.slide", "q.hinge", "v.slide", "v.hinge"]
    assert events and abs(cart.get(run, ["q.slide"])[0] - 10.0) < 1e-10
    # 1e-12 a step and some hundred steps; errors grow by e^(4 t) at most.
    np.testing.assert_allclose(cart.get(run, names), cart.get(moved, names), rtol=0, atol=1e-8)
    assert cart.set(moved, pushed, [-1.0]) == OK
    assert cart.EnterEventMode(run) == OK
    assert cart.set(run, pushed, [-1.0]) == OK
    assert not cart.update(run)
    assert cart.EnterContinuousTimeMode(run) == OK
    for k in range(4):
        assert cart.step(moved, 2.0 + 0.25 * k, 0.25) == OK
    cart.integrated(run, 2.0, 3.0)
    assert cart.get(run, ["q.slide"])[0] < 9.9
    np.testing.assert_allclose(cart.get(run, names), cart.get(moved, names), rtol=0, atol=1e-7)
    cart.FreeInstance(moved)
    cart.FreeInstance(run)
