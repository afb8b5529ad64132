package org.starl.lang.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.lang.check.Finding;
import org.starl.lang.check.Search;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.java.JavaSources;
import org.starl.lang.prove.Claim;
import org.starl.lang.prove.Claim.Verdict;
import org.starl.lang.prove.Prover;
import org.starl.lang.pvs.PvsTheory;
import org.starl.lang.tree.Automaton;

/** Programs, above all those of {@code docs/language.md}. */
class ProgramsTest {

  private static final Pattern BLOCK = Pattern.compile("\n```\n(.*?)```", Pattern.DOTALL);
  private static final Pattern ROW =
      Pattern.compile("\n\\| `([^`]*)` \\| `([^`]*)` \\| `(\\d+:\\d+: [^`]*)` \\|");
  private static final Pattern JAVA_LINES =
      Pattern.compile("\n((?:    java .*\n)+)\n`starl compile crossing\\.starl --java");
  private static final int MOST_STATES = 1_000_000;
  private static final long LIMIT = 10_000_000;

  private static String manual() throws IOException {
    return Files.readString(Path.of("../docs/language.md"));
  }

  /** The block of code of the manual that begins so. */
  private static String block(String beginning) throws IOException {
    return BLOCK
        .matcher(manual())
        .results()
        .map(found -> found.group(1))
        .filter(text -> text.startsWith(beginning))
        .findFirst()
        .orElseThrow();
  }

  /** The program of the manual, as it is first. */
  private static String crossing() throws IOException {
    return block("// Cars cross a bridge");
  }

  /** The program of the manual that is safe. */
  private static String safe() throws IOException {
    return crossing().replace("when reg.registered do", "when reg.registered and way != {} do");
  }

  static Stream<Arguments> wrongPrograms() throws IOException {
    List<MatchResult> rows = ROW.matcher(manual()).results().toList();
    assertThat(rows).hasSizeGreaterThan(10);
    return rows.stream().map(row -> Arguments.of(row.group(1), row.group(2), row.group(3)));
  }

  @ParameterizedTest
  @MethodSource("wrongPrograms")
  void wrongProgramIsToldAsTheManualSays(String right, String wrong, String error)
      throws IOException {
    assertThat(crossing()).contains(right);
    String text = crossing().replaceFirst(Pattern.quote(right), wrong);
    SourceErrors told =
        catchThrowableOfType(
            SourceErrors.class, () -> new SourceReader().read("crossing.starl", text));
    assertThat(told).hasMessage("crossing.starl:" + error);
  }

  private static Automaton read(String text) throws SourceErrors {
    return new SourceReader().read("crossing.starl", text).getLast();
  }

  private static Search.Result search(String text, int zones) throws SourceErrors {
    Map<String, Integer> opaque = new LinkedHashMap<>();
    opaque.put("PIDS", 2);
    opaque.put("Zones", zones);
    opaque.put("Places", 1);
    Sizes sizes = new Sizes(opaque, 2, 2);
    return new Search(new Machine(read(text), sizes), sizes, Map.of(), true, MOST_STATES).run();
  }

