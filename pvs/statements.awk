# Reads a file that `starl run --pvs` exported, and tells each line that such a file does not have. The
# statements of a run follow from its steps: each is made here again and compared, so a file cannot state
# less, or mean its own `enabled` by it. How many results there are says the head; of a result the recorded
# value is open. Used by pvs/check: awk -v library=FOLDER.
# Prints "run THEORY STEPS" for each theory, or "wrong LINE WHAT" for the first line that differs.

function wrong(what) {
  print "wrong " FNR " " what
  failed = 1
  exit
}

# A value declares nothing: it has no colon but after a bound variable, and no word of a declaration.
function is_value(text) {
  gsub(/LAMBDA \(i: [A-Za-z]+\):/, "", text)
  gsub(/\{x: [A-Za-z]+ \|/, "", text)
  gsub(/:=/, "", text)
  if (text !~ /^[A-Za-z0-9_ (),#{}=`]*$/) return 0
  text = " " tolower(text) " "
  gsub(/[^a-z0-9_]+/, "  ", text)
  return text !~ / (importing|exporting|conversion|auto_rewrite|judgement|library|type|var|let|with|end|begin|lemma|axiom) /
}

# A recorded value reads no state and applies no function but the constructor `up`.
function is_recorded(claim) {
  sub(/^[^=]* = /, " ", claim)
  gsub(/[^A-Za-z0-9_]up\(/, " (", claim)
  return claim !~ /`|[A-Za-z0-9_]\(|[^A-Za-z0-9_]s_[0-9]/
}

# What step n, of an action, must state of the state after it; "" if it states nothing.
function result_of(action, n, name, i) {
  name = action
  sub(/\(.*/, "", name)
  i = action
  sub(/^[^(]*\(/, "", i)
  sub(/[,)].*/, "", i)
  if (automaton == "Mutex_decls" && name ~ /^(od_mutex|release)$/) return "s_" n "`crit_set(" i ")"
  if (automaton == "Registration_decls" && name == "learn") return "rList(" i ", s_" n ")"
  if (automaton == "Registration_decls" && name == "give_up") return "s_" n "`gone(" i ")"
  if (automaton == "SetAgreement_decls" && name ~ /^(decide|restart)$/) return "s_" n "`decided(" i ")"
  if (automaton == "Election_decls" && name ~ /^(learn|fail)$/) return "s_" n "`Leader(" i ")"
  return ""
}

# The statement that must come next.
function expected(name, n, before) {
  n = name
  sub(/^[a-z]+_?/, "", n)
  if (name == "begins") return "start(s_0)"
  if (name ~ /^reached_/) return "reachable(s_" n ")"
  before = n - 1
  return "enabled(a_" n ", s_" before ") AND trans(a_" n ", s_" before ") = s_" n
}

function statement(line, name, text, step) {
  name = text = line
  sub(/^  /, "", name)
  sub(/: LEMMA .*/, "", name)
  sub(/^[^:]*: LEMMA /, "", text)
  step = (stated - 1) / 2
  if (name ~ /^result_/ && stated > 2 && stated % 2 == 1) {
    results++
    all_results++
    if (name != "result_" step (results == 1 ? "" : "_" results)) wrong("states " name " as result " results " of step_" step)
    if (text !~ /^[A-Za-z0-9_`]+\(.*\) = / || !is_value(text)) wrong("not what a run states")
    if (!is_recorded(text)) wrong(name " compares with what the automaton makes itself; expected a recorded value")
    if (results == 1 && needed[step] != "" && index(text, needed[step] " = ") != 1) wrong(name " states something else; expected " needed[step] " = ...")
    return
  }
  if (name ~ /^reached_/ && stated > 2 && needed[step] != "" && results == 0) wrong("step_" step " has no result; expected result_" step ": LEMMA " needed[step] " = ...")
  results = 0
  stated++
  next_name = stated == 1 ? "begins" : stated % 2 == 0 ? "reached_" (stated / 2 - 1) : "step_" (stated - 1) / 2
  if (name != next_name) wrong("states " name "; expected " next_name)
  if (text != expected(name)) wrong(name " states something else; expected " expected(name))
  if (name ~ /^step_/ && stated > 2 * steps + 2) wrong("states a step that the run does not have")
}

/[[:cntrl:]]/ { wrong("has a control character") }

place == "" {
  if (/^%.*: [0-9]+ steps, [0-9]+ results$/) told_results = $(NF - 1)
  if (/^$/ || /^%[^|]/) next
  if (!/^run_[A-Za-z0-9_]+: THEORY$/) wrong("expected a theory of a run, run_...: THEORY")
  if (told_results == "") wrong("expected a line before it that ends with N steps, N results")
  theory = substr($1, 1, length($1) - 1)
  place = "theory"
  next
}
place == "theory" {
  if ($0 != "BEGIN") wrong("expected BEGIN")
  place = "types"
  next
}
place == "types" {
  if (/^  % / || /^  [A-Z][A-Za-z]*: TYPE = \{[A-Za-z][A-Za-z0-9_]*(, [A-Za-z][A-Za-z0-9_]*)*\}$/) next
  if (!/^  IMPORTING [A-Za-z]+_decls\[[A-Z][A-Za-z]*(, [A-Z][A-Za-z]*)*\]$/) wrong("expected types, and one of the library's automata")
  automaton = $2
  sub(/\[.*/, "", automaton)
  if ((getline any < (library "/" automaton ".pvs")) < 0) wrong(automaton " is not in the library")
  close(library "/" automaton ".pvs")
  place = "states"
  steps = 0
  states = 0
  stated = 0
  all_results = 0
  next
}
place == "states" {
  if (/^$/ || /^  % /) next
  if (/^  s_[0-9]+: states =$/) {
    if ($1 != "s_" states ":") wrong("expected s_" states)
    states++
    next
  }
  if (/^  a_[0-9]+: actions = /) {
    steps++
    if ($1 != "a_" steps ":" || states != steps) wrong("expected a_" steps " after s_" (steps - 1))
    sub(/^  a_[0-9]+: actions = /, "")
    if (!is_value($0)) wrong("not an action of a run")
    needed[steps] = result_of($0, steps)
    next
  }
  if (/^    /) {
    if (!is_value($0)) wrong("not a state of a run")
    next
  }
  if (states != steps + 1) wrong("not what an exported run has; expected s_" states)
  place = "statements"
}
place == "statements" {
  if (/^$/ || /^%\|- /) next
  if (/^  [a-z]+(_[0-9]+)*: LEMMA /) {
    statement($0)
    next
  }
  if ($0 != "END " theory) wrong("not what an exported run has")
  if (stated != 2 * steps + 2) wrong("states only " stated " of " (2 * steps + 2) " obligations")
  if (all_results != told_results) wrong("states " all_results " of " told_results " results")
  print "run " automaton " " steps
  told_results = ""
  place = ""
}

END {
  if (!failed && place != "") wrong("the theory does not end")
}
