#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The window on a real display (Xvfb) with real keys and a real mouse: real_window.sh PROGRAM. Prints what failed.
# Nothing waits for a time: the program says what state it is in ("print" in its script), and only then comes the
# next event. A limit of minutes is there for what never happens.
#   keys and mouse reach the simulation · ctrl+q leaves with 0 · SIGINT leaves with 130 · a display that dies leaves
#   with 4 and one line · no display leaves with 4 and says what helps
set -euo pipefail
program=$1
folder=$(mktemp -d)
server=
trap 'if [ -n "$server" ]; then kill "$server" 2> /dev/null || true; fi; rm -rf -- "$folder"' EXIT
unset WAYLAND_DISPLAY XDG_SESSION_TYPE
export XDG_CONFIG_HOME=$folder/config XDG_CACHE_HOME=$folder/cache
failures=0

fail() {
  echo "real_window: $*" >&2
  failures=$((failures + 1))
}

# wait_until WHAT PID COMMAND…: until the command succeeds, five minutes at most, while the process lives.
wait_until() {
  local what=$1 process=$2
  shift 2
  for _ in $(seq 6000); do
    if "$@" 2> /dev/null; then return; fi
    kill -0 "$process" 2> /dev/null || break
    sleep 0.05
  done
  fail "$what: waited in vain: $(tail -n 3 "$folder/log")"
  exit 1
}

start_display() {
  : > "$folder/log"
  Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp 3> "$folder/display" 2> /dev/null &
  server=$!
  wait_until "a display" "$server" test -s "$folder/display"
  DISPLAY=:$(cat "$folder/display")
  export DISPLAY
}

# says LINE [TIMES]: waits until the program printed it (so often).
says() {
  wait_until "$1" "$pid" bash -c '[ "$(grep -cxF -- "$1" "$2")" -ge "$3" ]' _ "$1" "$folder/log" "${2:-1}"
}

# Gives the window the keyboard. It is there when the program has said something.
focus() {
  local window
  window=$(timeout 300 xdotool search --sync --onlyvisible --name pabd | head -n 1)
  timeout 300 xdotool windowfocus --sync "$window"
}

# expect_exit CODE WHAT PID
expect_exit() {
  local code=0
  wait "$3" || code=$?
  [ "$code" -eq "$1" ] || fail "$2: exit code $code instead of $1: $(tail -n 3 "$folder/log")"
}

start_display

# Every "until" waits for something that only the real keyboard or mouse brings about.
cat > "$folder/actions.json" << 'ACTIONS'
[ {"do": "print", "at": "/playing"},
  {"do": "until", "at": "/playing", "is": true, "seconds": 300},
  {"do": "until", "at": "/a/step", "above": 5, "seconds": 300},
  {"do": "print", "at": "/playing"},
  {"do": "until", "at": "/playing", "is": false, "seconds": 300},
  {"do": "print", "at": "/playing"},
  {"do": "until", "at": "/ui/help", "is": true, "seconds": 300},
  {"do": "print", "at": "/ui/help"},
  {"do": "until", "at": "/ui/help", "is": false, "seconds": 300},
  {"do": "print", "at": "/ui/help"},
  {"do": "expect", "at": "/a/report/contacts", "above": 0},
  {"do": "print", "at": "/scene/name"} ]
ACTIONS
"$program" view two_boxes --size 1280x720 --scale 1 --script "$folder/actions.json" > "$folder/log" 2>&1 &
pid=$!
says "/playing false"
focus
xdotool key space
says "/playing true"
xdotool mousemove 88 665 click 1 # the button for play and pause
says "/playing false" 2
xdotool key F1
says "/ui/help true"
xdotool key Escape
says '/scene/name "two boxes"'
xdotool key ctrl+q
expect_exit 0 "keys and mouse, ctrl+q" "$pid"

# Plays on when the script is at its end.
cat > "$folder/playing.json" << 'ACTIONS'
[ {"do": "play"}, {"do": "until", "at": "/a/step", "above": 2, "seconds": 300}, {"do": "print", "at": "/playing"} ]
ACTIONS
"$program" view two_boxes --script "$folder/playing.json" > "$folder/log" 2>&1 &
pid=$!
says "/playing true"
kill -INT "$pid"
expect_exit 130 "SIGINT" "$pid"

"$program" view two_boxes --script "$folder/playing.json" > "$folder/log" 2>&1 &
pid=$!
says "/playing true"
kill "$server"
wait "$server" 2> /dev/null || true
server=
expect_exit 4 "a display that dies" "$pid"
grep -q "display was lost" "$folder/log" || fail "a display that dies: $(cat "$folder/log")"

code=0
env -u DISPLAY "$program" view two_boxes > "$folder/log" 2>&1 || code=$?
[ "$code" -eq 4 ] || fail "no display: exit code $code instead of 4"
grep -q -- "--headless" "$folder/log" || fail "no display: $(cat "$folder/log")"

[ "$failures" -eq 0 ] && echo "real_window: all as expected"
exit "$failures"
