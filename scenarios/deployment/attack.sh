#!/bin/bash
# The paper's four cars under attack: one row for each attack and fault, with what was expected and
# observed. Exit status 1 if one row fails.
#
#   scenarios/deployment/attack.sh
#
# Everything runs over the loopback interface; the attacker, a test fixture of starl-cli/launch, owns the network: each
# robot's file names a port of the attacker as the address of each other robot and of the cameras.
set -u
. "$(dirname "$0")/rig.sh"
# Below the ports that Linux gives to any program.
base=${BASE:-$((20000 + $$ % 120 * 100))}
limit=${LIMIT:-60}
# Short-lived processes on few cores; each robot has a guard process, too.
export STARL_JAVA_OPTS="${STARL_JAVA_OPTS:-} -XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Xmx128m"
failed=0
declare -A rounds_before=() answers=()

cleanup() {
  end_all
  [ -z "${ATTACK_PID:-}" ] || kill "$ATTACK_PID" 2>/dev/null
}
trap cleanup EXIT
trap 'exit 1' INT TERM

# file MACHINE: the deployment as machine 0 to 4 has it; machine 4 is a second bot0.
file() {
  local machine=$1 self=bot$(($1 % 4)) number address
  echo "app: intersection"
  echo "parameters: {scenario: figure7, debris: 0}"
  echo "seed: 7"
  echo "key: crossing.key"
  settings 0.05 "127.0.0.1:$((base + 20 + machine))" "127.0.0.1:$((base + 5))" no
  for number in 0 1 2 3; do
    address=127.0.0.1:$((base + 60 + 10 * machine + number))
    [ "bot$number" != "$self" ] || address=127.0.0.1:$((base + 8 + machine))
    if [ "$machine" = 4 ] && [ "$number" = 0 ]; then
      # Its Create is real to it: the world has no body for it.
      echo "  bot0: {address: \"$address\", chassis: {kind: create, port: $work/second.tty}}"
    else
      robot "bot$number" "$address" "$work/bot$number.tty"
    fi
  done
}

# until_ SECONDS COMMAND...: whether the command holds within that time.
until_() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ "$SECONDS" -lt "$end" ] || return 1
    sleep 0.2
  done
}

all_through() { [ "$(through "$1" "$2")" -ge 4 ]; }

