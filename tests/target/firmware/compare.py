"""Plays every scenario on two builds of the firmware: each frame, the final lives and the flash must
agree byte for byte, and say what the scenario is there to bring about.

The recording is made by a live host against one more build of the same firmware, which has to agree
too. The last scenario continues with the flash of the one before.

usage: compare.py RECORD PROGRAM_A PROGRAM_B      the programs are called as PROGRAM SERIAL NAME=VALUE...
"""

import pathlib
import re
import subprocess
import sys
import tempfile

NODE = 5
KEY = "00112233445566778899aabbccddeeff"
CODES = {"emergency_stop": "01FF", "replace": "12FF", "worn": "13FF", "overload": "20FF",
         "sensor": "30FF", "deadline": "70FF"}


def frames(serial):
    """Lines of frames, without answers to the host."""
    return [line for line in re.split(r"[\r\a]", serial) if re.match(r"t[0-9A-F]{4}|T[0-9A-F]{9}", line)]


def require(holds, what):
    if not holds:
        sys.exit(what)


def messages(lines, base):
    return [line[5:] for line in lines if line.startswith(f"t{base + NODE:03X}")]


def check_every(name, lines, summary, duration_s):
    beats = messages(lines, 0x700)
    require(beats[0] == "00", f"{name}: the first heartbeat is not the boot-up message")
    require(abs(len(beats) - duration_s - 1) <= 1 or name == "gaps", f"{name}: {len(beats)} heartbeats")
    # Damage of the last status, little-endian behind CRC and counter, against the exact one.
    status = bytes.fromhex(messages(lines, 0x180)[-1])
    reported_ppb = int.from_bytes(status[2:6], "little")
    words = re.findall(r" damage ([0-9a-f]{32})", summary)
    exact_ppb = max((int(word, 16) * 10**9) >> 104 for word in words)
    require(reported_ppb <= min(exact_ppb, 2**32 - 1), f"{name}: reported {reported_ppb} ppb of {exact_ppb}")
    require(reported_ppb >= exact_ppb * 0.97 or reported_ppb == 2**32 - 1,
            f"{name}: reported only {reported_ppb} ppb of {exact_ppb}")
    return reported_ppb


def emergencies(lines):
    return {code for code, hexadecimal in CODES.items()
            if any(line.startswith(hexadecimal) for line in messages(lines, 0x080))}


def check_gaps(lines, serial, summary):
    require({"sensor", "emergency_stop", "deadline"} <= emergencies(lines), "gaps: an emergency is missing")
    require("drive 0 brake 1" in summary, "gaps: the drive is not held off")
    pages = [bytes.fromhex(line) for line in messages(lines, 0x280)]
    require(any(page[1] >> 4 == 8 and page[5] > 0 for page in pages), "gaps: no page was dropped")


def check_sine(lines, serial, summary):
    # Page 12 of both tendons: state limited or no_limit, and a tension below the ultimate one.
    pages = [bytes.fromhex(line) for line in messages(lines, 0x280) if line[2] == "C"]
    told = {page[2] & 31: (page[2] >> 5, page[3] | (page[4] & 15) << 8) for page in pages}
    require(sorted(told) == [0, 1], f"sine: advice for tendons {sorted(told)}")
    require(told[0][0] == 3 and told[1][0] == 2, f"sine: states of advice {told}")
    require(0 < told[0][1] < told[1][1] < 4000, f"sine: tensions of advice {told}")


def check_overload(lines, serial, summary):
    require({"replace", "worn", "overload"} <= emergencies(lines), "overload: an emergency is missing")


def check_commands(lines, serial, summary):
    require("V0001\r" in serial, "commands: the version was not reported")
    # No command, a line that is too long, and half a line that another one was added to.
    require(serial.count("\a") == 3, f"commands: {serial.count(chr(7))} refusals")
    require("F08\r" in serial, "commands: the lines that were too long are not reported")
    pages = "".join(line[2] for line in messages(lines, 0x280))
    require(re.search("[3-8]2", pages), f"commands: page 2 was not selected in {pages}")


def check_epoch(lines, serial, summary):
    answers = [line[10:] for line in lines if line.startswith(f"T18DAF1{NODE:02X}")]
    expected = ["037F1911",          # a service that there is not
                "037F3135",          # a wrong code
                "0471010201",        # epoch opened
                "0471010202",        # parameters loaded
                "037F3131",          # an effect that cannot be evaluated, a tendon that there is not
                "100B620260010" "50B",  # effect 11 of tendon 0, and behind it
                "0471010203"]        # the extended model loaded
    for text in expected:
        require(text in answers, f"epoch: no answer {text}")
    require("tendon 0 epoch 1" in summary and "tendon 1 epoch 0" in summary, "epoch: not opened")


def check_restart(lines, serial, summary):
    require("tendon 0 epoch 1" in summary, "restart: the epoch is forgotten")
    answers = [line[10:] for line in lines if line.startswith(f"T18DAF1{NODE:02X}")]
    require("100B620261020000" in answers, "restart: tendon 1 does not count with what was loaded")


CHECKS = {"sine": check_sine, "gaps": check_gaps, "overload": check_overload, "commands": check_commands,
          "epoch": check_epoch, "restart": check_restart}
DURATIONS_S = {"sine": 63, "noise": 15, "gaps": 20, "overload": 30, "commands": 12, "epoch": 40,
               "restart": 4}


def play(name, record, programs, folder, before):
    outcomes = []
    words = {"profile": folder / f"{name}.profile", "block": folder / "block",
             "events": folder / f"{name}.events", "key": KEY, "node": NODE, "seed": 7}
    for who, program in {"record": record, **programs}.items():
        base = folder / f"{name}.{who}"
        flash = base.with_suffix(base.suffix + ".flash")
        if before:
            flash.write_bytes(before[who])
        summary, serial = f"{base}.summary", f"{base}.serial"
        command = [record, name] if who == "record" else [program]
        subprocess.run([*command, serial,
                        *(f"{k}={v}" for k, v in {**words, "flash": flash, "summary": summary}.items())],
                       stdin=subprocess.DEVNULL, timeout=600, check=True)
        outcomes.append({"serial": pathlib.Path(serial).read_bytes(),
                         "summary": pathlib.Path(summary).read_bytes(), "flash": flash.read_bytes()})
    first = outcomes[0]
    for who, other in zip(programs, outcomes[1:]):
        for what in first:
            require(other[what] == first[what], f"{name}: {what} of {who} differs from the recording's")
    serial, summary = first["serial"].decode("ascii"), first["summary"].decode("ascii")
    lines = frames(serial)
    reported_ppb = check_every(name, lines, summary, DURATIONS_S[name])
    if name in CHECKS:
        CHECKS[name](lines, serial, summary)
    print(f"{name}: {len(lines)} frames, {len(serial)} bytes, lives and flash are identical; "
          f"damage {reported_ppb} ppb")
    return {who: outcome["flash"] for who, outcome in zip(["record", *programs], outcomes)}


def main():
    record, a, b = sys.argv[1:]
    names = subprocess.run([record, "--list"], stdout=subprocess.PIPE, text=True, check=True).stdout.split()
    require(sorted(names) == sorted(DURATIONS_S), f"scenarios: {names}")
    with tempfile.TemporaryDirectory() as folder:
        flash = None
        for name in names:
            flash = play(name, record, {"A": a, "B": b}, pathlib.Path(folder),
                         flash if name == "restart" else None)


main()
