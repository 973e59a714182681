# SPDX-License-Identifier: MIT
"""The same ball on a cloth that gives way: moments up to h N resist its rolling, up to k N its spinning."""
from ball_on_cloth import ball_on_cloth


def soft(scene):
    return {"friction": scene.run_time_parameter("f", "1", 0.2), "restitution": scene.run_time_parameter("e", "1", 0),
            "rolling": scene.run_time_parameter("h", "m", 0.0005), "spinning": scene.run_time_parameter("k", "m", 0.0002)}


scene = ball_on_cloth("billiard_soft_cloth", "Billiard ball that slides, rolls, and comes to rest", soft)

if __name__ == "__main__":
    scene.main()
