# SPDX-License-Identifier: GPL-3.0-or-later
"""What importers and their validators ask of units of FMI beside the motion: names, pages, messages, sources to build in."""

import ctypes
import os
import re
import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile
from ctypes import byref, c_char_p, c_size_t, c_void_p

import pytest

from conftest import command
from fmi_importer import CO_SIMULATION, ERROR, OK, Unit2, Unit3, doubles

# The grammar of structured names of FMI 2.0 and 3.0.
QUOTED = r"""'(?:[A-Za-z0-9_!#$%&()*+,\-./:;<>=?@\[\]^{}|~ ]|\\['"?\\abfnrtv])+'"""
PART = rf"(?:[A-Za-z_][A-Za-z0-9_]*|{QUOTED})(?:\[[0-9]+(?:,[0-9]+)*\])?"
STRUCTURED = re.compile(rf"{PART}(?:\.{PART})*|der\({PART}(?:\.{PART})*(?:,[0-9]+)?\)")


@pytest.fixture(scope="module", params=[Unit2, Unit3], ids=["2", "3"])
def unit(request, tmp_path_factory):
    return request.param("double_pendulum", tmp_path_factory.mktemp("double_pendulum"), "--flags=-O0", "--run-time", "all")


def read(path, *names):
    with zipfile.ZipFile(path) as archive:
        return [ElementTree.fromstring(archive.read(name)) for name in names]


@pytest.mark.parametrize("version", [2, 3])
def test_odd_names_are_written_as_xml_and_the_standard_have_them(version, tmp_path):
    path = tmp_path / "odd.fmu"
    words = command("odd_names", "fmu", "--fmi", str(version), "--frames", "all", "--sources-only", "-o", path)
    subprocess.run(words, check=True)
    root, page = read(path, "modelDescription.xml", "documentation/index.html")
    assert root.attrib["description"] == page.find("body/p").text == 'A "pendulum" & <its> frames'
    names = [v.attrib["name"] for v in root.find("ModelVariables")]
    assert [row.find("td").text for row in page.iter("tr") if row.find("td") is not None] == names
    assert len(set(names)) == len(names) and root.attrib["variableNamingConvention"] == "structured"
    assert [name for name in names if not STRUCTURED.fullmatch(name)] == []
    places = {name.removeprefix("frame.").removesuffix(".x") for name in names if name.endswith(".x")}
    assert places == {"ground", r"""'rod <&> \"it\'s\" \\n'""", "'a frame'", "'2'.nd", "'a..b'", "'c.'", "'d[1]'", "'e,f?'"}


def test_the_page_lists_all_variables(unit):
    page = ElementTree.parse(unit.folder / "documentation/index.html").getroot()
    rows = [[cell.text for cell in row] for row in page.iter("tr")][1:]
    assert [row[0] for row in rows] == [v["name"] for v in unit.variables]
    for (_, what, measure, start), v in zip(rows, unit.variables):
        assert measure == v.get("unit", "1") and start == v.get("start")
        assert what in {"input": ["input"], "output": ["output"], "parameter": ["tunable parameter"], "independent": ["time"],
                        "local": ["state", "derivative"]}[v["causality"]]


def test_memory_that_an_importer_offers_is_not_taken(unit):
    """allocateMemory and freeMemory of FMI 2.0, which our importer does not even offer."""
    if unit.version == 3:
        pytest.skip("FMI 3.0 has no such functions")
    kinds = [unit.description.find(kind).attrib for kind in ("ModelExchange", "CoSimulation")]
    assert [kind["canNotUseMemoryManagementFunctions"] for kind in kinds] == ["true", "true"]
    assert not unit.callbacks.allocate and not unit.callbacks.free


def exported(library):
    lines = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True).stdout.splitlines()
    return {line.split()[-1] for line in lines}


@pytest.mark.parametrize("defined, prefix", [
    (["FUNCTION_PREFIX=one_"], "one_"),
    (["FUNCTION_PREFIX="], ""),
    (["FUNCTION_PREFIX=one_", "OVERRIDE_FUNCTION_PREFIX"], ""),
    (["FUNCTION_PREFIX=one_", "OVERRIDE_FUNCTION_PREFIX", "ACTUAL_FUNCTION_PREFIX=two_"], "two_")])
def test_functions_have_the_prefix_that_an_importer_asks_for(unit, defined, prefix, tmp_path):
    """Importers that link several units into one program cannot have two functions of a name."""
    source, = (unit.folder / "sources").glob("*.c")
    library = tmp_path / "unit.so"
    subprocess.run([os.environ.get("CC", "cc"), "-std=c99", "-fPIC", "-shared", *[f"-DFMI{unit.version}_{each}" for each in defined],
                    "-o", library, source, "-lm"], check=True)
    plain = exported(unit.library._name)
    assert len(plain) == (44 if unit.version == 2 else 75) and {name[:4] for name in plain} == {f"fmi{unit.version}"}
    assert exported(library) == {prefix + name for name in plain}
    version = getattr(ctypes.CDLL(str(library)), f"{prefix}fmi{unit.version}GetVersion")
    version.restype = c_char_p
    assert version() == f"{unit.version}.0".encode()


def test_messages_are_of_the_categories_that_are_asked_for(unit):
    component = unit.instantiate(CO_SIMULATION, logging=False)
    boolean = ctypes.c_int if unit.version == 2 else ctypes.c_bool

    def heard(on, *categories):
        array = (c_char_p * len(categories))(*categories)
        answer = unit.SetDebugLogging(component, boolean(on), c_size_t(len(categories)), array)
        unit.messages.clear()
        assert unit.step(component, 0, 0.1) == ERROR
        return answer, len(unit.messages)

    assert heard(False) == (OK, 0)
    assert heard(True) == (OK, 1)
    assert heard(True, b"logStatusDiscard") == (OK, 0)
    assert heard(True, b"logStatusDiscard", b"logStatusError") == (OK, 1)
    assert heard(True, b"logEvents") == (ERROR, 1)  # and what was asked for before stays
    unit.FreeInstance(component)


def test_bytes_of_another_order_are_refused(unit):
    """Before the numbers of a state stand its token and a third, whose eight bytes differ from their reverse."""
    component = unit.initialised(CO_SIMULATION)
    call = {what: getattr(unit, name) for what, name in unit.memory.items()}
    state, size = c_void_p(), c_size_t()
    assert call["get"](component, byref(state)) == OK and call["size"](component, state, byref(size)) == OK
    written = ctypes.create_string_buffer(size.value)
    assert call["write"](component, state, written, size) == OK
    begin = len(unit.token) + 1
    third = written.raw[begin:begin + 8]
    assert doubles([1 / 3])[1].tobytes() == third
    other = ctypes.create_string_buffer(written.raw[:begin] + third[::-1] + written.raw[begin + 8:], size.value)
    assert call["read"](component, written, size, byref(state)) == OK
    assert call["read"](component, other, size, byref(state)) == ERROR
    assert b"these bytes are no state of this unit" in unit.messages[-1][1]
    call["free"](component, byref(state))
    unit.FreeInstance(component)
