# SPDX-License-Identifier: MIT
"""What cannot be had ends a command with a line; encoders and drivers that misbehave; settings at their ends."""
import json
import math
import os
import resource
import signal
import time

from common import ends_within, require

NOBODY = 65534


def command(case):
    size = case.random.choice(["64x48", "640x360", "1920x1080"])
    return case.random.choice([
        ["run", case.scene(), "--time", "0.2", "--quiet", "--trace", "-"],
        ["render", case.scene(), "--time", "0.2", "--quiet", "--size", size, "-o", "a.png"],
        ["render", case.scene(), "--time", "0.2", "--quiet", "--size", size, "--fps", "10", "-o", "a.mp4"],
        ["plot", "barrier", "-o", "p.png"], ["doctor"], ["export", case.scene(), "--time", "0.2", "-o", "e.glb"]])


def scarce(case):
    """Memory, processes, descriptors, sizes of files: exit codes and a line, never a signal."""
    arguments = command(case)
    kind = case.random.choice(["memory", "processes", "descriptors", "file", "time"])
    options = {}
    if kind == "memory":
        options["limits"] = [(resource.RLIMIT_AS, case.random.randrange(100, 1200) << 20)]
    elif kind == "processes" and os.getuid() == 0:
        case.folder.chmod(0o777)
        options.update(limits=[(resource.RLIMIT_NPROC, case.random.randrange(1, 12))], user=NOBODY)
    elif kind == "file":
        options["limits"] = [(resource.RLIMIT_FSIZE, case.random.randrange(0, 20000))]
    elif kind == "descriptors":
        options["limits"] = [(resource.RLIMIT_NOFILE, case.random.randrange(4, 40))]
    else:
        options["limits"] = [(resource.RLIMIT_CORE, 0)]
    # 1: a driver of OpenGL that found no memory while it drew.
    case.run(arguments, codes={0, 1, 2, 3, 4, 6}, **options)
    case.require_no_temporaries(arguments)


ENCODERS = ["exit 0", "exit 1", "sleep 1000", "cat > /dev/null; sleep 1000", "yes error >&2", "kill -9 $$",
            "exec 0<&-; sleep 1000", "head -c 1000 > /dev/null", "sleep 1000 & cat > /dev/null", "yes", "echo a > \"$PWD/x.tmp\"; exit 3"]


def encoder(case):
    """Whatever ffmpeg does, the command ends with 3 or 6, and what it started ends with it."""
    fake = case.folder / "bin"
    fake.mkdir()
    behaviour = case.random.choice(ENCODERS)
    (fake / "ffmpeg").write_text(f"#!/bin/sh\necho $$ >> {case.folder}/pids\n{behaviour}\n")
    (fake / "ffmpeg").chmod(0o755)
    arguments = ["render", case.scene(), "--time", "0.3", "--quiet", "--size", "64x48", "--fps", "10",
                 "--encoder-timeout", "0.5", "-o", case.random.choice(["a.mp4", "a.webm", "a.gif"])]
    case.run(arguments, codes={3, 6}, environment={"PATH": f"{fake}:{os.environ['PATH']}"}, patience=30)
    pids = (case.folder / "pids").read_text().split() if (case.folder / "pids").exists() else []
    for _ in range(100):
        alive = [pid for pid in pids if os.path.exists(f"/proc/{pid}/exe")]
        if not alive:
            break
        time.sleep(0.02)
    require(not alive if pids else True, f"encoder '{behaviour}' goes on")


def driver(case):
    """Drivers that are not there, too old or crash: a picture, or exit code 4."""
    names = {"GALLIUM_DRIVER": ["bogus", "softpipe", "", "zink"], "MESA_GL_VERSION_OVERRIDE": ["1.1", "3.3", "9.9", "x"],
             "MESA_LOADER_DRIVER_OVERRIDE": ["bogus", "swrast"], "LIBGL_DRIVERS_PATH": ["/nowhere"],
             "__EGL_VENDOR_LIBRARY_FILENAMES": ["/nowhere.json", "/etc/passwd"], "EGL_PLATFORM": ["bogus", "x11", "surfaceless"],
             "LP_NATIVE_VECTOR_WIDTH": ["0", "64", "512", "x"], "MESA_GLSL_VERSION_OVERRIDE": ["110", "x"],
             "LD_LIBRARY_PATH": ["/nowhere"], "DISPLAY": [":99", ""], "LP_NUM_THREADS": ["0", "1", "999"]}
    chosen = case.random.sample(sorted(names), case.random.randrange(1, 4))
    environment = {name: case.random.choice(names[name]) for name in chosen}
    case.run(["render", "two_boxes", "--quiet", "--size", "64x48", "-o", "a.png",
              "--backend", case.random.choice(["auto", "egl", "osmesa"])], codes={0, 4}, environment=environment)


def ends_of(schema):
    """Key, least and largest value of every number of solver and contact, and whether it is whole."""
    for group in ("solver", "contact"):
        for key, value in schema["$defs"][group]["properties"].items():
            if value.get("type") in ("number", "integer"):
                low = value.get("minimum", value.get("exclusiveMinimum", 0))
                high = value.get("maximum", value.get("exclusiveMaximum", 1e6))
                yield f"{group}.{key}", low, high, value["type"] == "integer"


def settings(case):
    """Parameters at and beyond their ends: a run that ends, or a refusal that names the key."""
    schema = json.loads((case.assets / "pabd-scene.schema.json").read_text())
    params = sorted(ends_of(schema)) + [("time_step", 1e-6, 1, False)]
    require(len(params) > 10, f"the schema has only {params}")
    arguments = ["run", case.scene(), "--steps", "5", "--quiet", "--state", "s.json"]
    for key, low, high, whole in case.random.sample(params, case.random.randrange(1, 4)):
        value = case.random.choice([low, high, math.sqrt(abs(low * high)), low + 1e-12, high * (1 - 1e-12), 0, -1, 1e300, 5e-324])
        if key == "solver.iterations":
            value = min(value, 50)
        arguments += ["--set", f"{key}={int(value) if whole and abs(value) < 1e9 else value}"]
    code, _, _ = case.run(arguments, codes={0, 2, 3, 5}, patience=120)
    if code == 0:
        state = json.loads((case.folder / "s.json").read_text())
        require("nan" not in json.dumps(state).lower().replace('"name"', ""), f"not finite: {arguments}")


def interrupted(case):
    """SIGTERM and SIGINT end a command within 2 s, whole."""
    arguments = case.random.choice([["run", case.scene(), "--time", "1000", "--trace", "t.csv"],
                                    ["render", case.scene(), "--time", "1000", "--size", "64x48", "-o", "f{frame}.png"],
                                    ["render", case.scene(), "--time", "1000", "--size", "640x360", "-o", "a.mp4"]])
    process = case.start(arguments)
    time.sleep(case.random.uniform(0.05, 1))
    number = case.random.choice([signal.SIGTERM, signal.SIGINT, signal.SIGHUP])
    process.send_signal(number)
    ends_within(process, 5, f"{signal.Signals(number).name}: {arguments}")
    require(process.returncode in (128 + number, 0, -number), f"exit code {process.returncode} after {number}: {arguments}")
    case.require_no_temporaries(arguments)
