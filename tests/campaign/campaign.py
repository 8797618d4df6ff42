#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Attacks the built program for some minutes: scripts/campaign says how. A case is a part and a seed, and can be repeated."""
import argparse
import random
import sys
import tempfile
import time
import traceback
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.dont_write_bytecode = True
import files
import limits
import peers
from common import Case, Unexpected

PARTS = {"disks": files.full_disk, "kills": files.killed, "leftovers": files.killed_output, "determinism": files.determinism,
         "limits": limits.scarce, "encoders": limits.encoder, "drivers": limits.driver, "settings": limits.settings,
         "signals": limits.interrupted, "requests": peers.requests, "messages": peers.messages, "slow": peers.slow,
         "sessions": peers.sessions, "servers": peers.killed_server}
MOST = 5  # unexpected cases of a part, after which it ends


def attempt(options, part, seed):
    """Empty, or what was unexpected."""
    with tempfile.TemporaryDirectory(prefix="pabd-campaign-", ignore_cleanup_errors=True) as folder:
        case = Case(options.program, options.disk, random.Random(f"{part} {seed}"), folder)
        case.assets = Path(__file__).parents[2] / "assets"
        try:
            PARTS[part](case)
        except Unexpected as unexpected:
            return str(unexpected)
        except Exception:  # of the campaign itself
            return traceback.format_exc()
    return ""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--disk", required=True, help="the library that plays a full disk")
    parser.add_argument("--seconds", type=float, required=True)
    parser.add_argument("--seed", type=int, help="one case only")
    parser.add_argument("parts", nargs="*")
    options = parser.parse_args()
    parts = options.parts or list(PARTS)
    failed = 0
    for k, part in enumerate(parts):
        end = time.monotonic() + options.seconds / len(parts)
        seed, unexpected = options.seed or 0, 0
        while True:
            what = attempt(options, part, seed)
            if what:
                unexpected += 1
                print(f"{part} {seed}: {what}", flush=True)
            seed += 1
            if options.seed is not None or time.monotonic() >= end or unexpected >= MOST:
                break
        count = seed - (options.seed or 0)
        print(f"{part}: {count} case{'s' * (count != 1)}, {unexpected} unexpected", flush=True)
        failed += unexpected
    sys.exit(failed > 0)


main()
