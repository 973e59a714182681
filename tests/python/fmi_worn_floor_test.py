# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of FMI whose surfaces have coefficients that no parameter tells of: the contact layer refuses them where it moves."""

import re

import numpy as np
import pytest

from fmi_importer import (CO_SIMULATION, DISCARD, MODEL_EXCHANGE, OK, Unit2, Unit3, assert_slopes_by_parameters,
                          assert_slopes_while_regimes_last, doubles)


@pytest.fixture(scope="module", params=(Unit2, Unit3), ids=("2", "3"))
def worn(request, tmp_path_factory):
    return request.param("worn_floor", tmp_path_factory.mktemp("worn_floor"), "--flags=-O0")


def test_a_friction_that_is_no_number_ends_the_motion(worn):
    """Not below zero, so that no parameter is refused: the contact layer says it, with the coefficients."""
    said = rb"a contact's rule is impossible: .*; contact 'floor': friction inf and inf, bound 0 and 0, restitution 0$"
    component = worn.initialised(CO_SIMULATION)
    assert worn.step(component, 0, 0.1) == OK and worn.set(component, ["parameter.wear"], [0.0]) == OK
    worn.messages.clear()
    assert worn.step(component, 0.1, 0.1) == DISCARD
    assert [bool(re.search(said, text)) for _, text in worn.messages] == [True]
    worn.FreeInstance(component)
    component = worn.initialised(MODEL_EXCHANGE)
    assert worn.set(component, ["parameter.wear"], [0.0]) == OK
    worn.messages.clear()
    pointer, _ = doubles(np.zeros(worn.n))
    assert worn.get_derivatives(component, pointer) == DISCARD
    assert [bool(re.search(said, text)) for _, text in worn.messages] == [True]
    worn.FreeInstance(component)


def test_accelerations_have_derivatives_where_a_joint_rubs_and_a_loop_is_closed(worn):
    component = worn.continuous(1e-12)
    worn.integrated(component, 0.0, 0.1)
    columns = assert_slopes_while_regimes_last(worn, component)
    assert np.abs(columns[worn.derivatives.index(worn.reference["der(v.turn)"])]).max() > 1
    assert worn.EnterEventMode(component) == OK
    assert_slopes_by_parameters(worn, component)
    worn.FreeInstance(component)
