# What four.sh and attack.sh share: the paper's four cars, a process each, on simulated Creates behind
# pseudo terminals, with positions from a NatNet server. To be sourced. A script may define
# in_space SPACE COMMAND..., which runs a command where that process belongs; without it, it runs here.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
starl=${STARL:-$here/../../starl}
work=$(mktemp -d)
robots="bot0 bot1 bot2 bot3"
declare -A pids=()

in_space() {
  shift
  exec "$@"
}

# The deployment's parts that are the same in each rig: LOSS, HOST of the cameras, HOST:PORT of the
# world, and yes or no for broadcasts.
settings() {
  echo "network: {loss: $1, broadcasts: $4}"
  echo "positions: {source: natnet, server: $2, version: 4.1, up: y}"
  echo "world: $3"
  echo "robots:"
}

# One robot's line: NAME, ADDRESS or nothing, terminal, and more fields, each after a comma.
robot() {
  echo "  $1: {${2:+address: \"$2\", }chassis: {kind: create, port: $3, simulatedAt: $3}${4:-}}"
}

# begin NAME SPACE LOG COMMAND...: a process, with its number in pids[NAME].
begin() {
  local name=$1 space=$2 log=$3
  shift 3
  (in_space "$space" "$@") >"$log" 2>&1 &
  pids[$name]=$!
}

# begin_world FILE FOLDER: until it runs.
begin_world() {
  begin world world "$2/world.log" $starl deploy world "$1" --folder "$2"
  until grep -qs 'runs' "$2/world.log"; do
    kill -0 "${pids[world]}" || { cat "$2/world.log"; exit 1; }
    sleep 0.2
  done
}

# begin_robot NAME FILE FOLDER ROUNDS
begin_robot() {
  begin "$1" "$1" "$3/$1.log" $starl deploy run "$2" --robot "$1" --folder "$3" --rounds "$4"
}

# all_run FOLDER: whether the processes of all robots run; else the log of one that has ended is shown.
all_run() {
  local name
  for name in $robots; do
    kill -0 "${pids[$name]}" 2>/dev/null || { echo "$name has ended:"; tail -n 5 "$1/$name.log"; return 1; }
  done
}

# The number of robots that have come to the end of round $2, by the logs in folder $1.
through() {
  cat "$1"/bot?.log | grep -c "end of round $2 of"
}

# end NAME...: stops processes in order, all at once.
end() {
  local name
  for name; do kill "${pids[$name]}" 2>/dev/null; done
  for name; do
    wait "${pids[$name]}" 2>/dev/null
    unset "pids[$name]"
  done
}

# The robots first, and then their world.
end_all() {
  local name names=()
  for name in "${!pids[@]}"; do [ "$name" = world ] || names+=("$name"); done
  end "${names[@]}"
  [ -z "${pids[world]:-}" ] || end world
}
