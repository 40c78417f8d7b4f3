"""Holds what the verbs write as JSON against the schemas that host_sim gives away, and runs the recipe of
the page of host_sim that reads them.

    schema_test.py HOST_SIM SOURCE
"""
import copy
import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not there")
    sys.exit(1 if os.environ.get("CI") == "true" else 77)

PATIENCE_S = 30
# Of the log of a replay only the end is kept.
SMALL_RECORD = "--record-rotate 16K --record-keep 1"
VERBS = ("calibrate", "compare", "design", "diagnose", "fleet", "fmeca", "monitor", "plan", "replay")
MODEL = "--model examples/upper_arm.toml"
ARM = f"examples/upper_arm.csv {MODEL}"
LAW = "--levels 42.5,55,71 --use-tension 38 --simulations 100"

# A drive of two directions, whose campaign is diagnosed in newtons.
TWO_SIDED = """schema = 1
[campaign]
name = "both ways"
two_sided = true
[model.cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[model.sheath]
friction_coefficient = 0.1
bend_angle_deg = 180.0
[recordings]
design = "balanced"
sessions = 8
bend_angles_deg = [90.0, 180.0]
output_means_N = 0.0
output_amplitudes_N = [20.0, 40.0]
frequencies_Hz = [0.5, 1.0]
travels_mm = 40.0
load_frequency_ratio = 1.3
sample_rate_Hz = 100.0
duration_s = 6.0
[noise]
log_tension_sd = 0.01
[effects.friction_preload]
force_N = 6.0
"""

# A level with lives between inspections, and one with too few failures for a fit.
FEW = "".join(f"w{k},A,25,25,{900 + 40 * k},failed,\n" for k in range(8)) + (
    "x1,A,25,25,1000,interval,900\ny1,A,35,35,700,failed,\ny2,A,35,35,900,suspended,\n")

# What only an emergency stop, and a campaign that nothing explains, bring.
RARE = {"emergency", "correction", "knots"}

# Files that the others read.
PREPARED = (
    "synth --plan examples/synth/lives.toml --out lives",
    "synth --plan plan.toml --out both",
    "synth --plan two_sided.toml --out two_sided",
    "calibrate examples/tendon_alt --bootstraps 50 --out sure.toml",
    "diagnose examples/recorded --out extended.toml",
    f"replay {ARM} --can run.log",
)

# Each is followed by --json -; together they write every member that a schema has.
RUNS = (
    f"replay {ARM}",
    f"replay {ARM} --used 0.5 --horizon 5",
    "replay examples/upper_arm.csv --model sure.toml --used 0.5 --horizon 8h",
    f"replay {ARM} --until-date 2027-06-30 --today 2026-11-22 --hours-per-day 0.005",
    f"replay {ARM} --can again.log",
    "replay examples/upper_arm.csv --model extended.toml",
    "replay examples/upper_arm.csv --model current.toml",
    "replay slack.csv --model examples/upper_arm.toml",
    "replay constant.csv --model examples/upper_arm.toml",
    f"replay examples/upper_arm.csv bad.csv {MODEL}",
    "compare examples/upper_arm.toml current.toml --profile examples/upper_arm.csv",
    f"compare examples/upper_arm.csv slack.csv {MODEL}",
    f"compare examples/upper_arm.csv examples/upper_arm.csv {MODEL}",
    "calibrate examples/tendon_alt --bootstraps 50 --use-tension 30",
    "calibrate lives --bootstraps 50",
    "calibrate few --bootstraps 50",
    "calibrate many --bootstraps 50 --batch --table many.csv",
    f"plan {MODEL} {LAW} --ratio 2",
    f"plan {MODEL} {LAW} --ratio 1.01 --specimens-max 20",
    f"plan {MODEL} {LAW} --specimens 3,0,3 --cycles-per-minute 60 --suspend-at 1500",
    "plan --for-diagnosis plan.toml",
    "diagnose examples/recorded --out again.toml",
    "diagnose both",
    "diagnose lives",
    "diagnose two_sided",
    "diagnose spoilt",
    f"fleet examples/fleet/tendons.csv {MODEL}",
    f"fleet examples/fleet/tendons.csv {MODEL} --cost-replacement 50 --cost-break 900 --horizon 2000h",
    "fmeca",
    "fmeca examples/fmeca/soft_robot.toml --field examples/fmeca/field.csv",
    f"design {MODEL} --tension 49",
    f"design {MODEL} --life 1000 --cycles-per-minute 10 --test-tension 60",
    f"design {MODEL} --tension 30 --life 1000 --find safety",
    "design --model sure.toml --tension 49 --tension-min 10",
)


