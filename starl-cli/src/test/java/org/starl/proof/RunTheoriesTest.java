package org.starl.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.TraceLines;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.trace.TraceEvent;

/** The theories of a run; PVS decides whether they can be proved. */
class RunTheoriesTest {

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final RunTheories theories = new RunTheories(out);

  private void acts(String robot, String source, String fact) {
    String json = fact.replace('\'', '"');
    theories.observed(TraceLines.action(1_500_000_000, new RobotId(robot), source, json));
  }

  private void sets(long timeNs, String source, String variable, String value) {
    RobotId robot = new RobotId("b");
    theories.observed(
        TraceLines.variable(timeNs, robot, source, variable, value.replace('\'', '"')));
  }

  private void asks(String robot, String mutex, String... want) {
    acts(
        robot,
        mutex,
        "{'do_mutex':{'who':'%s','num':1,'ts':1,'want':%s,'sequence':[],'resumes':false,'known':[]}}"
            .formatted(robot, sections(want)));
  }

  private void holds(String robot, String mutex, String... held) {
    acts(
        robot,
        mutex,
        "{'od_mutex':{'who':'%s','num':1,'held':%s}}".formatted(robot, sections(held)));
  }

  private static String sections(String... names) {
    return Stream.of(names)
        .sorted()
        .map(name -> "'" + name + "'")
        .collect(Collectors.joining(",", "[", "]"));
  }

