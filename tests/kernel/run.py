#!/usr/bin/env python3
"""Runs test modules of this folder on a kernel that has CAN and simulated lines.

    run.py [--where auto|uml|host] [--kernel LINUX] [--set NAME=VALUE]... [--serial COMMAND]
           [--needs FILE]... [--timeout SECONDS] MODULE[.CLASS[.TEST]]...

uml   boots a User-Mode Linux kernel (toolchains/build_uml.sh) whose root is this machine's file
      system, read-only; what the tests write goes with the guest's memory.
host  runs here, in a network namespace of its own. Needs root, vcan, vxcan and gpio-sim loaded.
auto  host where it has what is needed, else uml.

--set goes into the environment of the tests. --serial starts a program which prints the path of a
pseudo terminal (as QEMU does for `-serial pty`); the tests find it in the guest as the device that
TENDONLIFE_SERIAL names.

Exit 0: all passed. 1: a test failed, or the kernel died or took too long. 2: usage. 77: there is no
kernel to run on, or a program or a file of --needs is missing; with TENDONLIFE_REQUIRE_KERNEL=1 in
the environment that is a failure.
"""

import argparse
import contextlib
import os
import pathlib
import re
import secrets
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
BUILD_KERNEL = HERE.parents[1] / "toolchains" / "build_uml.sh"
CONFIGFS = pathlib.Path("/sys/kernel/config/gpio-sim")
PROGRAMS = ("candump", "cansend", "cangen", "cangw", "isotpsend", "slcand", "gpiomon", "ip", "tc", "node",
            "openssl", "stdbuf")
SKIPPED = 77
REQUIRE = "TENDONLIFE_REQUIRE_KERNEL"
GUEST_SERIAL = "/dev/ttyS1"

INIT = """#!/bin/sh
export HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb
mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t configfs configfs /sys/kernel/config
mount -t devtmpfs devtmpfs /dev
mkdir -p /dev/pts /dev/shm
mount -t devpts devpts /dev/pts
mount -t tmpfs tmpfs /dev/shm
mount -t tmpfs tmpfs {scratch}
ip link set lo up
cd {scratch}
{exports}
exec {command}
"""


def say(text):
    print(f"run.py: {text}", file=sys.stderr, flush=True)


def command_of_tests(modules):
    return [sys.executable, "-m", "unittest", "-v", "--", *modules]


def environment_of_tests(settings, scratch):
    if REQUIRE in os.environ:
        settings = {**settings, REQUIRE: os.environ[REQUIRE]}
    path = os.pathsep.join([str(HERE), *filter(None, [os.environ.get("PYTHONPATH")])])
    return {
        **settings,
        "PYTHONPATH": path,
        "PYTHONDONTWRITEBYTECODE": "1",
        "PYTHONUNBUFFERED": "1",
        "TMPDIR": str(scratch),
    }


def host_lacks():
    """What this machine lacks to run the tests itself; nothing if it lacks nothing."""
    if os.geteuid() != 0:
        return "root"
    if not CONFIGFS.is_dir():
        return f"{CONFIGFS} (modprobe gpio-sim, and configfs mounted)"
    probe = "ip link add type vcan && ip link add type vxcan"
    try:
        done = subprocess.run(["unshare", "--net", "sh", "-c", probe], capture_output=True, check=False)
    except FileNotFoundError:
        return "unshare"
    return None if done.returncode == 0 else "vcan or vxcan (modprobe vcan vxcan)"


def kernel_path(given):
    if given:
        return pathlib.Path(given)
    told = subprocess.run([BUILD_KERNEL, "--path"], capture_output=True, text=True, check=False)
    if told.returncode != 0:
        say(told.stderr.strip())
        return None
    return pathlib.Path(told.stdout.strip())