class Program:
    def __init__(self, host_sim):
        self.host_sim = host_sim
        self.schemas = {verb: json.loads(self.output(f"schema {verb}")) for verb in VERBS}
        for schema in self.schemas.values():
            jsonschema.Draft202012Validator.check_schema(schema)

    def run(self, words):
        return subprocess.run([self.host_sim, *words.split()], capture_output=True, text=True, check=False,
                              stdin=subprocess.DEVNULL)

    def output(self, words):
        done = self.run(words)
        # A table of which one profile or campaign is refused has status 1.
        if done.returncode != 0 and not done.stdout.startswith("{"):
            sys.exit(f"host_sim {words}: status {done.returncode}\n{done.stderr}")
        return done.stdout

    def validator(self, verb):
        return jsonschema.Draft202012Validator(self.schemas[verb], format_checker=jsonschema.FormatChecker())


def leaves_of(schema, path=""):
    """The members that a schema has anywhere, by their definition."""
    if isinstance(schema, dict):
        for name, member in schema.get("properties", {}).items():
            yield f"{path}/{name}", member
        for key, part in schema.items():
            if key == "properties":
                for name, member in part.items():
                    yield from leaves_of(member, f"{path}/{name}")
            elif key == "$defs":
                for name, member in part.items():
                    yield from leaves_of(member, f"/{name}")
            else:
                yield from leaves_of(part, path)
    elif isinstance(schema, list):
        for part in schema:
            yield from leaves_of(part, path)


def errors_of(validator, result):
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}"
            + "".join(f"\n    {'/'.join(map(str, cause.absolute_path))}: {cause.message[:200]}"
                      for cause in error.context[:8])
            for error in validator.iter_errors(result)]


def accepted_faults(validator, result):
    """A member that is missing, one more, and one of another type: each has to be an error."""
    for name, value in result.items():
        faulty = copy.deepcopy(result)
        faulty[name] = {"of": "another type"} if not isinstance(value, dict) else "of another type"
        if validator.is_valid(faulty):
            yield f"{name} of another type"
    for change in ("one more", "one less"):
        faulty = copy.deepcopy(result)
        if change == "one more":
            faulty["not_in_the_schema"] = 1
        else:
            faulty.pop(next(iter(result)))
        if validator.is_valid(faulty):
            yield f"a member {change}"


def names_in(result):
    if isinstance(result, dict):
        for name, value in result.items():
            yield name
            yield from names_in(value)
    elif isinstance(result, list):
        for value in result:
            yield from names_in(value)


def fetched(url):
    """None where the page has nothing to show yet."""
    try:
        with urllib.request.urlopen(url) as answer:
            return json.load(answer)
    except urllib.error.HTTPError as error:
        if error.code != 503:
            raise
        return None


def live_views(program):
    """What the live page of a log gives at its end: the fleet, one node, and moments of a past whose oldest frames
    are gone."""
    words = f"monitor --log run.log --replay-speed 1000 --http 127.0.0.1:0 --record record {SMALL_RECORD}"
    process = subprocess.Popen([program.host_sim, *words.split()], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL,
                               text=True)
    try:
        url = process.stderr.readline().split()[-1]
        deadline = time.monotonic() + PATIENCE_S
        while not ((fleet := fetched(url + "api/fleet")) and fleet["source_ended"]) and time.monotonic() < deadline:
            time.sleep(0.05)
        times = fetched(url + "api/times")
        moments = [f"api/moment/{times['times_us'][0]}", f"api/moment/{fleet['now_us']}",
                   f"api/moment/{fleet['now_us']}/1"]
        return [("monitor /api/fleet", fleet), ("monitor /api/times", times)] + [
            (f"monitor /{path}", fetched(url + path)) for path in ("api/node/1", *moments)]
    finally:
        process.terminate()
        process.wait(PATIENCE_S)
        process.stderr.close()


