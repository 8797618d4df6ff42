# SPDX-License-Identifier: MIT
"""What the tests share: the program, to compare with, and where the sources are."""
import os
import subprocess
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def source():
    return Path(os.environ["PABD_SOURCE_DIR"])


@pytest.fixture
def pabd_program(tmp_path):
    """Runs `pabd ARGUMENTS…` in a folder of its own."""

    def run(*arguments):
        environment = {k: v for k, v in os.environ.items() if k != "LD_PRELOAD"}
        return subprocess.run([os.environ["PABD_PROGRAM"], *arguments], cwd=tmp_path, env=environment,
                              capture_output=True, text=True, timeout=300)

    return run
