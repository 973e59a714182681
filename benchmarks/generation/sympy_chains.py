#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""sympy_chains.py [--limit SECONDS] [--output FILE.csv]: processor seconds of SymPy's LagrangesMethod and KanesMethod for the
chains of serial_chain.cpp, one joint more each time until the limit is passed.

Measured is the time to the mass matrix and the forcing vector, nothing simplified, and the operations of both after
cse(), which is what one would compile (left empty where cse() passes the limit). Every run is a process of its own.
"""
import argparse
import importlib.metadata
import math
import resource
import subprocess
import sys
import time


class Decimals:
    """The numbers of serial_chain.cpp: the minimal standard generator, in millionths."""

    def __init__(self):
        self.state = 1

    def between(self, low, high):
        from sympy import Rational
        self.state = self.state * 48271 % 2147483647
        return Rational(low + self.state % (high - low), 1000000)


def chain(joints):
    """Ground frame, coordinates, speeds, their kinematic equations, bodies with weights."""
    from sympy import Rational
    from sympy.physics.mechanics import Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia
    random = Decimals()
    g = Rational(981, 100)
    ground, origin = ReferenceFrame('N'), Point('O')
    origin.set_vel(ground, 0)
    q, u = dynamicsymbols('q1:%d' % (joints + 1)), dynamicsymbols('u1:%d' % (joints + 1))
    frame, joint, bodies, loads, heights = ground, origin, [], [], []
    for k in range(joints):
        moment = random.between
        mass = moment(1000000, 1500000)
        xx, yy, zz = moment(6000, 8000), moment(6000, 8000), moment(2000, 2700)
        xy, xz, yz = moment(-200, 200), moment(-200, 200), moment(-200, 200)
        x, y, z = moment(-20000, 20000), moment(-20000, 20000), moment(110000, 140000)
        link = frame.orientnew('L%d' % k, 'Axis', [q[k], frame.x if k % 2 == 0 else frame.y])
        link.set_ang_vel(frame, u[k] * (frame.x if k % 2 == 0 else frame.y))
        if k > 0:
            joint_k = joint.locatenew('P%d' % k, frame.z * Rational(1, 4))
            joint_k.v2pt_theory(joint, ground, frame)
            joint = joint_k
        centre = joint.locatenew('C%d' % k, x * link.x + y * link.y + z * link.z)
        centre.v2pt_theory(joint, ground, link)
        bodies.append(RigidBody('B%d' % k, centre, link, mass, (inertia(link, xx, yy, zz, xy, yz, xz), centre)))
        loads.append((centre, -mass * g * ground.z))
        heights.append((mass * g, centre.pos_from(origin)))
        frame = link
    for body, (weight, position) in zip(bodies, heights):
        body.potential_energy = weight * position.dot(ground.z)
    return ground, q, u, bodies, loads


def lagrange(joints):
    from sympy.physics.mechanics import Lagrangian, LagrangesMethod, dynamicsymbols
    ground, q, u, bodies, _ = chain(joints)
    speeds = {speed: coordinate.diff(dynamicsymbols._t) for coordinate, speed in zip(q, u)}
    method = LagrangesMethod(Lagrangian(ground, *bodies).subs(speeds), q)
    method.form_lagranges_equations()
    return method.mass_matrix, method.forcing


def kane(joints):
    from sympy.physics.mechanics import KanesMethod, dynamicsymbols
    ground, q, u, bodies, loads = chain(joints)
    kinematic = [speed - coordinate.diff(dynamicsymbols._t) for coordinate, speed in zip(q, u)]
    method = KanesMethod(ground, q, u, kinematic)
    method.kanes_equations(bodies, loads)
    return method.mass_matrix, method.forcing


def alone(name, joints):
    """In a process of its own: prints the seconds, then the operations."""
    from sympy import count_ops, cse
    start = time.process_time()
    results = {'LagrangesMethod': lagrange, 'KanesMethod': kane}[name](joints)
    print('%.3f' % (time.process_time() - start), flush=True)
    definitions, reduced = cse(results)
    print(count_ops([value for _, value in definitions]) + sum(count_ops(matrix) for matrix in reduced), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--limit', type=float, default=20, help='processor seconds for one chain and method (20)')
    parser.add_argument('--joints', type=int, default=64, help='no longer chains than this')
    parser.add_argument('--output', help='CSV file')
    parser.add_argument('--alone', nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.alone:
        return alone(options.alone[0], int(options.alone[1]))
    rows = ['method,joints,seconds,operations']
    print('SymPy %s' % importlib.metadata.version('sympy'))
    print('%-16s%8s%10s%12s' % ('method', 'joints', 'seconds', 'operations'))
    for name in ('LagrangesMethod', 'KanesMethod'):
        for joints in range(1, options.joints + 1):
            command = [sys.executable, __file__, '--alone', name, str(joints)]
            seconds = math.ceil(options.limit)
            done = subprocess.run(command, stdout=subprocess.PIPE, check=False,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds)))
            said = done.stdout.decode().split()
            if done.returncode > 0:  # a signal's number is negative: the limit's is meant to come
                return done.returncode
            if not said:
                print('%-16s%8d   more than %g s' % (name, joints, options.limit), flush=True)
                break
            said += [''] * (2 - len(said))
            print('%-16s%8d%10s%12s' % (name, joints, *said), flush=True)
            rows.append('%s,%d,%s,%s' % (name, joints, *said))
    if options.output:
        with open(options.output, 'w', encoding='utf-8') as file:
            file.write('\n'.join(rows) + '\n')
    return 0


if __name__ == '__main__':
    sys.exit(main())