  private String text() throws IOException {
    theories.close();
    return out.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aMutexRunIsWrittenStateByStateWithItsObligations() throws IOException {
    asks("bot-1", "mutex/x", "A", "7");
    holds("bot-1", "mutex/x", "A", "7");
    acts("bot-1", "mutex/x", "{'release':{'who':'bot-1','num':1,'given':['A'],'left':['7']}}");
    assertThat(text())
        .isEqualTo(
            """
            % A run: mutex/x, as a run of Mutex_decls: 3 steps, 2 results
            run_mutex_x: THEORY
            BEGIN
              PIDS: TYPE = {bot_1}
              Zones: TYPE = {n7, A}
              % bot_1 is bot-1
              % n7 is 7
              IMPORTING Mutex_decls[PIDS, Zones]

              s_0: states =
                (# crit_set := LAMBDA (i: PIDS): emptyset,
                   req_set := LAMBDA (i: PIDS): emptyset,
                   rest_set := LAMBDA (i: PIDS): emptyset #)

              % 1.500 s bot-1: do_mutex
              a_1: actions = do_mutex(bot_1, {x: Zones | x = n7 OR x = A})
              s_1: states =
                (# crit_set := LAMBDA (i: PIDS): emptyset,
                   req_set := LAMBDA (i: PIDS):
                      IF i = bot_1 THEN {x: Zones | x = n7 OR x = A}
                      ELSE emptyset ENDIF,
                   rest_set := LAMBDA (i: PIDS): emptyset #)

              % 1.500 s bot-1: od_mutex
              a_2: actions = od_mutex(bot_1, {x: Zones | x = n7 OR x = A})
              s_2: states =
                (# crit_set := LAMBDA (i: PIDS):
                      IF i = bot_1 THEN {x: Zones | x = n7 OR x = A}
                      ELSE emptyset ENDIF,
                   req_set := LAMBDA (i: PIDS): emptyset,
                   rest_set := LAMBDA (i: PIDS): emptyset #)

              % 1.500 s bot-1: release
              a_3: actions = release(bot_1, {x: Zones | x = A})
              s_3: states =
                (# crit_set := LAMBDA (i: PIDS):
                      IF i = bot_1 THEN {x: Zones | x = n7}
                      ELSE emptyset ENDIF,
                   req_set := LAMBDA (i: PIDS): emptyset,
                   rest_set := LAMBDA (i: PIDS): emptyset #)

            """
                + lemmas(
                    "begins: LEMMA start(s_0)",
                    "(grind)",
                    "reached_0: LEMMA reachable(s_0)",
                    "(then (lemma \"begins\") (lemma \"reachable_start\" (\"s\" \"s_0\")) (assert))",
                    "step_1: LEMMA enabled(a_1, s_0) AND trans(a_1, s_0) = s_1",
                    stepProof(),
                    "reached_1: LEMMA reachable(s_1)",
                    reachedProof(1),
                    "step_2: LEMMA enabled(a_2, s_1) AND trans(a_2, s_1) = s_2",
                    stepProof(),
                    "result_2: LEMMA s_2`crit_set(bot_1) = {x: Zones | x = n7 OR x = A}",
                    "(grind-with-ext)",
                    "reached_2: LEMMA reachable(s_2)",
                    reachedProof(2),
                    "step_3: LEMMA enabled(a_3, s_2) AND trans(a_3, s_2) = s_3",
                    stepProof(),
                    "result_3: LEMMA s_3`crit_set(bot_1) = {x: Zones | x = n7}",
                    "(grind-with-ext)",
                    "reached_3: LEMMA reachable(s_3)",
                    reachedProof(3))
                + "END run_mutex_x\n");
  }

  private static String lemmas(String... claimsAndProofs) {
    StringBuilder text = new StringBuilder();
    for (int n = 0; n < claimsAndProofs.length; n += 2) {
      String claim = claimsAndProofs[n];
      String name = claim.substring(0, claim.indexOf(':'));
      text.append("\n  ").append(claim).append("\n%|- ").append(name).append(" : PROOF ");
      text.append(claimsAndProofs[n + 1]).append(" QED\n");
    }
    return text.substring(1);
  }

  private static String stepProof() {
    return "(then (split) (grind-with-ext) (case \"x!1 = bot_1\") (grind))";
  }

  private static String reachedProof(int n) {
    int before = n - 1;
    return ("(then (lemma \"reached_" + before + "\") (lemma \"step_" + n + "\") (flatten)")
        + (" (lemma \"reachable_step\" (\"s\" \"s_"
            + before
            + "\" \"a\" \"a_"
            + n
            + "\")) (assert))");
  }

  @Test
  void aRegistrationRunHasItsListsByNumber() throws IOException {
    acts("b", "registration/x", "{'do_register':{'i':'b'}}");
    sets(
        5, "registration/x", "view", "{'number':1,'admitted':[{'key':'b','value':1}],'ghosts':[]}");
    assertThat(text())
        .contains("  IMPORTING Registration_decls[PIDS]\n")
        .contains("  PIDS: TYPE = {b}\n")
        .contains("  a_2: actions = decide({x: PIDS | x = b})\n")
        .contains("  a_3: actions = learn(b, 1)\n")
        .contains(
            """
              s_3: states =
                (# asked := {x: PIDS | x = b},
                   gone := emptyset,
                   entered := {x: PIDS | x = b},
                   number := 1,
                   list := LAMBDA (i: nat):
                      IF i = 1 THEN {x: PIDS | x = b}
                      ELSE emptyset ENDIF,
                   ts := LAMBDA (i: PIDS):
                      IF i = b THEN 1
                      ELSE 0 ENDIF #)
            """)
        .contains("case \"x!1 = s_2`number\"")
        .contains("  result_3: LEMMA rList(b, s_3) = {x: PIDS | x = b}\n");
  }

  /** Each learn has its result, so that its absence shows. */
  @Test
  void aListThatIsKnownBeforeAskingIsAResult() throws IOException {
    acts("b", "registration/x", "{'do_register':{'i':'b'}}");
    sets(
        5, "registration/x", "view", "{'number':1,'admitted':[{'key':'b','value':1}],'ghosts':[]}");
    acts("b", "registration/x", "{'do_register':{'i':'b.2'}}");
    assertThat(text())
        .contains("  a_5: actions = learn(b_2, 1)\n")
        .contains("  result_5: LEMMA rList(b_2, s_5) = {x: PIDS | x = b}\n");
  }

  @Test
  void anAgreementRunHasItsValuesAndTheUndecidedOnes() throws IOException {
    acts("b", "agreement/x", "{'propose':{'i':'b','v':'01ff'}}");
    sets(5, "agreement/x", "decided", "'01ff'");
    sets(6, "agreement/x", "decided", "null");
    assertThat(text())
        .contains("  Values: TYPE = {n01ff}\n")
        .contains("  IMPORTING SetAgreement_decls[PIDS, Values], constantly\n")
        .contains("       decided := constantly(bottom) #)\n")
        .contains("  a_2: actions = choose(n01ff)\n")
        .contains("  a_4: actions = restart(b)\n")
        .contains(
            """
              s_3: states =
                (# proposed := {x: Values | x = n01ff},
                   value := up(n01ff),
                   decided := LAMBDA (i: PIDS):
                      IF i = b THEN up(n01ff)
                      ELSE bottom ENDIF #)
            """)
        .contains("  result_3: LEMMA s_3`decided(b) = up(n01ff)\n");
  }

  @Test
  void anElectionRunHasItsTermsByNumber() throws IOException {
    acts("b", "election/x", "{'Election':{'size':2,'i':'b'}}");
    acts("b", "election/x", "{'do_election':{'i':'b'}}");
    acts("b", "election/x", "{'candidate':{'i':'b','n':1}}");
    sets(5, "election/x", "Leader", "{'Name':{'id':'b','term':1}}");
    assertThat(text())
        .contains("  IMPORTING Election_decls[PIDS], constantly\n")
        .contains("       Leader := constantly((# term := 0, who := bottom #)) #)\n")
        .contains("  a_3: actions = elect(1, b)\n")
        .contains(
            """
              s_4: states =
                (# part := {x: PIDS | x = b},
                   stood := LAMBDA (i: nat):
                      IF i = 1 THEN {x: PIDS | x = b}
                      ELSE emptyset ENDIF,
                   elected := LAMBDA (i: nat):
                      IF i = 1 THEN up(b)
                      ELSE bottom ENDIF,
                   Leader := LAMBDA (i: PIDS):
                      IF i = b THEN (# term := 1, who := up(b) #)
                      ELSE (# term := 0, who := bottom #) ENDIF #)
            """)
        .contains("  result_4: LEMMA s_4`Leader(b) = (# term := 1, who := up(b) #)\n");
  }

  @Test
  void aDeviatingStepIsTheLastOneSoThatPvsRejectsIt() throws IOException {
    asks("b", "mutex/x", "A");
    holds("b", "mutex/x", "B");
    acts("b", "mutex/x", "{'release':{'who':'b','num':1,'given':['B'],'left':[]}}");
    assertThat(text()).contains("step_2: LEMMA enabled(a_2, s_1)").doesNotContain("step_3");
  }

  @Test
  void everyInstanceHasTheRestartAndInstancesAreOrdered() throws IOException {
    acts("b", "mutex/y", "{'stands_in':{'who':'b','sections':[]}}");
    asks("b", "mutex/x", "A");
    theories.observed(new TraceEvent.Fault(7, new RobotId("b"), "restart", ""));
    String text = text();
    assertThat(text).containsSubsequence("run_mutex_x: THEORY", "run_mutex_y: THEORY");
    assertThat(text.split("a_2: actions = restart\\(b\\)", -1)).hasSize(3);
    assertThat(text).contains("  Zones: TYPE = {no_zones}\n");
  }

  @Test
  void everyUsedNameIsDeclared() throws IOException {
    asks("b", "mutex/x", "A", "or-else", "B");
    asks("c", "mutex/x", "true");
    Matcher type = Pattern.compile("TYPE = \\{(.*)}").matcher(text());
    List<String> declared = new ArrayList<>();
    while (type.find()) {
      declared.addAll(List.of(type.group(1).split(", ")));
    }
    assertThat(declared).containsExactly("b", "c", "A", "B", "or_else", "n_true");
    Matcher used =
        Pattern.compile("(?:x|i) = ([A-Za-z0-9_]+)").matcher(out.toString(StandardCharsets.UTF_8));
    TreeSet<String> names = new TreeSet<>();
    while (used.find()) {
      names.add(used.group(1));
    }
    assertThat(declared).containsAll(names);
  }

  /** What {@code pvs/check} says of the text's statements. */
  private String statements(Path folder, String text) throws IOException, InterruptedException {
    Path pvs = Path.of("../pvs").toAbsolutePath().normalize();
    Path file = Files.writeString(folder.resolve("run.pvs"), text);
    Process awk =
        new ProcessBuilder(
                "awk",
                "-v",
                "library=" + pvs,
                "-f",
                pvs.resolve("statements.awk").toString(),
                file.toString())
            .redirectErrorStream(true)
            .start();
    String said = new String(awk.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    awk.waitFor();
    return said.strip();
  }

  @Test
  @Tag("realtime")
  void statementsOfARunAreThoseThatPvsCheckMakesAgain(@TempDir Path folder)
      throws IOException, InterruptedException {
    acts("b", "election/x", "{'Election':{'size':2,'i':'b'}}");
    acts("b", "election/x", "{'do_election':{'i':'b'}}");
    acts("b", "election/x", "{'candidate':{'i':'b','n':1}}");
    sets(5, "election/x", "Leader", "{'Name':{'id':'b','term':1}}");
    asks("b", "mutex/x", "A");
    holds("b", "mutex/x", "A");
    acts("b", "registration/x", "{'do_register':{'i':'b'}}");
    sets(
        5, "registration/x", "view", "{'number':1,'admitted':[{'key':'b','value':1}],'ghosts':[]}");
    sets(5, "registration/x", "rList", "{'Agreed':{'list':['b'],'ts':1}}");
    String text = text();
    assertThat(statements(folder, text))
        .isEqualTo("run Election_decls 4\nrun Mutex_decls 2\nrun Registration_decls 3");
    assertThat(statements(folder, text.replaceFirst("  result_3_2: LEMMA .*\n.*\n\n", "")))
        .contains("has 3 steps and 1 results; its first line says something else");
    assertThat(statements(folder, text.replaceFirst("(result_2: LEMMA (.*) = ).*", "$1$2")))
        .contains("has 's_2'; expected a value of the run");
    assertThat(statements(folder, text.replace("s_0: states =", "enabled: bool = s_0")))
        .contains("wrong ");
    assertThat(statements(folder, text.replace("enabled(a_2, s_1) AND ", ""))).contains("wrong ");
    assertThat(statements(folder, text.replace("reached_2: LEMMA", "reached_2: AXIOM")))
        .contains("wrong ");
    assertThat(statements(folder, text.replaceFirst("  result_4: LEMMA .*\n.*\n\n", "")))
        .contains("has 'reached_4'; expected result_4");
    assertThat(statements(folder, text.replaceFirst("  result_2: LEMMA .*\n.*\n\n", "")))
        .contains("has 'reached_2'; expected result_2");
    assertThat(statements(folder, text.replaceFirst("(result_2: LEMMA .*)", "$1 OR TRUE")))
        .contains("has 'OR'; expected reached_2");
    assertThat(statements(folder, text.replace("  IMPORTING ", "  IMPORTING own, ")))
        .contains("wrong ");
    assertThat(statements(folder, text.replace("= do_mutex(b", "= do_mutex(LET b: PIDS = c IN b")))
        .contains("wrong ");
  }

  @Test
  void aRunWithoutATheoryIsRefused() {
    acts("b", "app", "{'note':{'name':'trip','texts':['A','B']}}");
    assertThatThrownBy(theories::close)
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("--pvs: this run has no primitive with a theory in pvs/: expected");
  }
}
