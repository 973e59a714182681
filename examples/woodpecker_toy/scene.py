# SPDX-License-Identifier: MIT
"""A woodpecker on a sleeve that a spring joins it to slides down a pole. The sleeve is wider than the pole: it jams by
friction where it tilts, and the nods of the bird free it. Numbers of Glocker (1995), who takes the tilt as small."""
from torsor.scene import Inertia, Rotation, Scene, axis, form, quantity, shape

scene = Scene("woodpecker_toy", "A woodpecker slides down its pole in jerks")

m_sleeve = scene.parameter("m_sleeve", "kg", 0.0003)
J_sleeve = scene.parameter("J_sleeve", "kg m^2", 5e-9)
m_bird = scene.parameter("m_bird", "kg", 0.0045)
J_bird = scene.parameter("J_bird", "kg m^2", 7e-7)
c = scene.parameter("c", "N m/rad", 0.0056)
g = scene.parameter("g", "m/s^2", 9.81)
r_pole = scene.parameter("r_pole", "m", 0.0025)
r_sleeve = scene.parameter("r_sleeve", "m", 0.0031)
h_sleeve = scene.parameter("h_sleeve", "m", 0.0058)
l_spring = scene.parameter("l_spring", "m", 0.010)
l_bird = scene.parameter("l_bird", "m", 0.015)
l_beak = scene.parameter("l_beak", "m", 0.0201)
h_beak = scene.parameter("h_beak", "m", 0.02)
f = scene.run_time_parameter("f", "1", 0.3)
e = scene.run_time_parameter("e", "1", 0.5)

# The sleeve's centre stays on the pole's axis; both angles are from the level, the bird is on the side of x.
z = scene.coordinate("z", "m")
phi = scene.coordinate("phi", "rad")
theta = scene.coordinate("theta", "rad")
scene.initial(z, 0, quantity("-0.34", "m/s"))
scene.initial(theta, -0.28, quantity("-7.4", "rad/s"))

slide = scene.prismatic("slide", scene.ground, axis.z, z)
sleeve = scene.revolute("sleeve", slide, (0, -1, 0), phi)
bird = scene.revolute("bird", sleeve, (0, -1, 0), theta - phi, origin=(l_spring, 0, 0))
scene.body("sleeve", sleeve, Inertia.general(m_sleeve, J_sleeve, J_sleeve, J_sleeve))
scene.body("bird", bird, Inertia.general(m_bird, J_bird, J_bird, J_bird).at((l_bird, 0, 0)))
scene.spring("spring", theta - phi, c)
scene.gravity((0, 0, -g))

# The side of the pole towards the bird; of the sleeve the edges on that side, as the others are as far from the pole.
pole = scene.weld("pole", scene.ground, origin=(r_pole, 0, 0), rotation=Rotation.about(1, 6))
beak = scene.point("beak", bird, (l_bird - l_beak, 0, h_beak))
lower = scene.point("lower_edge", sleeve, (r_sleeve, 0, -h_sleeve))
upper = scene.point("upper_edge", sleeve, (r_sleeve, 0, h_sleeve))
scene.contact("peck", shape.Point(beak), shape.Plane(pole), friction=f, restitution=e)
scene.contact("low", shape.Point(lower), shape.Plane(pole), friction=f)
scene.contact("high", shape.Point(upper), shape.Plane(pole), friction=f)

thin = r_pole / 4
scene.show(scene.ground, form.Cylinder(r_pole, 14 * h_sleeve), origin=(0, 0, -4 * h_sleeve))
scene.show(sleeve, form.Cylinder(r_sleeve, 2 * h_sleeve))
scene.show(bird, form.Segment((0, 0, 0), (l_bird, 0, 0), thin))
scene.show(bird, form.Sphere(l_bird / 2), origin=(l_bird, 0, 0))
scene.show(bird, form.Segment((l_bird, 0, 0), (l_bird - l_beak, 0, h_beak), 2 * thin))

if __name__ == "__main__":
    scene.main()
