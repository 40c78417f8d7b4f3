"""Types at a shell that has the completion of host_sim, on a terminal, and looks at what it runs.

    shells_test.py SHELL HOST_SIM
"""
import os
import pathlib
import pty
import select
import shutil
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
PATIENCE_S = 20

# What is typed after `host_sim `, with a tab where the shell is asked, and the words that run.
CASES = [
    ("rep\t", ["replay"]),
    ("import dav\t", ["import", "davinci"]),
    ("calibrate --keep\t", ["calibrate", "--keep-all-levels"]),
    ("replay --input mot\t", ["replay", "--input", "motor_current"]),
    ("replay --fail-on satur\t", ["replay", "--fail-on", "saturated"]),
    ("replay --fail-on gap,overl\t", ["replay", "--fail-on", "gap,overload"]),
    ("replay --model upp\t", ["replay", "--model", "upper.toml"]),
    ("replay --model=upp\t", ["replay", "--model=upper.toml"]),
    ("replay --input=mot\t", ["replay", "--input=motor_current"]),
    ("replay prof\t", ["replay", "profile one.csv"]),
    ("replay --node 1 --model upp\tprof\t", ["replay", "--node", "1", "--model", "upper.toml", "profile one.csv"]),
    ("replay upper.toml prof\t", ["replay", "upper.toml", "profile one.csv"]),
    ("replay --node upp\t", ["replay", "--node", "upp"]),
    ("pack upper.toml --format b\t", ["pack", "upper.toml", "--format", "bin"]),
    ("diagnose cam\t", ["diagnose", "campaign"]),
    ("synth --out cam\t", ["synth", "--out", "campaign"]),
    ("import davinci prof\t", ["import", "davinci", "profile one.csv"]),
    ("import --out\t", ["import", "--out"]),
    ("monitor --interface c\t", ["monitor", "--interface", "can0"]),
    ("completion f\t", ["completion", "fish"]),
    ("init cont\t", ["init", "controller"]),
    ("schema fle\t", ["schema", "fleet"]),
    ("help mon\t", ["help", "monitor"]),
    ("plan --for-diagnosis upp\t", ["plan", "--for-diagnosis", "upper.toml"]),
]

START = {
    "bash": (["bash", "--norc", "--noprofile", "-i"], "source '{folder}/host_sim.bash'\n"),
    "zsh": (["zsh", "-f", "-i"],
            "fpath=('{folder}' $fpath); autoload -U compinit; compinit -u -D\n"),
    "fish": (["fish", "--no-config", "-i"], "source '{folder}/host_sim.fish'\n"),
}
FILES = {"bash": "host_sim.bash", "zsh": "_host_sim", "fish": "host_sim.fish"}

STUB = """#!/bin/sh
printf '%s\\0' "$@" > "$RAN.part" && mv "$RAN.part" "$RAN"
"""


def make_folder(folder, shell, host_sim):
    """The script, where it looks for interfaces in a folder of ours, files, and a host_sim to run."""
    script = subprocess.run([host_sim, "completion", shell], check=True, capture_output=True,
                            text=True).stdout
    (folder / FILES[shell]).write_text(script.replace("/sys/class/net", f"{folder}/net"))
    for name, kind in {"can0": 280, "cable0": 1, "lo": 772}.items():
        (folder / "net" / name).mkdir(parents=True)
        (folder / "net" / name / "type").write_text(f"{kind}\n")
    (folder / "bin").mkdir()
    (folder / "bin/host_sim").write_text(STUB)
    (folder / "bin/host_sim").chmod(0o755)
    work = folder / "work"
    (work / "campaign").mkdir(parents=True)
    for name in ("camera.txt", "upper.toml", "profile one.csv"):
        (work / name).write_text("")
    return work


class Shell:
    def __init__(self, folder, shell, work):
        command, setup = START[shell]
        self.ran = folder / "ran"
        environment = {
            "PATH": f"{folder}/bin:{os.environ['PATH']}", "HOME": str(folder), "TERM": "xterm",
            "LANG": "C.UTF-8", "RAN": str(self.ran), "XDG_DATA_HOME": str(folder / "data"),
            "XDG_CONFIG_HOME": str(folder / "config"), "XDG_RUNTIME_DIR": str(folder),
        }
        self.seen = b""
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.chdir(work)
            os.execvpe(command[0], command, environment)
        self.type(setup.format(folder=folder))
        self.run("--version\n")

    def type(self, keys):
        os.write(self.terminal, keys.encode())

    def listen(self):
        if select.select([self.terminal], [], [], 0.02)[0]:
            self.seen += os.read(self.terminal, 65536)

    def run(self, keys):
        """The words that host_sim was run with, or None."""
        self.ran.unlink(missing_ok=True)
        self.type("host_sim " + keys)
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            self.listen()
            if self.ran.exists():
                return self.ran.read_bytes().decode().split("\0")[:-1]
        return None

    def close(self):
        os.close(self.terminal)
        os.waitpid(self.pid, 0)


def failures_of(shell, folder, work):
    session = Shell(folder, shell, work)
    failures = []
    for keys, expected in CASES:
        words = session.run(keys + "\n")
        # A shell may leave the slash after a folder.
        if words is None or [word.removesuffix("/") for word in words] != expected:
            failures.append(f"host_sim {keys!r}: {words}, not {expected}")
            if words is None:
                failures.append(session.seen[-2000:].decode(errors="replace"))
                break
    session.close()
    return failures


def main():
    shell, host_sim = sys.argv[1:]
    if shutil.which(shell) is None:
        print(f"{shell} is not installed")
        return 1 if os.environ.get("CI") == "true" else SKIPPED
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        failures = failures_of(shell, folder, make_folder(folder, shell, host_sim))
    print("\n".join(failures) or f"{shell}: {len(CASES)} command lines completed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
