# SPDX-License-Identifier: MIT
"""Arm with seven revolute joints: geometry and inertia of Franka Emika's Panda, a motor on each joint, z up."""
from torsor.scene import Inertia, Rotation, Scene, axis, quantity

# One link with the joint that carries it, which turns about its own z: turn of the joint about the parent's x in units of 15
# degrees, its origin in the parent [m], mass [kg], centre of mass [m], inertia about it: xx, xy, xz, yy, yz, zz [kg m^2].
SEGMENTS = (
    (0, ("0", "0", "0.333"), "4.970684", ("0.003875", "0.002081", "-0.175"),
     ("0.70337", "-0.000139", "0.006772", "0.70661", "0.019169", "0.009117")),
    (-6, ("0", "0", "0"), "0.646926", ("-0.003141", "-0.02872", "0.003495"),
     ("0.007962", "-0.003925", "0.010254", "0.02811", "0.000704", "0.025995")),
    (6, ("0", "-0.316", "0"), "3.228604", ("0.027518", "0.039252", "-0.066502"),
     ("0.037242", "-0.004761", "-0.011396", "0.036155", "-0.012805", "0.01083")),
    (6, ("0.0825", "0", "0"), "3.587895", ("-0.05317", "0.104419", "0.027454"),
     ("0.025853", "0.007796", "-0.001332", "0.019552", "0.008641", "0.028323")),
    (-6, ("-0.0825", "0.384", "0"), "1.225946", ("-0.011953", "0.041065", "-0.038437"),
     ("0.035549", "-0.002117", "-0.004037", "0.029474", "0.000229", "0.008627")),
    (6, ("0", "0", "0"), "1.666555", ("0.060149", "-0.014117", "-0.010517"),
     ("0.001964", "0.000109", "-0.001158", "0.004354", "0.000341", "0.005433")),
    (6, ("0.088", "0", "0"), "0.735522", ("0.010517", "-0.004252", "0.061597"),
     ("0.012516", "-0.000428", "-0.001196", "0.010027", "-0.000741", "0.004815")),
)


def lengths(components):
    return tuple(quantity(component, "m") for component in components)


scene = Scene("arm7", "Arm with seven revolute joints")
start = ("0.3", "-0.7", "0.4", "-1.9", "0.2", "1.6", "-0.5")
parent = scene.ground
for i, (turn, origin, mass, center, inertia) in enumerate(SEGMENTS):
    q = scene.coordinate(f"q{i + 1}", "rad")
    scene.initial(q, start[i])
    parent = scene.revolute(f"link{i + 1}", parent, axis.z, q, origin=lengths(origin), rotation=Rotation.about(0, turn))
    xx, xy, xz, yy, yz, zz = (quantity(moment, "kg m^2") for moment in inertia)
    scene.body(f"link{i + 1}", parent, Inertia.general(quantity(mass, "kg"), xx, yy, zz, xy, xz, yz).at(lengths(center)))
    scene.motor(f"tau{i + 1}", q)
scene.point("tip", parent, (0, 0, quantity("0.107", "m")))
scene.gravity((0, 0, quantity("-9.81", "m/s^2")))

if __name__ == "__main__":
    scene.main()
