"""Runs the examples in the help of every verb, in a folder where the source tree's files lie.

    examples_test.py HOST_SIM SOURCE SHARED
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SECTION = re.compile(r"^Subcommands:\n((?:  .*\n)+)", re.MULTILINE)
MEASUREMENTS = "data/davinci_cable_torque/Tool_4_Maryland_L_4.csv"
# Nobody has a bus of this name: the command line is read, and the bus refused.
NO_BUS = "can0nowhere"
DONE, REFUSED = 0, 1


def help_of(host_sim, verbs):
    return subprocess.run([host_sim, *verbs, "--help"], check=True, capture_output=True,
                          text=True).stdout


def all_verbs(host_sim, verbs=()):
    """Each with its help, the program first."""
    text = help_of(host_sim, verbs)
    yield verbs, text
    section = SECTION.search(text)
    for line in section.group(1).splitlines() if section else ():
        if line[2] != " ":
            yield from all_verbs(host_sim, (*verbs, line.split()[0]))


def examples_of(text):
    found = re.findall(r"^Example: (.*\n(?: {9}.*\n)*)", text + "\n", re.MULTILINE)
    return [line.strip() for block in found for line in block.splitlines()]


def prepared(command):
    """What is run, and the status that it has to have."""
    if "can0" in command:
        return command.replace("can0", NO_BUS), REFUSED
    if MEASUREMENTS.rsplit("/", 1)[1] in command and not os.path.exists(pathlib.Path(MEASUREMENTS).name):
        print(f"the measurements are not there: only read: {command}")
        return command, REFUSED
    return command, DONE


def run(command):
    command, expected = prepared(command)
    environment = {**os.environ, "PATH": f"{os.getcwd()}/bin:{os.environ['PATH']}"}
    result = subprocess.run(["bash", "-c", f"set -o pipefail; {command}"], env=environment,
                            capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if result.returncode == expected:
        return []
    return [f"{command}: status {result.returncode}, not {expected}\n{result.stderr[-2000:]}"]


def make_folder(folder, host_sim, source, shared):
    (folder / "bin").mkdir()
    (folder / "bin/host_sim").symlink_to(host_sim)
    (folder / "host_sim").symlink_to(pathlib.Path(source) / "host_sim")
    if (pathlib.Path(shared) / MEASUREMENTS).exists():
        (folder / pathlib.Path(MEASUREMENTS).name).symlink_to(pathlib.Path(shared) / MEASUREMENTS)
    os.chdir(folder)
    # A folder of profiles with their model.
    (folder / "logs").mkdir()
    (folder / "logs/upper_arm.csv").symlink_to(folder / "host_sim/examples/upper_arm.csv")
    (folder / "logs/model.toml").symlink_to(folder / "host_sim/examples/upper_arm.toml")
    # The log that the examples of monitor read.
    subprocess.run([host_sim, "replay", "host_sim/examples/upper_arm.csv", "--model",
                    "host_sim/examples/upper_arm.toml", "--can", "run.log"], check=True,
                   capture_output=True)
    # A folder of records, of which fleet reads the tendons.
    (folder / "records").mkdir()
    (folder / "records/run.log").symlink_to(folder / "run.log")


def failures_of(examples, host_sim, source, shared):
    """Of the examples of one verb, which may use what those before them wrote."""
    with tempfile.TemporaryDirectory() as name:
        make_folder(pathlib.Path(name), host_sim, source, shared)
        failures = [failure for example in examples for failure in run(example)]
        os.chdir("/")
    return failures


def main():
    host_sim, source, shared = sys.argv[1:]
    failures = []
    count = 0
    for verbs, text in all_verbs(host_sim):
        examples = examples_of(text)
        name = " ".join(("host_sim", *verbs))
        if not any(f"{name} " in f"{example} " for example in examples):
            failures.append(f"{name} --help has no example of itself: {examples}")
        failures += failures_of(examples, host_sim, source, shared)
        count += len(examples)
    print("\n".join(failures) or f"{count} examples ran")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
