"""Instructions of the application's calls while recordings are played on the board: on average with
the sine, of settle() for each sample, and at worst over all.

usage: measure.py OUT.json RECORD EMULATOR... IMAGE
"""

import json
import pathlib
import subprocess
import sys
import tempfile

out, record, *emulator = sys.argv[1:]
NODE, KEY, SEED = 5, "00112233445566778899aabbccddeeff", 7


def play(name, folder):
    words = {"profile": folder / "profile", "block": folder / "block", "events": folder / "events",
             "node": NODE, "key": KEY, "seed": SEED}
    text = [f"{k}={v}" for k, v in words.items()]
    subprocess.run([record, name, folder / "serial", *text], stdin=subprocess.DEVNULL, check=True)
    counts = folder / "counts.json"
    subprocess.run([*emulator, "-append", " ".join([*text, f"summary={counts}"])],
                   stdin=subprocess.DEVNULL, check=True)
    return json.loads(counts.read_text())


with tempfile.TemporaryDirectory() as folder:
    names = subprocess.run([record, "--list"], stdout=subprocess.PIPE, text=True,
                           check=True).stdout.split()
    runs = {name: play(name, pathlib.Path(folder)) for name in names}
measured = {}
for call in ("isr_sample", "settle", "poll"):
    times, total, _ = runs["sine"][call]
    if call == "settle":
        times = runs["sine"]["isr_sample"][0]
    measured[f"{call}_sine"] = round(total / times, 1)
    worst = {name: counts[call][2] for name, counts in runs.items()}
    measured[f"{call}_worst"] = max(worst.values())
    print(f"{call}: {measured[f'{call}_sine']} on average, at worst", worst)
pathlib.Path(out).write_text(json.dumps(measured, indent=2) + "\n")