def reverse_velocity(recording):
    with recording.open(newline="") as file:
        rows = list(csv.DictReader(file))
    with recording.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows({**row, "tendon_velocity_m_s": -float(row["tendon_velocity_m_s"])} for row in rows)


def write_files(program, examples):
    pathlib.Path("examples").symlink_to(examples)
    pathlib.Path("slack.csv").write_text(
        "time_s,output_tension_N,tendon_velocity_m_s\n"
        + "".join(f"{k / 200},{20 if k < 100 else 0},{0.05 if k % 100 < 90 else -0.05}\n" for k in range(400)))
    pathlib.Path("constant.csv").write_text("time_s,input_tension_N\n0,10\n0.005,10\n0.01,10\n")
    pathlib.Path("bad.csv").write_text("time_s,input_tension_N\n0,ten\n")
    pathlib.Path("current.toml").write_text(pathlib.Path("examples/upper_arm.toml").read_text()
                                            + "[extension.current_offset]\ncurrent_offset_A = 0.1\n")
    pathlib.Path("two_sided.toml").write_text(TWO_SIDED)
    shutil.copytree("examples/recorded", "spoilt")
    for recording in pathlib.Path("spoilt/recordings").iterdir():
        reverse_velocity(recording)
    program.output("init plan")
    for name in ("few", "many/few", "many/bad"):
        folder = pathlib.Path(name)
        folder.mkdir(parents=True)
        program.output(f"init campaign --out {name}/campaign.toml")
        (folder / "specimens.csv").write_text(
            "specimen,lot,input_tension_mean_N,input_tension_amplitude_N,cycles,status,cycles_from\n"
            + ("" if name.endswith("bad") else FEW))
    for words in PREPARED:
        program.output(words)


def recipe_failures(program, source):
    """The recipe of the page prints what the page says."""
    page = (pathlib.Path(source) / "host_sim/README.md").read_text(encoding="utf-8")
    match = re.search(r"```python\n(.*?)```\n\n```\n(.*?)```", page, re.DOTALL)
    pathlib.Path("bin").mkdir()
    pathlib.Path("bin/host_sim").symlink_to(program.host_sim)
    pathlib.Path("host_sim").symlink_to(pathlib.Path(source) / "host_sim")
    environment = {**os.environ, "PATH": f"{os.getcwd()}/bin:{os.environ['PATH']}"}
    done = subprocess.run([sys.executable, "-c", match[1]], env=environment, capture_output=True, text=True, check=False)
    return [] if done.stdout == match[2] else [f"the recipe: {done.stdout}{done.stderr}\nnot: {match[2]}"]


def main():
    program = Program(pathlib.Path(sys.argv[1]).resolve())
    source = pathlib.Path(sys.argv[2]).resolve()
    failures = []
    seen = {verb: set() for verb in VERBS}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_files(program, source / "host_sim/examples")
        results = [(words, json.loads(program.output(f"{words} --json -"))) for words in RUNS] + live_views(program)
        for words, result in results:
            verb = words.split()[0]
            validator = program.validator(verb)
            failures += [f"host_sim {words}: {error}" for error in errors_of(validator, result)]
            failures += [f"host_sim {words}: {fault} is accepted" for fault in accepted_faults(validator, result)]
            seen[verb] |= set(names_in(result))
        failures += recipe_failures(program, source)
        os.chdir("/")
    never = [f"{verb}{path}" for verb in VERBS for path, _ in leaves_of(program.schemas[verb])
             if path.rsplit("/", 1)[1] not in seen[verb] | RARE and "mqtt_status" not in path]
    failures += [f"no run writes {', '.join(sorted(set(never)))}"] if never else []
    print("\n".join(failures) or f"{len(results)} results of {len(VERBS)} verbs are as their schemas say")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