# attack COMMAND: the attacker's answer is in $answer.
attack() {
  echo "$1" >&"${ATTACK[1]}"
  read -r answer <&"${ATTACK[0]}"
  answer=${answer#*: }
}

# The line of a merge that says whether the specifications held; else its last one.
merged() {
  { grep -m 1 '^safe' "$1" || tail -1 "$1"; } | cut -c1-120
}

# row NAME DID EXPECTED OBSERVED STATUS: OK if STATUS is 0.
row() {
  local verdict=OK
  [ "$5" = 0 ] || { verdict=FAILED; failed=1; }
  printf '%-7s %-16s | %s | expected: %s | observed: %s\n' "$verdict" "$1" "$2" "$3" "$4"
}

count() { cat "${@:2}" 2>/dev/null | grep -c -- "$1"; }
folder_kb() { du -sk "$1" | cut -f1; }
threads() { sed -n 's/^Threads:[[:space:]]*//p' "/proc/$1/status" 2>/dev/null || echo 0; }
ended() { ! kill -0 "$1" 2>/dev/null; }
rounds_done() { cat "$1"/bot?.log | grep -c 'end of round'; }
more_rounds() { [ "$(rounds_done "$1")" -ge "$2" ]; }

for machine in 0 1 2 3 4; do
  file $machine >"$work/bot$machine.yaml"
done
mkdir "$work/first" "$work/second" "$work/next"
# The world's own file has the cameras' true address.
sed "s/server: 127.0.0.1:[0-9]*/server: 127.0.0.1:$((base + 6))/" "$work/bot0.yaml" >"$work/world.yaml"
root=$here/../.. attacker=$here/../../starl-cli/launch/target/run/test-classes
$starl test -DskipTests -pl starl-cli/launch -am >"$work/build.log" || { cat "$work/build.log"; exit 1; }
# The Java that the launcher finds.
java=$(STARL_JAVA_OPTS=-XshowSettings:properties $starl list 2>&1 | sed -n 's/^ *java\.home = //p')/bin/java
attacker=$attacker:$root/target/starl-maven/starl.jar:$(cat "$root/starl-apps/kotlin/target/run/classpath.txt")
# shellcheck disable=SC2086
coproc ATTACK { exec "$java" $STARL_JAVA_OPTS -cp "$attacker" org.starl.launch.Attacker "$base"; }
$starl keygen "$work/crossing.key" >/dev/null || exit 1
read -r answer <&"${ATTACK[0]}" || exit 1
echo "4 robots, each in its process; files are in $work"

# --- the first run: attacks while robots cross again and again ---------------------------------------
run=$work/first
begin_world "$work/world.yaml" "$run"
for number in 0 1 2 3; do begin_robot bot$number "$work/bot$number.yaml" "$run" 1000; done
until_ $((2 * limit)) more_rounds "$run" 1 || { echo "no crossing without an attack"; failed=1; }
# A robot that is not there notices nothing: no row would say why.
all_run "$run" || exit 1

# Robots whose log or trace has a line with $1: an attack that nobody has noticed has not arrived.
noticed() { grep -ls -- "$1" "$run"/bot?.log "$run"/bot?.trace | sed 's/.*\(bot[0-9]\).*/\1/' | sort -u | grep -c .; }
all_noticed() { seen=$(noticed "$1"); [ "$seen" = 4 ]; }

# begin_attack COMMAND, and then crossing: whether a robot comes to the end of a round after it. All
# attacks begin before the first crossing is awaited; each needs a crossing after its own begin.
begin_attack() {
  rounds_before[$1]=$(rounds_done "$run")
  attack "$1 $2"
  answers[$1]=$answer
}
# insist COMMAND MS LINE: the attack again and again, until the log or trace of each robot has that line. A
# robot between two rounds is off the floor: it believes no pose, and has nothing to tell. It comes onto the floor only while
# the others drive: so each attack waits until a round has ended after the one before.
insist() {
  begin_attack "$1" "$2"
  until_ $((2 * limit)) told_by_all "$@"
}
told_by_all() {
  until_ 3 all_noticed "$3" && return
  until_ 30 more_rounds "$run" $((rounds_before[$1] + 1))
  begin_attack "$1" "$2"
  until_ 3 all_noticed "$3"
}
crossing() {
  until_ "$limit" more_rounds "$run" $((rounds_before[$1] + 1))
  local status=$?
  crossed="$(($(rounds_done "$run") - rounds_before[$1])) crossings"
  return $status
}
false_poses() { count '"xMm":7777' "$run"/bot?.trace; }

kb=$(folder_kb "$run")
begin_attack garbage 3000
begin_attack beacons 2000
begin_attack clients 4000
frames=${answer##* }
world=$(pgrep -P "${pids[world]}" -x java 2>/dev/null || echo "${pids[world]}")
few=$(threads "$world")
begin_attack tcp 900
# The thread of a connection that the world has closed may end a little later.
has_few_threads() { many=$(($(threads "$world") - few)); [ $many -lt 80 ]; }
until_ 10 has_few_threads
# The connections stay until 'hangup', while false poses come. The Create of a second bot0 starts meanwhile.
begin create create "$work/second/create.log" $starl simulated-create --pty "$work/second.tty"
a_single='jumps from .* to (7777 mm'
insist pose 2000 "$a_single"
single=$(false_poses)
two_places='is measured at .* and at (7777 mm'
insist poses 2000 "$two_places"
begin_attack models 1
begin_attack info 7
begin_attack ticks 7
# Robots tell jumps once in 10 s.
sleep 11
half_way='is measured at .* and at ([0-6]\?[0-9]\{1,3\} mm'
insist scaled 3000 "$half_way"

# The next robot but bot0 whose round ends loses its storage below: it has just unregistered, so it holds
# no zone.
lost=bot2
declare -A ends_before=()
ends() { count 'end of round' "$run/$1.log"; }
for name in bot1 bot2 bot3; do ends_before[$name]=$(ends $name); done
ends_round() {
  for lost in bot1 bot2 bot3; do [ "$(ends $lost)" -gt "${ends_before[$lost]}" ] && return; done
  return 1
}
until_ "$limit" ends_round
kill -9 "${pids[$lost]}"
wait "${pids[$lost]}" 2>/dev/null

crossing garbage
status=$?
grown=$(($(folder_kb "$run") - kb))
[ $grown -lt 8192 ] || status=1
all_noticed 'longer than any StarL datagram' || status=1
row "garbage" "${answers[garbage]}: noise, changed, cut, too long" \
  "all drop it, crossings go on, files grow less than 8 MB" "$seen drop it, $crossed, $grown kB" $status
crossing beacons
status=$?
all_noticed 'a beacon that the robot it names has not signed' || status=1
row "forged beacons" "${answers[beacons]}: changed, and repeated" "all drop them, crossings go on" \
  "$seen drop them, $crossed" $status
served=${answers[clients]#*, } served=${served%% *}
crossing clients && [ "$frames" -ge 50 ] && [ "$served" -le 64 ] && [ "$served" -gt 0 ]
status=$?
row "NatNet clients" "${answers[clients]%%,*}, 3,000 a second" \
  "at most 64 of 500 get frames, each robot has 50 frames/s, crossings go on" \
  "$served get frames, $frames frames/s, $crossed" $status
crossing tcp && [ $many -lt 80 ] && [ "${answers[tcp]%% *}" -ge 800 ]
status=$?
row "TCP to world" "${answers[tcp]}, without a name" "fewer than 80 threads, crossings go on" \
  "$many threads more, $crossed" $status
crossing pose && [ "$single" = 0 ] && all_noticed "$a_single"
status=$?
row "single poses" "${answers[pose]} in the cameras' name, one to a robot each 0.3 s" \
  "none used, all tell it, crossings go on" "$single used, $seen tell it, $crossed" $status
crossing poses && [ "$(false_poses)" = "$single" ] && all_noticed "$two_places"
status=$?
row "many poses" "${answers[poses]}, 200 a second to each robot" \
  "none used, all stop and tell both places, crossings go on" \
  "$(($(false_poses) - single)) used, $seen tell it, $crossed" $status
# forged COMMAND NAME WHAT LINE: a row about forged messages of the cameras.
forged() {
  crossing "$1" && all_noticed "$4"
  row "$2" "${answers[$1]}: $3" "all tell it, crossings go on" "$seen tell it, $crossed" $?
}
forged models "swapped models" "two names swapped" 'rigid bodies differ'
forged info "server info" "of NatNet 3.1" 'a server of NatNet 3.1 has described itself'
forged ticks "tick rate" "twice the rate" 'another server has described itself'
crossing scaled && all_noticed "$half_way"
row "scaled poses" "${answers[scaled]}: positions by half, 3 times the cameras' rate" \
  "all stop and tell both places, crossings go on" "$seen tell it, $crossed" $?
attack hangup

# Both at once: a robot without its storage may believe the second bot0, and must not stop the first one.
mv "$run/$lost.storage" "$run/$lost.lost"
mv "$run/$lost.log" "$run/$lost.before.log"
begin_robot "$lost" "$work/$lost.yaml" "$run" 1000
until_ 20 grep -qs ' at ' "$work/second/create.log"
begin second bot0 "$work/second/bot0.log" \
  $starl deploy run "$work/bot4.yaml" --robot bot0 --folder "$work/second"
told() { grep -hE 'end of round 1 |another storage' "$run/$lost.log"; }
joined_or_told() { told >/dev/null || ended "${pids[$lost]}"; }
until_ "$limit" joined_or_told
grep -q "knows another storage of $lost" "$run/$lost.log"
status=$?
row "storage lost" "$lost killed, its storage deleted, started again" "it stops and says why" \
  "$([ $status = 0 ] && { told || tail -qn1 "$run/$lost.log"; } | head -1 | cut -c1-120 || echo "neither within $limit s")" $status
second_told() { ended "${pids[second]}" && grep -q 'wheels stopped: .* knows another storage of bot0' "$work/second/bot0.log"; }
# Broadcasts would let both hear each other, and both would stop; here each has a fixed address.
until_ 20 second_told && ! ended "${pids[bot0]}"
status=$?
state() { ended "${pids[$1]}" && echo "ended: $(grep 'wheels stopped' "$2" | cut -c1-100)" || echo runs; }
row "second bot0" "another machine started as bot0" "the others refuse it; it stops and says why" \
  "the first $(state bot0 "$run/bot0.log"); the second $(state second "$work/second/bot0.log")" $status
end_all

# --- the next run: the same key, new storage; at first it hears nothing but the recording -------------
run=$work/next
attack forget
recorded=$answer
attack block
begin_world "$work/world.yaml" "$run"
for number in 0 1 2 3; do begin_robot bot$number "$work/bot$number.yaml" "$run" 1; done
on_floor() { [ "$(count 'is on the floor' "$run/world.log")" = 4 ]; }
$starl deploy merge "$work/first"/*.trace >"$work/first.txt"
status=$?
row "first run" "all traces merged" "no violation" "$(merged "$work/first.txt")" $status
until_ "$limit" on_floor
all_run "$run" || exit 1
attack "replay 4000"
sleep 1
# A robot's messages to itself do not pass the network.
accepted=$(cat "$run"/bot?.trace | grep '"kind":"delivered"' | grep -vc '"robot":"\(bot.\)","from":"\1"')
refused=$(count '"kind":"dropped"' "$run"/bot?.trace)
[ "$accepted" = 0 ] && all_noticed '"kind":"dropped"'
status=$?
row "replay" "$recorded in the first run, ${answer%,*} from their senders' addresses" \
  "none accepted, all refuse them" "$accepted accepted, $refused refused by $seen" $status
hears=$(count 'network: hears' "$run"/bot?.log) beacons=${answer#*, } beacons=${beacons%% *}
# Beacons come from the addresses whose other datagrams all robots have refused.
[ "$hears" = 0 ] && [ "$beacons" -gt 0 ] && [ "$seen" = 4 ]
status=$?
row "replayed beacons" "$beacons beacons of the first run among them" "no robot seems alive" \
  "$hears seem alive" $status
attack pass
until_ "$limit" all_through "$run" 1
status=$?
row "after the replay" "the network works again" "all cross" \
  "$(through "$run" 1) of 4 cross; $(grep -h 'VIOLATED' "$run"/bot?.log | head -1 | cut -c1-100)" $status
end_all
$starl deploy merge "$run"/*.trace >"$work/next.txt"
status=$?
row "next run" "all traces merged" "no violation" "$(merged "$work/next.txt")" $status

echo "in $SECONDS s"
exit $failed
