# SPDX-License-Identifier: MIT
"""What the parts of the campaign share: a case, how the program is started in it, and what is expected of every run."""
import os
import resource
import subprocess
import time
from pathlib import Path

SCENES = ["two_boxes", "pyramid", "drop", "pendulum", "bridge", "gears", "pile"]
EXIT_CODES = {0, 1, 2, 3, 4, 5, 6, 7, 75}  # app/cli/exit_code.h; 1 only where it is named


class Unexpected(Exception):
    """What a case found, in a line."""


def require(true, text):
    if not true:
        raise Unexpected(text)


class Case:
    """An empty folder, a source of random numbers, and the program."""

    def __init__(self, program, disk, random, folder):
        self.program, self.disk, self.random, self.folder = program, disk, random, Path(folder)

    def scene(self):
        return self.random.choice(SCENES)

    def start(self, arguments, limits=(), user=None, environment=None, **options):
        """A run in the folder; limits: pairs of resource.RLIMIT_… and a number."""
        def prepare():
            for limit, value in limits:
                resource.setrlimit(limit, (value, value))
            if user is not None:  # limits of processes count for others than root only
                os.setgid(user)
                os.setuid(user)
        settings = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        return subprocess.Popen([self.program, *map(str, arguments)], cwd=self.folder, preexec_fn=prepare,
                                env={**os.environ, **(environment or {})}, start_new_session=True,
                                **{**settings, **options})

    def run(self, arguments, codes=(0,), patience=60, **options):
        """Runs to the end: one of `codes`, one line of error with every code but 0, in time."""
        process = self.start(arguments, **options)
        try:
            out, err = process.communicate(timeout=patience)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.communicate()
            raise Unexpected(f"did not end within {patience} s: {arguments}") from None
        code, text = process.returncode, err.decode(errors="replace")
        require(code >= 0, f"signal {-code}: {arguments}: {text[-300:]}")
        require(code in codes, f"exit code {code}, expected one of {sorted(codes)}: {arguments}: {text[-300:]}")
        lines = [line for line in text.splitlines() if line.startswith("pabd: error: ")]
        require(code == 0 or code == 7 or code == 75 or len(lines) == 1,
                f"exit code {code} with {len(lines)} lines of error: {arguments}: {text[-300:]}")
        return code, out.decode(errors="replace"), text

    def names(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*") if not path.is_dir())

    def require_no_temporaries(self, arguments):
        left = [name for name in self.names() if ".tmp" in name or ".partial" in name]
        require(not left, f"left {left}: {arguments}")


def ends_within(process, seconds, what):
    """The seconds it took."""
    begin = time.monotonic()
    try:
        process.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        process.communicate()
        raise Unexpected(f"{what}: did not end within {seconds} s") from None
    return time.monotonic() - begin
