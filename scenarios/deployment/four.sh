#!/bin/bash
# Four robots in four network namespaces, each on a simulated Create behind a pseudo terminal, positions
# from a NatNet server, a tenth of all messages lost. App, parameters, seed and limits are those of a
# deployment file beside this script: the paper's four cars, which cross again and again, unless named.
#
#   scenarios/deployment/four.sh [ROUNDS] [KILL]     5 rounds each; bot2 is killed after KILL seconds
#   scenarios/deployment/four.sh search              or lightpaint: one round, to its end
#
# Needs root for the namespaces; without it everything runs over the loopback interface.
set -u
name=crossing
rounds=5
case ${1:-} in
  [a-z]*) name=$1; rounds=1; shift ;;
esac
rounds=${1:-$rounds}
kill_after=${2:-}
here=$(cd "$(dirname "$0")" && pwd)
starl=${STARL:-$here/../../starl}
work=$(mktemp -d)
robots="bot0 bot1 bot2 bot3"
net=starl$$
pids=()

cleanup() {
  for pid in ${pids[@]+"${pids[@]}"}; do kill "$pid" 2>/dev/null; done
  wait
  if [ -n "$spaces" ]; then
    for each in world $robots; do ip netns delete "$net-$each" 2>/dev/null; done
    ip link delete "$net" 2>/dev/null
  fi
}

spaces=yes
if [ "$(id -u)" != 0 ] || ! ip netns add "$net-world" 2>/dev/null; then
  spaces=
  echo "no network namespaces here: over the loopback interface instead"
fi
trap cleanup EXIT
trap 'exit 1' INT TERM

if [ -n "$spaces" ]; then
  ip link add "$net" type bridge && ip link set "$net" up
  number=1
  for each in world $robots; do
    [ "$each" = world ] || ip netns add "$net-$each"
    ip link add "v$$-$number" type veth peer name eth0 netns "$net-$each"
    ip link set "v$$-$number" master "$net" up
    ip -n "$net-$each" link set lo up
    ip -n "$net-$each" addr add "10.47.0.$number/24" broadcast 10.47.0.255 dev eth0
    ip -n "$net-$each" link set eth0 up
    number=$((number + 1))
  done
fi

# The deployment: without namespaces each robot has a port of its own on 127.0.0.1.
address() { if [ -n "$spaces" ]; then echo "10.47.0.$1"; else echo "127.0.0.1:$((4746 + $1))"; fi; }
host() { if [ -n "$spaces" ]; then echo 10.47.0.1; else echo 127.0.0.1; fi; }
file=$here/$name.yaml
[ -f "$file" ] || { echo "$file: no such deployment; expected crossing, search or lightpaint"; exit 2; }
objects=$(sed -n 's/^ *\(objects: [a-z]*\)$/, \1/p' "$file" | sort -u)
{
  # Wheels that are not exact, so that positions differ from the odometry.
  sed -n '/^app:/,/^seed:/p' "$file" | sed 's/^parameters:$/&\n  speedError: 0.05/'
  echo "network: {loss: 0.1, broadcasts: $([ -n "$spaces" ] && echo yes || echo no)}"
  echo "positions: {source: natnet, server: $(host), version: 4.1, up: y}"
  echo "world: $(host):4745"
  echo "robots:"
  number=2
  for robot in $robots; do
    key=$($starl keygen --robot $robot "$work/$robot.key" 2>/dev/null | sed 's/^ *//') || exit 1
    # In namespaces robots find each other by their beacons.
    [ -n "$spaces" ] || echo "  $robot: {$key, address: \"$(address $number)\", chassis: {kind: create, port: $work/$robot.tty, simulatedAt: $work/$robot.tty}$objects}"
    [ -z "$spaces" ] || echo "  $robot: {$key, chassis: {kind: create, port: $work/$robot.tty, simulatedAt: $work/$robot.tty}$objects}"
    number=$((number + 1))
  done
  sed -n '/^limits:/,$p' "$file"
} >"$work/$name.yaml"

in_space() {
  local space=$1
  shift
  if [ -n "$spaces" ]; then exec ip netns exec "$net-$space" "$@"; else exec "$@"; fi
}

$starl deploy check "$work/$name.yaml" || exit 1
(in_space world $starl deploy world "$work/$name.yaml" --folder "$work") >"$work/world.log" 2>&1 &
pids+=($!)
until grep -qs 'runs' "$work/world.log"; do
  kill -0 "${pids[0]}" || { cat "$work/world.log"; exit 1; }
  sleep 0.2
done
for robot in $robots; do
  (in_space "$robot" $starl deploy run "$work/$name.yaml" --robot "$robot" --folder "$work" --rounds "$rounds") >"$work/$robot.log" 2>&1 &
  pids+=($!)
done
echo "4 robots run, each in its process; traces and logs are in $work"

began=$SECONDS
killed=
while :; do
  sleep 1
  through=$(cat "$work"/bot?.log | grep -c "end of round $rounds of $rounds")
  [ "$through" = 4 ] && break
  if [ -n "$kill_after" ] && [ -z "$killed" ] && [ $((SECONDS - began)) -ge "$kill_after" ]; then
    killed=$SECONDS
    kill -9 "${pids[3]}"
    echo "killed bot2's process ${pids[3]} $((SECONDS - began)) s after the begin"
  fi
  # A robot that waits for a section of a dead one waits for ever: 40 s show what there is to see.
  [ -n "$killed" ] && [ $((SECONDS - killed)) -ge 40 ] && break
  [ $((SECONDS - began)) -ge $((60 * rounds + 540)) ] && { echo "not through in time"; break; }
done
echo "$(cat "$work"/bot?.log | grep -c 'end of round') runs of the app ended, in $((SECONDS - began)) s"
[ -z "$killed" ] || grep -h 'fences bot2' "$work"/bot?.log
for pid in "${pids[@]:1}" "${pids[0]}"; do kill "$pid" 2>/dev/null; wait "$pid" 2>/dev/null; done
pids=()
grep -h 'strand:' "$work"/*.log
$starl deploy merge "$work"/*.trace --out "$work/merged.trace"
status=$?
echo "merged: $work/merged.trace ('starl replay' shows it)"
exit $status
