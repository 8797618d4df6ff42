# SPDX-License-Identifier: MIT
"""Full disks, kills with resumes, and runs that must be equal: what is left in a folder."""
import hashlib
import json
import os
import signal
import time

from common import require

OUTPUTS = [["run", "--trace", "t.csv", "--state", "s.json"], ["run", "--joints", "j.csv", "--iterations", "i.csv"],
           ["render", "--size", "64x48", "-o", "a.png"], ["render", "--size", "64x48", "--fps", "10", "-o", "f{frame}.png"],
           ["render", "--size", "64x48", "--fps", "10", "-o", "a.mp4"], ["render", "--size", "64x48", "--fps", "5", "-o", "a.gif"],
           ["export", "-o", "e.glb"], ["export", "-o", "e.npz"], ["export", "-o", "e.usda"], ["plot", "barrier", "-o", "p.svg"]]
PLAN = {"format": "pabd-sweep", "version": 1, "scene": "two_boxes", "stop": {"steps": 60},
        "parameters": [{"key": "contact.N", "values": [1, 2, 3]}, {"key": "contact.kappa", "values": [5, 50]}]}


def output(case):
    command, *rest = case.random.choice(OUTPUTS)
    scene = [] if command == "plot" else [case.scene(), "--quiet", "--time", case.random.choice([0.1, 0.3])]
    return [command, *(rest[:1] if command == "plot" else []), *scene, *(rest[1:] if command == "plot" else rest)]


def full_disk(case):
    """Nothing half under its name, what was there stays, and exit code 3 (6 where the encoder has no room)."""
    arguments = output(case)
    room = case.random.choice([0, 1, 100, 4096, case.random.randrange(100000)])
    environment = {"LD_PRELOAD": case.disk, "PABD_DISK_BYTES": str(room)}
    if case.random.random() < 0.2:
        environment["PABD_DISK_BROKEN"] = "1"
    there = arguments[-1].replace("{frame}", "0")
    kept = b"made by a person"
    (case.folder / there).write_bytes(kept)
    code, _, _ = case.run(arguments + ["--force"], codes={0, 2, 3, 6}, environment=environment)
    if code != 0 and (case.folder / there).exists() and "{frame}" not in arguments[-1]:
        require((case.folder / there).read_bytes() == kept or "--state" in arguments or "--iterations" in arguments,
                f"what was there is lost: {arguments}, room {room}")
    case.require_no_temporaries(arguments)


def digest(folder):
    out = {}
    for path in sorted(folder.glob("tasks/*/*")):
        if path.name not in ("timing.json", "end.png"):
            out[str(path.relative_to(folder))] = hashlib.sha256(path.read_bytes()).hexdigest()
    return out


def killed(case):
    """A sweep that is killed anywhere and run again has the same bytes as one that was not."""
    (case.folder / "plan.json").write_text(json.dumps(PLAN))
    case.run(["sweep", "plan.json", "-o", "whole", "--quiet"])
    for _ in range(case.random.randrange(1, 4)):
        process = case.start(["sweep", "plan.json", "-o", "broken", "--quiet"])
        time.sleep(case.random.uniform(0, 0.5))
        os.killpg(process.pid, signal.SIGKILL) if case.random.random() < 0.5 else process.kill()
        process.communicate()
    case.run(["sweep", "plan.json", "-o", "broken", "--quiet"])
    require(digest(case.folder / "whole") == digest(case.folder / "broken"), "a killed and resumed sweep differs")
    case.require_no_temporaries("sweep")


def killed_output(case):
    """The next run of an output removes what a killed one left."""
    arguments = output(case)
    for _ in range(2):
        process = case.start(arguments + ["--force"])
        time.sleep(case.random.uniform(0.02, 0.4))
        process.kill()
        process.communicate()
    case.run(arguments + ["--force"], codes={0, 2})
    case.require_no_temporaries(arguments)


def determinism(case):
    """The same bytes for every number of threads."""
    scene, steps = case.scene(), case.random.choice([20, 60])
    settings = ["--set", f"contact.N={case.random.choice([1, 2, 3, 8])}",
                "--set", f"solver.method={case.random.choice(['descent', 'newton', 'sissm', 'auto'])}",
                "--set", f"time_step={case.random.choice([1 / 30, 1 / 60, 1 / 240])}"]
    states = set()
    for threads in (1, 2, case.random.choice([3, 5, 8])):
        code, _, _ = case.run(["run", scene, "--steps", steps, "--quiet", "--force", "--threads", threads,
                               "--state", "s.json", *settings], codes={0, 2, 5})
        states.add((code, (case.folder / "s.json").read_bytes() if code == 0 else b""))
    require(len(states) == 1, f"threads differ: {scene} {settings}")