  @Test
  void crossingOfTheManualIsSafe() throws IOException, SourceErrors {
    Search.Result result = search(safe(), 2);
    assertThat(result.finding()).isEmpty();
    assertThat(result.isComplete()).isTrue();
    assertThat(result.never()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          ' and way != {}' | '' | reg_wait_may_do_mutex | 20:46
          mux.release(way); reg | reg | reg_wait_may_do_mutex | 20:60
          reg.unregister(); goto leaving | goto S0 | S0_may_do_register | 17:6
          reg.unregister(); goto leaving | restart | restart_leaves_reg | 21:22
          when mux.crit do | when plist != {} do | move_wait_may_release | 28:21
          """)
  void wrongCallIsFoundWhereItStands(String right, String wrong, String invariant, String pos)
      throws IOException, SourceErrors {
    String text = safe().replace(right, wrong);
    if (!text.contains("goto leaving")) {
      // A location that no branch leads to is an error of its own.
      text = text.replaceAll("location leaving\n.*\n", "");
    }
    Finding finding = search(text, 1).finding().orElseThrow();
    assertThat(finding.name()).isEqualTo(invariant);
    assertThat(finding.pos()).hasToString(pos);
  }

  @Test
  void whatThePrimitiveAsksIsTold() throws IOException, SourceErrors {
    assertThat(search(crossing(), 1).finding().orElseThrow().message())
        .isEqualTo(
            "false for self = bot0: mux.do_mutex(bot0, {}) is not enabled:"
                + " 'RS != {}' is false");
  }

  @Test
  @Tag("long")
  void crossingOfTheManualIsProvedForAnyNumberOfCars() throws IOException, SourceErrors {
    Automaton crossing = read(safe() + block("// Only at these locations"));
    assertThat(new Prover(crossing, LIMIT, (title, text) -> {}).prove().claims())
        .extracting(Claim::verdict)
        .containsOnly(Verdict.PROVED);
  }

  @Test
  void javaOfTheManualIsThatOfItsProgram() throws IOException, SourceErrors {
    Matcher lines = JAVA_LINES.matcher(manual());
    assertThat(lines.find()).isTrue();
    String head = "program Crossing[Zones]\n";
    String text = safe().replace(head, head + lines.group(1).stripIndent());
    Source source = new SourceReader().look("crossing.starl", text, null);
    assertThat(source.errors()).isEmpty();
    Map<String, String> files = JavaSources.of(source, "crossing.starl");
    assertThat(files.get("crossing/Crossing.java")).contains(java(manual()));
  }

  @Test
  void javaAndTheoryOfTheIntersectionsPageAreThoseOfItsCar() throws IOException {
    Path car =
        Path.of("../starl-apps/src/main/java/org/starl/apps/intersection/logic/IcpProgram.java");
    String page = Files.readString(Path.of("../docs/apps/intersection.md"));
    assertThat(Files.readString(car)).contains(excerpt(page, "java\nswitch ", 6));
    assertThat(Files.readString(Path.of("../pvs/IcpProgram.pvs")))
        .contains(excerpt(page, "\nenabled(a, s): bool =", 2) + "\n  IMPORTING time_machine");
  }

  /** The Java of the manual, indented as in its file. */
  private static String java(String page) {
    return excerpt(page, "java\ncase ", 8);
  }

  /** The excerpt of a page that begins so, indented as in its file. */
  private static String excerpt(String page, String begin, int indent) {
    int at = page.indexOf("\n```" + begin);
    assertThat(at).isNotNegative();
    String text = page.substring(page.indexOf('\n', at + 1) + 1);
    return text.substring(0, text.indexOf("```")).indent(indent).replaceAll("(?m)^ +$", "");
  }

  @Test
  void programIsTheAutomatonOfAllProcesses() throws SourceErrors {
    Automaton made =
        read(
            """
            // Takes turns.
            program Turns[Zones]
            given name: Text, way: set[Zones]
            uses mux: FixedMutex(name)
            state
              n: nat := 0   // turns
              m: nat := 1
            location out
              when way != {} do n := n + 1; m := n + m; mux.do_mutex(way); goto waiting
            location waiting
              when mux.crit and n > 1 do n := m; m := n; goto inside
              when mux.crit do goto inside
              when mux.failed and n > 0 do restart
            location inside
              do mux.release(mux.held); goto out
            invariant Counts: forall i: PIDS :: loc(i) = inside => n(i) > 0
            """);
    Automaton byHand =
        read(
            """
            // Takes turns.
            automaton Turns[PIDS, Zones, way: [PIDS -> set[Zones]]]
            type Location = out | waiting | inside | over
            state
              loc: [PIDS -> Location]
              n: [PIDS -> nat]   // turns
              m: [PIDS -> nat]
            uses mux: Mutex_decls[PIDS, Zones]
            start
              forall self: PIDS :: loc(self) = out,
              forall self: PIDS :: n(self) = 0,
              forall self: PIDS :: m(self) = 1,
              mux.start?
            action out_to_waiting(self: PIDS)
              pre loc(self) = out, way(self) != {}
              eff loc(self) := waiting, n(self) := n(self) + 1, m(self) := (n(self) + 1) + m(self),
                mux.do_mutex(self, way(self))
            action waiting_to_inside(self: PIDS)
              pre loc(self) = waiting, mux.crit_set(self) != {} and n(self) > 1
              eff loc(self) := inside, n(self) := m(self), m(self) := m(self)
            action waiting_to_inside_2(self: PIDS)
              pre loc(self) = waiting, not (mux.crit_set(self) != {} and n(self) > 1),
                mux.crit_set(self) != {}
              eff loc(self) := inside
            action waiting_restarts(self: PIDS)
              pre loc(self) = waiting, mux.withdraw(self), n(self) > 0
              eff loc(self) := over, mux.withdraw(self)
            action inside_to_out(self: PIDS)
              pre loc(self) = inside
              eff loc(self) := out, mux.release(self, mux.crit_set(self))
            action mux_od_mutex(i: PIDS, RS: Zoneset)
              pre mux.od_mutex(i, RS)
              eff mux.od_mutex(i, RS)
            // What two processes hold, their bodies' rests included, is disjoint.
            invariant mux_Exclusive:
              forall i, j: PIDS :: not i = j => mux.held(i) disjoint mux.held(j)
            // The same, zone by zone: no zone has two holders.
            invariant mux_Inv_owner:
              forall i, j: PIDS, z: Zones :: z in mux.held(i) and z in mux.held(j) => i = j
            // The paper's form (Figure 6, Inv_mux_safety): the critical sets are disjoint.
            invariant mux_Inv_safety:
              forall i, j: PIDS :: not i = j => mux.crit_set(i) disjoint mux.crit_set(j)
            // A program holds zones or waits for zones, never both.
            invariant mux_Inv_phase:
              forall i: PIDS :: mux.crit_set(i) = {} or mux.req_set(i) = {}
            // mux.do_mutex(way)
            invariant out_may_do_mutex:
              forall self: PIDS :: loc(self) = out and way(self) != {} => mux.do_mutex(self, way(self))
            // mux.release(mux.held)
            invariant inside_may_release:
              forall self: PIDS :: loc(self) = inside =>
                mux.crit_set(self) != {} and mux.release(self, mux.crit_set(self))
            invariant restart_leaves_mux:
              forall self: PIDS :: loc(self) = over =>
                mux.crit_set(self) = {} and mux.req_set(self) = {}
            invariant Counts: forall i: PIDS :: loc(i) = inside => n(i) > 0
            """);
    assertThat(PvsTheory.of(made, "x")).isEqualTo(PvsTheory.of(byHand, "x"));
  }

  @Test
  void primitiveWithoutItsAutomatonIsTold() {
    SourceErrors told =
        catchThrowableOfType(
            SourceErrors.class,
            () ->
                new SourceReader()
                    .read(
                        "lamp.starl",
                        "primitive Lamp is Lmp program P location here do b.c(); goto here"));
    assertThat(told.errors())
        .extracting(SourceError::toString)
        .containsExactly(
            "lamp.starl:1:19: automaton 'Lmp' is not known; expected it before this primitive, in"
                + " Lmp.starl beside this file, or one of StarL's own",
            "lamp.starl:1:50: 'b' is no primitive here; expected a declaration of it before");
  }

  @Test
  void primitiveOfASourceIsUsedLikeStarls() throws SourceErrors {
    Automaton made =
        read(
            """
            automaton Lamp_decls[PIDS]
            state on: set[PIDS]
            start on = {}
            action light(i: PIDS) pre not i in on eff on := on union {i}
            action fade(i: PIDS) eff on := on minus {i}
            primitive Lamp is Lamp_decls
              java "a.Lamp" = "new a.Lamp()"
              action light = light(self) java "light()"
              fun isOn: bool = self in on java "isOn()"
              do fade
            program Signal
            given name: Text
            uses lamp: Lamp
            location dark
              when not lamp.isOn do lamp.light(); goto dark
            """);
    assertThat(made.actions())
        .extracting(action -> action.name())
        .containsExactly("dark_to_dark", "lamp_fade");
    assertThat(made.typeParameters()).containsExactly("PIDS");
    assertThat(made.valueParameters()).isEmpty();
  }
}
