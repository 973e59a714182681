# SPDX-License-Identifier: GPL-3.0-or-later
"""The motion of examples/clock_escapement without a generator: two equations of motion by hand, steps of Runge and Kutta of one
length, and events by bisection within a step. It prints what clock_escapement_test.cpp expects.

  clock_escapement_by_hand.py WEIGHT END STEP    events until END [s], the last extremes and losses; the start is the scene's

Angles are clockwise, x is to the right and z up: the velocity of a point (x, z) at the rate w is w (z, -x)."""
import math
import sys

R, R_PIN, R_PALLET, CLEAR, R_DRUM = 0.03, 0.0016, 0.005, 0.0046, 0.0015
L, BOB, D, G, J_WHEEL, F, PINS = 0.25, 0.2, 0.0015, 9.81, 5e-6, 0.1, 10
HEIGHT = math.sqrt(2) * R
ASIDE = (R + CLEAR) / math.sqrt(2)
J = BOB * L * L
PAIRS = [(pin, side) for pin in range(PINS) for side in (-1, 1)]  # the entry is on the left


class Clock:
    def __init__(self, weight):
        self.torque = weight * G * R_DRUM
        self.inertia = J_WHEEL + weight * R_DRUM**2
        self.pair, self.sign = None, 0  # which touch, and the sign of their slip

    def place(self, y, pair):
        """Pin from the wheel's axis, pallet from the pivot, the distance, and the normal from pallet to pin."""
        angle = y[0] + 2 * math.pi * pair[0] / PINS
        px, pz = R * math.sin(angle), R * math.cos(angle)
        c, s = math.cos(y[1]), math.sin(y[1])
        x, z = pair[1] * ASIDE, ASIDE - HEIGHT
        qx, qz = x * c + z * s, z * c - x * s
        dx, dz = px - qx, pz - qz - HEIGHT
        distance = math.hypot(dx, dz)
        return px, pz, qx, qz, distance, dx / distance, dz / distance

    def gap(self, y, pair):
        return self.place(y, pair)[4] - R_PIN - R_PALLET

    def rows(self, y, pair):
        """What the rates of wheel and pendulum add to the rate of the gap, and to the slip along (n_z, -n_x)."""
        px, pz, qx, qz, _, nx, nz = self.place(y, pair)
        normal = nx * pz - nz * px, -(nx * qz - nz * qx)
        slip = nz * pz + nx * px - R_PIN, -(nz * qz + nx * qx) - R_PALLET
        return normal, slip

    def drift(self, y, pair):
        """Of the gap's second derivative what is quadratic in the rates."""
        px, pz, qx, qz, distance, nx, nz = self.place(y, pair)
        vx, vz = y[2] * pz - y[3] * qz, y[3] * qx - y[2] * px
        ax, az = y[3] ** 2 * qx - y[2] ** 2 * px, y[3] ** 2 * qz - y[2] ** 2 * pz
        return (vx * vx + vz * vz - (vx * nx + vz * nz) ** 2) / distance + nx * ax + nz * az

    def free(self, y):
        return self.torque / self.inertia, -(BOB * G * L * math.sin(y[1]) + D * y[3]) / J

    def accelerations(self, y):
        """And the normal force: that with which the gap stays closed, while friction is against the slip."""
        a, b = self.free(y)
        if self.pair is None:
            return a, b, 0.0
        n, t = self.rows(y, self.pair)
        p, q = n[0] - F * self.sign * t[0], n[1] - F * self.sign * t[1]
        force = -(n[0] * a + n[1] * b + self.drift(y, self.pair)) / (n[0] * p / self.inertia + n[1] * q / J)
        return a + force * p / self.inertia, b + force * q / J, force

    def step(self, y, h):
        def rate(y):
            a, b, _ = self.accelerations(y)
            return y[2], y[3], a, b

        k1 = rate(y)
        k2 = rate([u + h / 2 * k for u, k in zip(y, k1)])
        k3 = rate([u + h / 2 * k for u, k in zip(y, k2)])
        k4 = rate([u + h * k for u, k in zip(y, k3)])
        return [u + h / 6 * (a + 2 * b + 2 * c + d) for u, a, b, c, d in zip(y, k1, k2, k3, k4)]

    def guards(self, y):
        """What must not fall below zero."""
        values = {pair: self.gap(y, pair) for pair in PAIRS if pair != self.pair}
        if self.pair is not None:
            slip = self.rows(y, self.pair)[1]
            values["opens"] = self.accelerations(y)[2]
            values["turns"] = self.sign * (slip[0] * y[2] + slip[1] * y[3])
        return values

    def sticking(self, rates):
        """N and T with which neither gap nor slip changes: of accelerations, or of velocities as impulses."""
        n, t = self.rows(self.y, self.pair)
        w = [[a[0] * b[0] / self.inertia + a[1] * b[1] / J for b in (n, t)] for a in (n, t)]
        q = [row[0] * rates[0] + row[1] * rates[1] for row in (n, t)]
        det = w[0][0] * w[1][1] - w[0][1] ** 2
        return (w[0][1] * q[1] - w[1][1] * q[0]) / det, (w[0][1] * q[0] - w[0][0] * q[1]) / det, w, q

    def impact(self):
        """Without restitution, with Coulomb's law of impulses."""
        y = self.y
        normal, tangential, w, q = self.sticking(y[2:])
        if abs(tangential) <= F * normal:
            raise SystemExit("a pin sticks to a pallet as it strikes: that is not here")
        found = []
        for sign in (1, -1):
            normal = -q[0] / (w[0][0] - F * sign * w[0][1])
            tangential = -F * sign * normal
            if normal >= 0 and sign * (q[1] + w[0][1] * normal + w[1][1] * tangential) >= 0:
                found.append((normal, tangential, sign))
        ((normal, tangential, self.sign),) = found
        n, t = self.rows(y, self.pair)
        y[2] += (n[0] * normal + t[0] * tangential) / self.inertia
        y[3] += (n[1] * normal + t[1] * tangential) / J

    def kinetic_energy(self):
        return (self.inertia * self.y[2] ** 2 + J * self.y[3] ** 2) / 2

    def move(self, end, h):
        """Yields time, event, pair, energy lost. A slip that cannot begin anew ends the motion: both stand."""
        self.y, time = [-math.pi / 36, 0.12, 0.0, 0.0], 0.0
        while time < end:
            length, event = h, None
            for guard, value in self.guards(self.step(self.y, h)).items():
                if value >= 0:
                    continue
                low, high = 0.0, h
                for _ in range(60):
                    middle = (low + high) / 2
                    if self.guards(self.step(self.y, middle))[guard] < 0:
                        high = middle
                    else:
                        low = middle
                if high <= length:
                    length, event = high, guard
            self.y = self.step(self.y, length)
            time += length
            pair, lost = self.pair, 0.0
            if event == "opens":
                self.pair = None
            elif event == "turns":
                normal, tangential, _, _ = self.sticking(self.free(self.y))
                self.sign = -self.sign
                if abs(tangential) <= F * normal:
                    yield time, "sticks", pair, 0.0
                    return
            elif event is not None:
                if pair is not None:
                    raise SystemExit("two pins touch: that is not here")
                pair, self.pair, before = event, event, self.kinetic_energy()
                event = "impact"
                self.impact()
                lost = before - self.kinetic_energy()
            if event is not None:
                yield time, event, pair, lost
            if self.pair is not None:  # errors of steps leave the surface by less than 1e-15 m
                n, _ = self.rows(self.y, self.pair)
                self.y[0] -= self.gap(self.y, self.pair) / n[0]
                self.y[2] = -n[1] * self.y[3] / n[0]


def main():
    weight, end, h = (float(word) for word in sys.argv[1:])
    clock, turns, losses = Clock(weight), [], []
    for time, event, (pin, side), lost in clock.move(end, h):
        if event == "turns":
            turns.append((time, clock.y[1]))
        if event == "impact":
            losses.append(lost)
        if end < 5:
            print(f"{time:.13g} {event} {'exit' if side > 0 else 'entry'}{pin + 1} {lost:.13g}")
    print(f"{len(losses)} impacts, the last two lose {sum(losses[-2:]):.9g} J; at the end {clock.y}")
    print(f"last extremes {turns[-2][1]:.10g} and {turns[-1][1]:.10g} rad, period {turns[-1][0] - turns[-3][0]:.10g} s")


if __name__ == "__main__":
    main()
