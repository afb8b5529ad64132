#!/bin/bash
# Four robots in four network namespaces, each on a simulated Create behind a pseudo terminal, positions
# from a NatNet server, a tenth of all messages lost: the paper's four cars cross again and again.
#
#   scenarios/deployment/four.sh [ROUNDS] [KILL]     5 rounds each; bot2 is killed after KILL seconds
#
# Needs root for the namespaces; without it everything runs over the loopback interface.
set -u
rounds=${1:-5}
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
{
  echo "app: intersection"
  echo "parameters: {scenario: figure7, debris: 0, speedError: 0.05}"
  echo "seed: 7"
  echo "network: {loss: 0.1, broadcasts: $([ -n "$spaces" ] && echo yes || echo no)}"
  echo "positions: {source: natnet, server: $(host), version: 4.1, up: y}"
  echo "world: $(host):4745"
  echo "robots:"
  number=2
  for robot in $robots; do
    key=$($starl keygen --robot $robot "$work/$robot.key" 2>/dev/null | sed 's/^ *//') || exit 1
    # Where there are namespaces, nobody is told where the others are: their beacons say it.
    [ -n "$spaces" ] || echo "  $robot: {$key, address: \"$(address $number)\", chassis: {kind: create, port: $work/$robot.tty, simulatedAt: $work/$robot.tty}}"
    [ -z "$spaces" ] || echo "  $robot: {$key, chassis: {kind: create, port: $work/$robot.tty, simulatedAt: $work/$robot.tty}}"
    number=$((number + 1))
  done
} >"$work/crossing.yaml"

in_space() {
  local space=$1
  shift
  if [ -n "$spaces" ]; then exec ip netns exec "$net-$space" "$@"; else exec "$@"; fi
}

$starl deploy check "$work/crossing.yaml" || exit 1
(in_space world $starl deploy world "$work/crossing.yaml" --folder "$work") >"$work/world.log" 2>&1 &
pids+=($!)
until grep -qs 'runs' "$work/world.log"; do
  kill -0 "${pids[0]}" || { cat "$work/world.log"; exit 1; }
  sleep 0.2
done
for robot in $robots; do
  (in_space "$robot" $starl deploy run "$work/crossing.yaml" --robot "$robot" --folder "$work" --rounds "$rounds") >"$work/$robot.log" 2>&1 &
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
  # Whoever waits for what a dead one may hold waits for ever: 40 s show what there is to see.
  [ -n "$killed" ] && [ $((SECONDS - killed)) -ge 40 ] && break
  [ $((SECONDS - began)) -ge $((60 * rounds + 120)) ] && { echo "not through in time"; break; }
done
echo "$(cat "$work"/bot?.log | grep -c 'end of round') crossings in $((SECONDS - began)) s"
[ -z "$killed" ] || grep -h 'fences bot2' "$work"/bot?.log
for pid in "${pids[@]:1}" "${pids[0]}"; do kill "$pid" 2>/dev/null; wait "$pid" 2>/dev/null; done
pids=()
grep -h 'strand:' "$work"/*.log
$starl deploy merge "$work"/*.trace --out "$work/merged.trace"
status=$?
echo "merged: $work/merged.trace ('starl replay' shows it)"
exit $status
