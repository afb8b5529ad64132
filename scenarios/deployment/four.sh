#!/bin/bash
# Four robots in four network namespaces, each on a simulated Create behind a pseudo terminal, positions
# from a NatNet server, a tenth of all messages lost. App, parameters, seed and limits are those of a
# deployment file beside this script: the paper's four cars, which cross again and again, unless named.
#
#   scenarios/deployment/four.sh [ROUNDS] [KILL]     5 rounds each; bot2 is killed after KILL seconds
#   scenarios/deployment/four.sh search              or lightpaint: one round, to its end
#   scenarios/deployment/four.sh soak [MINUTES]      cars cross again and again for 30 minutes, with the
#       memory and threads of each process each minute: in soak.txt, the first and last also printed
#
# Needs root for the namespaces; without it everything runs over the loopback interface.
set -u
name=crossing
rounds=5
soak_minutes=
case ${1:-} in
  soak) soak_minutes=${2:-30}; set -- 1000000 ;;
  [a-z]*) name=$1; rounds=1; shift ;;
esac
rounds=${1:-$rounds}
kill_after=${2:-}
. "$(dirname "$0")/rig.sh"
net=starl$$

cleanup() {
  end_all
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
  in_space() {
    local space=$1
    shift
    exec ip netns exec "$net-$space" "$@"
  }
fi

# The deployment. In namespaces robots find each other by their beacons; without them each robot has a
# port of its own on 127.0.0.1.
file=$here/$name.yaml
[ -f "$file" ] || { echo "$file: no such deployment; expected crossing, search or lightpaint"; exit 2; }
objects=$(sed -n 's/^ *\(objects: [a-z]*\)$/, \1/p' "$file" | sort -u)
host=127.0.0.1
[ -z "$spaces" ] || host=10.47.0.1
{
  sed -n '/^app:/,/^seed:/p' "$file"
  settings 0.1 "$host" "$host:4745" "$([ -n "$spaces" ] && echo yes || echo no)"
  number=4748
  for each in $robots; do
    key=$($starl keygen --robot "$each" "$work/$each.key" 2>/dev/null | sed 's/^ */, /') || exit 1
    robot "$each" "$([ -n "$spaces" ] || echo "127.0.0.1:$number")" "$work/$each.tty" "$key$objects"
    number=$((number + 1))
  done
  sed -n '/^limits:/,$p' "$file"
} >"$work/$name.yaml"

$starl deploy check "$work/$name.yaml" || exit 1
begin_world "$work/$name.yaml" "$work"
for each in $robots; do begin_robot "$each" "$work/$name.yaml" "$work" "$rounds"; done
echo "4 robots run, each in its process; traces and logs are in $work"

# sample MINUTE NAME PROCESS: a line of soak.txt. jcmd counts the live objects, after a full collection,
# and the fillers that this collection leaves in place of dead ones. None if the process has just ended:
# a robot has another guard in each round.
sample() {
  local live
  live=$("$(dirname "$(readlink "/proc/$3/exe")")/jcmd" "$3" GC.class_histogram 2>/dev/null |
    awk '/FillerElement|FillerArray/ { fill += $3 } /^Total/ { print int(($3 - fill) / 1024) }')
  awk -v minute="$1" -v name="$2" -v live="$live" '/^VmRSS:/ { rss = $2 } /^Threads:/ { threads = $2 }
    END { printf "%6s %-11s %8s %8s %8s\n", minute, name, rss, live, threads }' "/proc/$3/status" >>"$work/soak.txt" 2>/dev/null
}
# Each robot's process has started its guard.
sample_all() {
  local each
  sample "$1" world "${pids[world]}"
  for each in $robots; do
    sample "$1" "$each" "${pids[$each]}"
    sample "$1" "$each-guard" "$(pgrep -P "${pids[$each]}" -x java)"
  done
}
[ -z "$soak_minutes" ] || printf '%6s %-11s %8s %8s %8s\n' minute process 'RSS kB' 'live kB' threads >"$work/soak.txt"

began=$SECONDS
minute=1
killed=
while :; do
  sleep 1
  [ "$(through "$work" "$rounds")" = 4 ] && break
  if [ -n "$kill_after" ] && [ -z "$killed" ] && [ $((SECONDS - began)) -ge "$kill_after" ]; then
    killed=$SECONDS
    kill -9 "${pids[bot2]}"
    echo "killed bot2's process ${pids[bot2]} $((SECONDS - began)) s after the begin"
  fi
  # A robot waits for ever for the zones that a dead one may hold: 40 s show what there is to see.
  [ -n "$killed" ] && [ $((SECONDS - killed)) -ge 40 ] && break
  if [ -z "$soak_minutes" ]; then
    [ $((SECONDS - began)) -ge $((60 * rounds + 540)) ] && { echo "not through in time"; break; }
  elif [ $((SECONDS - began)) -ge $((60 * minute)) ]; then
    sample_all $minute
    [ $minute -ge "$soak_minutes" ] && break
    minute=$((minute + 1))
  fi
done
[ -z "$soak_minutes" ] || grep -E '^ *(minute|1|'"$minute"') ' "$work/soak.txt"
echo "$(cat "$work"/bot?.log | grep -c 'end of round') runs of the app ended, in $((SECONDS - began)) s"
[ -z "$killed" ] || grep -h 'fences bot2' "$work"/bot?.log
end_all
grep -h 'strand:' "$work"/*.log
$starl deploy merge "$work"/*.trace --out "$work/merged.trace"
status=$?
echo "merged: $work/merged.trace ('starl replay' shows it)"
exit $status
