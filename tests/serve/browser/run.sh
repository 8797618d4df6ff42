#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The page of `pabd serve` in a real browser (Chromium): run.sh PROGRAM WORK [file.test.mjs …]. Its packages of npm
# are installed into the folder WORK, never into the source tree. Prints what failed.
#   units    keys, gestures, wheel and frames by themselves
#   page     the page against a server that only speaks the protocol
#   firefox  the same in Firefox, in short; left out where there is none
#   serve    the page against PROGRAM serve; left out without a PROGRAM ("-")
# Without a browser, node or npm: a line that says so, and status 77; CMake leaves the test out then.
set -euo pipefail
program=$1
work=$2
shift 2
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)

browser=${PABD_CHROMIUM:-$(command -v chromium || command -v chromium-browser || true)}
node=$(command -v node || command -v nodejs || true)
npm=$(command -v npm || true)
[ -n "$browser" ] || missing=chromium
[ -n "$node" ] || missing=node
[ -n "$npm" ] || missing=npm
if [ -n "${missing:-}" ]; then
  echo "browser: skipped, $missing is missing (scripts/setup --test installs it)"
  exit 77
fi

mkdir -p "$work"
if ! cmp -s "$here/package-lock.json" "$work/installed-lock.json"; then
  cp "$here/package.json" "$here/package-lock.json" "$work/"
  (cd "$work" && "$npm" ci --ignore-scripts --no-audit --no-fund --prefer-offline --loglevel=error) || {
    echo "browser: npm could not install the packages of $here/package-lock.json" >&2
    exit 1
  }
  cp "$here/package-lock.json" "$work/installed-lock.json"
fi
# The page's modules, where node takes them for modules.
rm -rf -- "$work/page"
mkdir "$work/page"
cp "$here"/../../../app/serve/page/*.js "$work/page/"
echo '{ "type": "module" }' > "$work/page/package.json"

firefox=${PABD_FIREFOX:-$(command -v firefox-esr || true)}
export PABD_FIREFOX=$firefox
export PABD_BROWSER_WORK=$work PABD_CHROMIUM=$browser
[ "$program" = - ] || export PABD_PROGRAM=$program
if [ $# -eq 0 ]; then set -- "$here"/*.test.mjs; fi
log=$work/log
if "$node" --test --test-reporter=spec "$@" > "$log" 2>&1; then
  grep -E '^ℹ (tests|skipped|duration_ms)' "$log" || true
  echo "browser: all as expected"
else
  cat "$log"
  exit 1
fi
