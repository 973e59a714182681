# SPDX-License-Identifier: MIT
"""The bicycle of Whipple (1899) with the parameters of the benchmark of Meijaard, Papadopoulos, Ruina and Schwab (Proc. R. Soc.
A 463:1955-1982, 2007): rear wheel, rear frame with rider, front frame and front wheel; knife-edge wheels that roll on a plane
without slipping. Axes x forward, y to the right, z down; upright the rear wheel touches the origin. Nothing is linear here, and
the contacts are found by the generator."""
from torsor.scene import AngleSequence, Inertia, Rotation, Scene, axis, cos, pi, quantity, sin

scene = Scene("whipple_bicycle", "Whipple's bicycle: two rolling wheels, benchmark of 2007")

g = scene.parameter("g", "m/s^2", 9.81)
w = scene.parameter("w", "m", 1.02)  # wheel base
c = scene.parameter("c", "m", 0.08)  # trail
tilt = pi / 10  # of the steer axis, back from the vertical
r_R = scene.parameter("r_R", "m", 0.3)
r_F = scene.parameter("r_F", "m", 0.35)


def mass(name, value):
    return scene.parameter(name, "kg", value)


def moment(name, value):
    return scene.parameter(name, "kg m^2", value)


def length(name, value):
    return scene.parameter(name, "m", value)


x = scene.coordinate("x", "m")  # centre of the rear wheel
y = scene.coordinate("y", "m")
z = scene.coordinate("z", "m")
yaw = scene.coordinate("yaw", "rad")
roll = scene.coordinate("roll", "rad")
pitch = scene.coordinate("pitch", "rad")
steer = scene.coordinate("steer", "rad")
rear = scene.coordinate("rear", "rad")
front = scene.coordinate("front", "rad")

# Upright, straight ahead, begins to fall to the right.
v = quantity("4.6", "m/s")
falls = quantity("0.5", "rad/s")
scene.initial(x, 0, v)
scene.initial(y, 0, r_R * falls)
scene.initial(z, -r_R)
scene.initial(roll, 0, falls)
scene.initial(rear, 0, -v / r_R)
scene.initial(front, 0, -v / r_F)

road = scene.weld("road", scene.ground, origin=(0, 0, 0), rotation=Rotation.about(0, 12))  # its z is up
frame = scene.free("frame", scene.ground, AngleSequence((2, 0, 1)), (x, y, z), (yaw, roll, pitch))
rear_wheel = scene.revolute("rear_wheel", frame, axis.y, rear)
# The steer axis meets the road a trail ahead of the front contact.
fork = scene.revolute("fork", frame, (sin(tilt), 0, cos(tilt)), steer, origin=(w + c, 0, r_R))
hub = scene.weld("hub", fork, origin=(-c, 0, -r_F))
front_wheel = scene.revolute("front_wheel", hub, axis.y, front)

I_Rx = moment("I_Rxx", 0.0603)
I_Fx = moment("I_Fxx", 0.1405)
m_R = mass("m_R", 2)
I_Ry = moment("I_Ryy", 0.12)
scene.body("R", rear_wheel, Inertia.general(m_R, I_Rx, I_Ry, I_Rx))
x_B = length("x_B", 0.3)
z_B = length("z_B", -0.9)
m_B = mass("m_B", 85)
I_Bx = moment("I_Bxx", 9.2)
I_By = moment("I_Byy", 11)
I_Bz = moment("I_Bzz", 2.8)
I_Bxz = moment("I_Bxz", 2.4)
scene.body("B", frame, Inertia.general(m_B, I_Bx, I_By, I_Bz, 0, I_Bxz).at((x_B, 0, z_B + r_R)))
x_H = length("x_H", 0.9)
z_H = length("z_H", -0.7)
m_H = mass("m_H", 4)
I_Hx = moment("I_Hxx", 0.05892)
I_Hy = moment("I_Hyy", 0.06)
I_Hz = moment("I_Hzz", 0.00708)
I_Hxz = moment("I_Hxz", -0.00756)
scene.body("H", fork, Inertia.general(m_H, I_Hx, I_Hy, I_Hz, 0, I_Hxz).at((x_H - w - c, 0, z_H)))
m_F = mass("m_F", 3)
I_Fy = moment("I_Fyy", 0.28)
scene.body("F", front_wheel, Inertia.general(m_F, I_Fx, I_Fy, I_Fx))
scene.gravity((0, 0, g))

P = scene.disc_contact("P", frame=frame, axis=axis.y, radius=r_R, plane=road)
Q = scene.disc_contact("Q", frame=hub, axis=axis.y, radius=r_F, plane=road)
scene.point_in_plane("rear_touches", P, road)
scene.point_in_plane("front_touches", Q, road)
scene.rolling("rear_rolls", body=rear_wheel, on=scene.ground, contact=P, tangents=road)
scene.rolling("front_rolls", body=front_wheel, on=scene.ground, contact=Q, tangents=road)
scene.independent((roll, steer, rear))

if __name__ == "__main__":
    scene.main()
