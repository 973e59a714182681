# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of co-simulation whose constraints follow laws of time that are faster than a step."""

import pytest

from fmi_importer import CO_SIMULATION, OK, Unit2, Unit3


@pytest.fixture(scope="module", params=[Unit2, Unit3], ids=lambda kind: str(kind.version))
def unit(request, tmp_path_factory):
    return request.param("rising", tmp_path_factory.mktemp("rising"), "--flags=-O0")


@pytest.mark.parametrize("steps", [[1.0], [0.3, 0.3, 0.3, 0.1], [0.25, 0.25, 0.25, 0.25]])
def test_a_speed_that_rises_within_a_step_is_followed(unit, steps):
    component, t = unit.initialised(CO_SIMULATION, tolerance=1e-9), 0.0
    for step in steps:
        assert unit.step(component, t, step) == OK
        t += step
    x, speed = unit.get(component, unit.states)
    # The integral of the law, by its symmetry; some hundred steps.
    assert abs(x - 0.5) < 1e-6 and abs(speed - 1) < 1e-9
    unit.FreeInstance(component)