def missing(files):
    """The first thing that no test does without and that is not there."""
    for program in PROGRAMS:
        if not shutil.which(program, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin"):
            return f"the program {program} is missing (toolchains/setup.sh all installs it)"
    return next((f"{file} is missing" for file in files if not os.path.exists(file)), None)


def cannot_run(reason):
    if os.environ.get(REQUIRE) == "1":
        say(f"CANNOT RUN: {reason}")
        return 1
    say(f"SKIPPED, NOTHING WAS TESTED: {reason}")
    return SKIPPED


def end_group(process):
    """Ends a process that leads a group, and the group with it."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


@contextlib.contextmanager
def serial_device(command, folder):
    """Runs `command` and gives the pseudo terminal whose path it prints."""
    if not command:
        yield None
        return
    log = folder / "serial.log"
    with log.open("wb") as out:
        process = subprocess.Popen(
            shlex.split(command), stdin=subprocess.DEVNULL, stdout=out, stderr=out,
            start_new_session=True, env={**os.environ, "TMPDIR": str(folder)},
        )
    try:
        for _ in range(200):
            if found := re.search(r"/dev/pts/\d+", log.read_text(errors="replace")):
                yield found.group()
                break
            if process.poll() is not None:
                raise SystemExit(f"run.py: {command}: ended: {log.read_text(errors='replace')}")
            time.sleep(0.05)
        else:
            raise SystemExit(f"run.py: {command}: names no pseudo terminal within 10 s")
    finally:
        end_group(process)


def run_on_host(modules, settings, serial, timeout, folder):
    if serial:
        settings = {**settings, "TENDONLIFE_SERIAL": serial}
    environment = {**os.environ, **environment_of_tests(settings, folder)}
    command = ["unshare", "--net", *command_of_tests(modules)]
    process = subprocess.Popen(command, cwd=folder, env=environment, start_new_session=True)
    try:
        return 1 if process.wait(timeout) else 0
    except subprocess.TimeoutExpired:
        say(f"no end after {timeout} s")
        return 1
    finally:
        end_group(process)


def console_lines(process, deadline):
    """The lines of the guest's console until it halts; TimeoutError past the deadline."""

    def too_late(_signal, _frame):
        raise TimeoutError

    signal.signal(signal.SIGALRM, too_late)
    signal.setitimer(signal.ITIMER_REAL, deadline)
    try:
        for line in process.stdout:
            yield line.decode(errors="replace").rstrip("\r\n")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


def run_in_guest(kernel, modules, settings, serial, timeout, folder):
    scratch = folder / "scratch"
    scratch.mkdir()
    marker = f"exit-{secrets.token_hex(8)}"
    if serial:
        settings = {**settings, "TENDONLIFE_SERIAL": GUEST_SERIAL}
    exports = "\n".join(
        f"export {name}={shlex.quote(value)}"
        for name, value in environment_of_tests(settings, scratch).items()
    )
    seed = folder / "seed"
    seed.write_bytes(secrets.token_bytes(64))
    guest = [sys.executable, str(HERE / "guest.py"), str(seed), marker, *command_of_tests(modules)]
    init = folder / "init"
    init.write_text(INIT.format(
        scratch=shlex.quote(str(scratch)), exports=exports, command=shlex.join(guest),
    ))
    init.chmod(0o755)
    arguments = [
        str(kernel), "mem=512M", "rootfstype=hostfs", "rootflags=/", "ro", "quiet",
        f"init={init}", f"uml_dir={folder}/", "con=null", "con0=fd:0,fd:1",
    ]
    if serial:
        arguments.append(f"ssl1=tty:{serial}")
    process = subprocess.Popen(
        arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    code = None
    try:
        for line in console_lines(process, timeout):
            if line.startswith(marker):
                code = int(line.split()[1])
                break
            print(line, flush=True)
    except TimeoutError:
        say(f"no end after {timeout} s")
        return 1
    finally:
        end_group(process)
    if code is None:
        say("the guest ended before the tests did")
        return 1
    return 1 if code else 0


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--where", choices=["auto", "uml", "host"], default="auto")
    parser.add_argument("--kernel", metavar="LINUX")
    parser.add_argument("--set", metavar="NAME=VALUE", action="append", default=[])
    parser.add_argument("--serial", metavar="COMMAND")
    parser.add_argument("--needs", metavar="FILE", action="append", default=[])
    parser.add_argument("--timeout", metavar="SECONDS", type=float, default=240.0)
    parser.add_argument("modules", metavar="MODULE", nargs="+")
    options = parser.parse_args(arguments)
    if wrong := [item for item in options.set if "=" not in item]:
        parser.error(f"--set {wrong[0]}: accepted is NAME=VALUE")
    options.set = dict(item.split("=", 1) for item in options.set)
    return options


def main(arguments):
    options = parse(arguments)
    if reason := missing(options.needs):
        return cannot_run(reason)
    lacks = host_lacks() if options.where != "uml" else "not asked for"
    if options.where == "host" and lacks:
        return cannot_run(f"this machine lacks {lacks}")
    kernel = None
    if lacks:
        kernel = kernel_path(options.kernel)
        if kernel is None or not os.access(kernel, os.X_OK):
            return cannot_run(f"{kernel or 'the kernel'} is not there; toolchains/build_uml.sh builds it")
    folder = pathlib.Path(tempfile.mkdtemp(prefix="tendonlife-kernel-"))
    try:
        with serial_device(options.serial, folder) as serial:
            if kernel:
                return run_in_guest(kernel, options.modules, options.set, serial, options.timeout, folder)
            return run_on_host(options.modules, options.set, serial, options.timeout, folder)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    sys.exit(main(sys.argv[1:]))
