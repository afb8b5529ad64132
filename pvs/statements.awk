# Reads a file that `starl run --pvs` exported, by the grammar of such files, and tells the first thing that
# is not of it. A state is a value, not a formula, and the statements of a run follow from its steps: so a
# file cannot state less, or mean its own `enabled` by it. How many results there are says the line before
# the theory; of a result the recorded value is open. Used by pvs/check: awk -v library=FOLDER.
# Prints "run THEORY STEPS" for each theory, or "wrong LINE WHAT".

function wrong(what) {
  print "wrong " (token[at] != "" ? line[at] : FNR) " " what
  failed = 1
  exit
}

# The next words must be these, which stand between spaces.
function expect(words, each, n, i) {
  n = split(words, each, " ")
  for (i = 1; i <= n; i++) if (!has(each[i])) wrong("has " shown() "; expected " each[i] (n > 1 ? " of " words : ""))
}

function shown() {
  return token[at] != "" ? "'" token[at] "'" : "no more"
}

function has(word) {
  if (token[at] != word) return 0
  at++
  return 1
}

function name() {
  if (token[at] !~ /^[A-Za-z]/) wrong("has " shown() "; expected a name")
  return token[at++]
}

function type() {
  if (token[at] != "nat" && !(token[at] in is_type)) wrong("has " shown() "; expected nat or a type of the run")
  at++
}

# A constant of the run, or a number.
function constant() {
  if (token[at] !~ /^[0-9]/ && !(token[at] in is_constant)) wrong("has " shown() "; expected a value of the run")
  return token[at++]
}

function value(seen, c) {
  if (has("emptyset") || has("bottom") || has("TRUE") || has("FALSE")) return
  if (has("up") || has("constantly")) { expect("("); value(); expect(")") }
  else if (has("{")) {
    expect("x :")
    type()
    expect("|")
    do { expect("x ="); constant() } while (has("OR"))
    expect("}")
  } else if (has("(#")) {
    do { name(); expect(":="); value() } while (has(","))
    expect("#)")
  } else if (has("LAMBDA")) {
    expect("( i :")
    type()
    expect(") :")
    if (has("IF")) {
      do {
        expect("i =")
        c = constant()
        if (index(seen, " " c " ")) wrong("has a second value for " c)
        seen = seen " " c " "
        expect("THEN")
        value()
      } while (has("ELSIF"))
      expect("ELSE")
      value()
      expect("ENDIF")
    } else value()
  } else constant()
}

function state(n) {
  expect("s_" n " : states = (#")
  at--
  value()
}

# What step n, of an action `does` of i, must state of the state after it; "" if it states nothing.
function result_of(does, i, n) {
  if (automaton == "Mutex_decls" && does ~ /^(od_mutex|release)$/) return "s_" n " ` crit_set ( " i " )"
  if (automaton == "Registration_decls" && does == "learn") return "rList ( " i " , s_" n " )"
  if (automaton == "Registration_decls" && does == "give_up") return "s_" n " ` gone ( " i " )"
  if (automaton == "SetAgreement_decls" && does ~ /^(decide|restart)$/) return "s_" n " ` decided ( " i " )"
  if (automaton == "Election_decls" && does ~ /^(learn|fail)$/) return "s_" n " ` Leader ( " i " )"
  return ""
}

# The recorded value is one: it reads no state.
function result(n, k) {
  expect("result_" n (k == 1 ? "" : "_" k) " : LEMMA")
  if (k == 1 && needed[n] != "") expect(needed[n])
  else if (has("s_" n)) { expect("`"); name(); expect("("); constant(); expect(")") }
  else { name(); expect("("); constant(); expect(", s_" n " )") }
  expect("=")
  value()
}

function declare(formal) {
  expect(formal " : TYPE = {")
  is_type[formal]
  do {
    if (token[at] in is_constant || token[at] ~ /^([sa]_[0-9]+|x|i|up|bottom|constantly|emptyset|nat)$/)
      wrong("has " shown() ", which means something else already; expected another name")
    is_constant[name()]
  } while (has(","))
  expect("}")
}

function action(n, does, first) {
  expect("a_" n " : actions =")
  does = name()
  if (has("(")) {
    first = token[at]
    do value(); while (has(","))
    expect(")")
  }
  needed[n] = result_of(does, first, n)
}

function theory(head, words, n, told, steps, results, formals, formal, i, k) {
  # % RUN: INSTANCE, as a run of THEORY: N steps, N results
  n = split(head, words, " ")
  if (head !~ /^%.*: .*, as a run of [A-Za-z]+_decls: [0-9]+ steps, [0-9]+ results$/)
    wrong("expected a line before it that ends with: INSTANCE, as a run of THEORY: N steps, N results")
  automaton = substr(words[n - 4], 1, length(words[n - 4]) - 1)
  if (automaton !~ /^(Mutex|Registration|SetAgreement|Election)_decls$/) wrong("no runs of " automaton " are exported")
  told = words[n - 3] " steps, " words[n - 1] " results"
  sub(/, as a run of .*/, "", head)
  gsub(/[^A-Za-z0-9_]/, "_", head)
  if (token[at] !~ /^run_/ || head !~ ("__" substr(token[at], 5) "$"))
    wrong("has " shown() "; expected the instance of the line before it")
  running = name()
  expect(": THEORY BEGIN")

  delete is_type
  delete is_constant
  split("", needed)
  formals = ""
  while ((getline formal < (library "/" automaton ".pvs")) > 0)
    if (formal ~ ("^" automaton " \\[ .* \\]: THEORY$")) formals = formal
  close(library "/" automaton ".pvs")
  sub(/^[^[]*\[ /, "", formals)
  sub(/ \]: THEORY$/, "", formals)
  gsub(/: TYPE|,/, "", formals)
  k = split(formals, words, " ")
  for (i = 1; i <= k; i++) declare(words[i])
  gsub(/ /, " , ", formals)
  expect("IMPORTING " automaton " [ " formals " ]")
  if (has(",")) expect("constantly")

  state(0)
  for (steps = 0; token[at] ~ /^a_/; ) {
    action(++steps)
    state(steps)
  }
  expect("begins : LEMMA start ( s_0 )")
  expect("reached_0 : LEMMA reachable ( s_0 )")
  results = 0
  for (i = 1; i <= steps; i++) {
    k = i - 1
    expect("step_" i " : LEMMA enabled ( a_" i " , s_" k " ) AND trans ( a_" i " , s_" k " ) = s_" i)
    for (k = 1; needed[i] != "" && k == 1 || token[at] ~ /^result_/; k++) {
      result(i, k)
      results++
    }
    expect("reached_" i " : LEMMA reachable ( s_" i " )")
  }
  expect("END " running)
  if (told != steps " steps, " results " results") wrong("has " steps " steps and " results " results; its first line says something else")
  print "run " automaton " " steps
}

/[[:cntrl:]]/ { wrong("has a control character") }
/^ *%/ { # of a comment only the last one before a theory says something
  if (!/^ *%\|-/) comment = $0
  next
}
{
  while (match($0, /^ *([A-Za-z][A-Za-z0-9_]*|[0-9]+|\(#|#\)|:=|[](){}|,=`:[])/)) {
    token[++tokens] = substr($0, 1, RLENGTH)
    gsub(/ /, "", token[tokens])
    line[tokens] = FNR
    before[tokens] = comment
    $0 = substr($0, RLENGTH + 1)
  }
  if (/[^ ]/) wrong("has '" $0 "', which no exported run has")
}

END {
  if (failed) exit
  if (!tokens) wrong("has no theory")
  for (at = 1; at <= tokens; ) theory(before[at])
}
