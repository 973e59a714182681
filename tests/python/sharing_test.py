# SPDX-License-Identifier: GPL-3.0-or-later
"""Mechanisms among threads and processes, and arguments that are none."""

import copy
import pickle
import subprocess
import sys
import threading

import numpy as np
import pytest

import torsor
from torsor._models import Model, Models


def test_threads_may_give_parameters_at_once(pendulum):
    """More sets of parameters than are kept; a thread that waits in the midst of a call finds others there afterwards."""
    failed = []

    def work(seed):
        try:
            for m in np.random.default_rng(seed).uniform(1, 2, size=500):
                # The mass matrix is linear in the masses: both of them m times those of one kilogram.
                many = pendulum.mass_matrix([0.3, -0.4], parameters={"m1": m, "m2": m})
                assert np.abs(many - m * one).max() <= 1e-14 * np.abs(many).max()  # some roundings of each entry
        except BaseException as error:
            failed.append(error)

    one = pendulum.mass_matrix([0.3, -0.4], parameters={"m1": 1.0, "m2": 1.0})
    threads = [threading.Thread(target=work, args=(seed,)) for seed in range(16)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert not failed, failed[0]


def test_parameters_live_as_long_as_the_call_that_reads_them(pendulum, monkeypatch):
    """None are kept for later calls here: what one call holds is all that holds them."""
    monkeypatch.setattr(Models, "LIMIT", 0)
    heavy = pendulum.with_parameters(m1=3.0)
    kernel, gone = heavy.mass_matrix, []
    evaluate, destroy = kernel._evaluate, Model.__del__
    monkeypatch.setattr(Model, "__del__", lambda model: (gone.append(model.address), destroy(model)))

    def watched(address):
        assert not gone
        return evaluate(address)

    monkeypatch.setattr(kernel, "_evaluate", watched)
    kernel([0.3, -0.4], parameters={"m2": 2.0})
    assert len(gone) == 1
    bound = kernel.bind([0.3, -0.4], parameters={"m2": 2.0})
    gone.clear()
    bound()
    assert not gone


@pytest.mark.parametrize("again", [lambda x: pickle.loads(pickle.dumps(x)), copy.deepcopy, copy.copy])
def test_mechanisms_and_results_are_pickled_and_copied(pendulum, again):
    heavy = pendulum.with_parameters(m1=3.0)
    q, v = [0.3, -0.4], [1.0, 2.0]
    expected = heavy.forward_dynamics(q, v)
    for found in (again(heavy).forward_dynamics(q, v), again(heavy.forward_dynamics)(q, v), again(expected)):
        assert found._fields == expected._fields and found.ok
        assert np.array_equal(found.accelerations, expected.accelerations)
    assert not np.array_equal(pendulum.forward_dynamics(q, v).accelerations, expected.accelerations)


def test_another_process_goes_on_with_a_mechanism(pendulum):
    """As the workers of multiprocessing do; parameters go along."""
    program = "import pickle, sys; print(pickle.load(sys.stdin.buffer).energy([0.3, -0.4], [1.0, 2.0]).kinetic.hex())"
    heavy = pendulum.with_parameters(m1=3.0)
    said = subprocess.run([sys.executable, "-c", program.replace(".hex()", ".item().hex()")], input=pickle.dumps(heavy),
                          capture_output=True, check=True)
    assert float.fromhex(said.stdout.decode()) == heavy.energy([0.3, -0.4], [1.0, 2.0]).kinetic


def test_a_library_that_was_built_anew_is_no_pickled_one(pendulum, rod):
    kind, (*arguments,) = pendulum.__reduce__()
    arguments[1] = rod.path
    with pytest.raises(OSError, match="holds another mechanism now"):
        kind(*arguments)


def test_no_motions_are_no_error(pendulum):
    motion = pendulum.simulate([0.0, 1.0], np.zeros((0, 2)))
    assert motion.q.shape == (0, 2, 2) and motion.energy.shape == (0, 2) and motion.ok.shape == (0,)


def test_a_law_that_gives_no_number_is_named(cart):
    with pytest.raises(torsor.TorsorError, match=r"inputs at t = 0\.[1-9]\d* s are no finite numbers"):
        cart.simulate(1.0, inputs=lambda t, q, v: [np.nan if t > 0.1 else 0.0, 0.0], step=0.01, method="midpoint")


def test_arguments_that_are_none_are_named(pendulum):
    q = [0.3, -0.4]
    with pytest.raises(TypeError, match="missing 1 required argument: 'q'"):
        pendulum.energy(None)
    with pytest.raises(ValueError, match="q: masked values are no numbers"):
        pendulum.energy(np.ma.masked_array(q, mask=[True, False]))
    assert pendulum.energy(np.ma.masked_array(q)).kinetic == 0
    with pytest.raises(TypeError, match="parameters: give a mapping of names to numbers, not a list"):
        pendulum.energy(q, parameters=[1.0])
    for threads in (-1, 2**40):
        with pytest.raises(ValueError, match=f"threads: {threads} is no number of threads"):
            pendulum.energy(q, threads=threads)
        with pytest.raises(ValueError, match=f"threads: {threads} is no number of threads"):
            pendulum.simulate(0.1, threads=threads)
    with pytest.raises(ValueError, match="out: energy has no result 'kinetics'; there are kinetic"):
        pendulum.energy(q, out={"kinetics": np.zeros(())})
    with pytest.raises(ValueError, match=r"q: one state is asked for: shape \(3, 2\) is not \(2,\)"):
        pendulum.modes(np.zeros((3, 2)))
    with pytest.raises(ValueError, match=r"q: one state is asked for: shape \(3, 2\) is not \(2,\)"):
        pendulum.equilibria(np.zeros((3, 2)))
    with pytest.raises(TypeError, match="options: give a sequence of words"):
        torsor.load(__file__, options="--base")
