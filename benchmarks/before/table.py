# SPDX-License-Identifier: GPL-3.0-or-later
"""table.py FOLDER BEFORE NOW: prints what before.sh has counted and timed, and times both programs on a chain of 64 joints."""
import json
import os
import resource
import subprocess
import sys

folder, programs = sys.argv[1], {"before": sys.argv[2], "now": sys.argv[3]}


def operations(when):
    with open(f"{folder}/{when}.json", encoding="utf-8") as file:
        return {name: kernel["total"] for name, kernel in json.load(file)["kernels"].items()}


def write_chain(path, joints):
    """Axes x, y, x, ...; no two links have the same numbers, so that nothing is computed once for two of them."""
    parts = ['<robot name="chain"><link name="l0"/>']
    for k in range(1, joints + 1):
        share = k / joints
        parts.append(
            f'<link name="l{k}"><inertial><origin xyz="{0.01 + 0.01 * share:.5f} {0.02 - 0.01 * share:.5f} 0.12"/>'
            f'<mass value="{1 + share:.5f}"/><inertia ixx="{0.006 + 0.001 * share:.6f}" ixy="{0.0001 * share:.7f}" ixz="0.0002"'
            f' iyy="{0.007 - 0.001 * share:.6f}" iyz="0.0001" izz="0.002"/></inertial></link>'
            f'<joint name="j{k}" type="continuous"><parent link="l{k - 1}"/><child link="l{k}"/><origin xyz="0 0 0.25"/>'
            f'<axis xyz="{k % 2} {1 - k % 2} 0"/></joint>')
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "</robot>\n")


def processor_seconds(program, chain):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "generate", chain, "--quiet", "--kernels", "inverse_dynamics,forward_dynamics", "--output", os.devnull],
                   check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


counts = {when: operations(when) for when in programs}
print(f"{'kernel':<30}{'operations':>11}{'now':>8}{'ns':>11}{'now':>11}{'now/before':>12}")
with open(f"{folder}/times.txt", encoding="utf-8") as file:
    for line in file:
        name, before, now = line.split()
        print(f"{name:<30}{counts['before'][name]:>11}{counts['now'][name]:>8}{float(before):>11.1f}{float(now):>11.1f}"
              f"{float(now) / float(before):>12.3f}")
write_chain(f"{folder}/chain64.urdf", 64)
least = {when: float("inf") for when in programs}
for _ in range(5):
    for when, program in programs.items():
        least[when] = min(least[when], processor_seconds(program, f"{folder}/chain64.urdf"))
print(f"{'64 joints to a header, s':<30}{'':>19}{least['before']:>11.2f}{least['now']:>11.2f}{least['now'] / least['before']:>12.3f}")
