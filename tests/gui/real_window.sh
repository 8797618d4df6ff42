#!/usr/bin/env bash
# The window on a real display (Xvfb) with real keys and a real mouse: real_window.sh PROGRAM. Prints what failed.
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

start_display() {
  Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp 3> "$folder/display" 2> /dev/null &
  server=$!
  for _ in $(seq 200); do
    [ -s "$folder/display" ] && break
    sleep 0.05
  done
  DISPLAY=:$(cat "$folder/display")
  export DISPLAY
}

# Waits for the window and gives it the keyboard.
focus() {
  local window
  window=$(timeout 60 xdotool search --sync --onlyvisible --name pabd | head -n 1)
  xdotool windowfocus --sync "$window"
  sleep 0.3
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
[ {"do": "until", "at": "/playing", "is": true},
  {"do": "until", "at": "/a/step", "above": 5},
  {"do": "until", "at": "/playing", "is": false},
  {"do": "until", "at": "/ui/help", "is": true},
  {"do": "until", "at": "/ui/help", "is": false},
  {"do": "expect", "at": "/a/report/contacts", "above": 0} ]
ACTIONS
"$program" view two_boxes --size 1280x720 --scale 1 --script "$folder/actions.json" > "$folder/log" 2>&1 &
pid=$!
focus
xdotool key space
sleep 1.5
xdotool mousemove 88 665 click 1 # the button for play and pause
sleep 0.7
xdotool key F1
sleep 0.7
xdotool key Escape
sleep 1
xdotool key ctrl+q
expect_exit 0 "keys and mouse, ctrl+q" "$pid"

"$program" view two_boxes --play > "$folder/log" 2>&1 &
pid=$!
focus
kill -INT "$pid"
expect_exit 130 "SIGINT" "$pid"

"$program" view two_boxes --play > "$folder/log" 2>&1 &
pid=$!
focus
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
