package org.starl.lang.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Refinement;

/** What is wrong with {@code refines} is told in one line. */
class RefinementReaderTest {

  private static final String LIFT =
      """
      automaton Door[PIDS, last: nat]
      type Way = open | closed
      state
        is_at: Way
        by: option[PIDS]
      start is_at = closed, by = none
      action turn(i: PIDS, to_: Way)
        eff is_at := to_, by := some(i)
      automaton Lift[PIDS, last: nat]
      type Way = open | closed
      state
        way: Way
        at: nat
      start way = closed, at = 0
      refines door: Door[PIDS, last] by
        is_at := match way { open -> open, closed -> closed },
        by := none,
        move(i, n) is nothing,
        use(i) is if at = 0 then turn(i, open) else turn(i, closed)
      action move(i: PIDS, n: nat)
        eff at := n
      action use(i: PIDS)
        eff way := open
      """;

  private static SourceErrors errors(String text) {
    return catchThrowableOfType(
        SourceErrors.class, () -> new SourceReader().read("lift.starl", text));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          by := none, ~ ~ 15:1: 'by' of Door has no value; expected 'by := ...', of type option[PIDS]
          by := none ~ bye := none ~ 17:3: 'bye' is no component of Door; expected one of is_at, by; is it by?
          by := none ~ by := at ~ 17:9: 'at' is of type nat; expected option[PIDS]
          by := none ~ by := nowhere ~ 17:9: 'nowhere' is not known here; expected one of some, the, head, tail, length, card, elements, distinct, last, way, at, open, closed
          by := none ~ by := none, by := none ~ 17:15: 'by' has two values; expected one
          by := none ~ by.x := none ~ 17:6: 'by' of Door is no used automaton; expected ':='
          match way { open -> open, closed -> closed } ~ way ~ 16:12: 'way' is of type Way of Lift; expected Way of Door
          Door[PIDS, last] by ~ Doors[PIDS, last] by ~ 15:15: automaton 'Doors' is not known; expected it before this one, or in Doors.starl beside this file
          Door[PIDS, last] by ~ Lift[PIDS, last] by ~ 15:15: 'Lift' is or needs this automaton; expected no circle
          Door[PIDS, last] by ~ Door[PIDS] by ~ 15:1: 'Door[PIDS]' renames parameters; expected Door[PIDS, last]
          Lift[PIDS, last: nat] ~ Lift[PIDS] ~ 15:1: 'last' of Door is no parameter of Lift; expected last: nat in [ ] after its name
          Lift[PIDS, last: nat] ~ Lift[PIDS, last: int] ~ 15:1: 'last' of Door is no parameter of Lift; expected last: nat in [ ] after its name
          refines door: ~ refines way: ~ 15:9: 'way' is a component of the state already; expected a new name
          move(i, n) is ~ mov(i, n) is ~ 18:3: 'mov' is no action of Lift; expected one of move, use; is it move?
          move(i, n) is ~ move(n, i) is ~ 18:3: 'move' has other parameters; expected move(i, n)
          move(i, n) is ~ move is ~ 18:3: 'move' has other parameters; expected move(i, n)
          move(i, n) is nothing ~ move(i, n) is nothing, move(i, n) is nothing ~ 18:26: 'move' is here twice; expected one line for it
          is nothing ~ is turn(i) ~ 18:17: 'turn' has 1 arguments here; expected 2: i: PIDS, to_: Way
          is nothing ~ is turn(i, at) ~ 18:25: 'at' is of type nat; expected Way
          is nothing ~ is move(i, n) ~ 18:17: 'move' is no action of Door; expected one of [turn]
          is nothing ~ is if at then nothing ~ 18:20: 'at' is of type nat; expected bool
          is nothing, ~ is nothing ~ 19:3: found 'use'; expected ',' before a further condition or effect, or the next declaration or branch
          refines door: Door[ ~ refines Door[ ~ 15:13: found '['; expected ':' and an automaton after its name here, as in 'm: Mutex_decls[PIDS, Zones]'
          by := none, ~ by = none, ~ 17:6: found '='; expected ':=' after a component, or 'is' after an action
          is nothing, ~ := nothing, ~ 18:14: found ':='; expected 'is'
          """)
  void mistakeIsTold(String instead, String mistake, String told) {
    assertThat(LIFT).contains(instead);
    String text = LIFT.replace(instead, mistake == null ? "" : mistake);
    assertThat(errors(text).errors()).hasToString("[lift.starl:" + told + "]");
  }

  @Test
  void eachComponentWithoutAValueIsTold() {
    String text = LIFT.replaceAll("(?s)is_at := match.*?by := none,", "");
    assertThat(errors(text).errors())
        .hasToString(
            "[lift.starl:15:1: 'is_at' of Door has no value; expected 'is_at := ...', of type Way,"
                + " lift.starl:15:1: 'by' of Door has no value; expected 'by := ...', of type option[PIDS]]");
  }

  @Test
  void refinementBecomesATree() throws SourceErrors {
    Automaton lift = new SourceReader().read("lift.starl", LIFT).getLast();
    Refinement door = lift.refinements().getFirst();
    assertThat(door.title()).isEqualTo("refinement door");
    assertThat(door.values()).containsOnlyKeys("is_at", "by");
    assertThat(door.steps().get("use")).hasSize(2);
    assertThat(door.steps().get("move")).isEmpty();
    assertThat(lift.component("door")).isEmpty();
    assertThat(lift.refined().component("door")).isPresent();
    assertThat(lift.refined().refined()).isEqualTo(lift.refined());
  }

  @Test
  void circleOfFilesIsTold(@TempDir Path folder) throws IOException {
    for (String[] each : new String[][] {{"A", "B"}, {"B", "A"}}) {
      Files.writeString(
          folder.resolve(each[0] + ".starl"),
          "automaton %s state x: nat start x = 0 refines r: %s by x := x action a eff x := 0"
              .formatted(each[0], each[1]));
    }
    SourceErrors errors =
        catchThrowableOfType(
            SourceErrors.class, () -> new SourceReader().read(folder.resolve("A.starl")));
    assertThat(errors.errors())
        .hasToString(
            "["
                + folder.resolve("B.starl")
                + ":1:49: 'A' is or needs this automaton; expected no circle]");
  }

  @Test
  void usedAutomatonThatIsNotKnownIsToldOnce() {
    assertThat(
            errors("automaton A uses b: B start b.start? action a pre b.a(1) eff b.a(1)").errors())
        .hasToString(
            "[lift.starl:1:21: automaton 'B' is not known; expected it before this one, or in B.starl beside this file]");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          Use[n: nat] ~ 'P' of Low is no parameter of Use; expected an opaque type
          Use[P] ~ 'n' of Low is no parameter of Use; expected n: nat
          Use[P, n: int] ~ 'n' of Low is no parameter of Use; expected n: nat
          """)
  void usedAutomatonHasItsParameters(String head, String told) {
    String text =
        """
        automaton Low[P, n: nat] state x: nat start x = 0 action clear eff x := n
        automaton %s uses low: Low[P, n] start low.start? action clear eff low.clear()
        """;
    int column = 12 + head.length();
    assertThat(errors(text.formatted(head)).errors())
        .hasToString("[lift.starl:2:%d: %s in [ ] after its name]".formatted(column, told));
  }

  @Test
  void programsRefineNothing() {
    String program =
        """
        program P
        refines door: Door by x := 1
        location S
        """;
    assertThat(errors(program).errors())
        .hasToString("[lift.starl:2:1: 'refines' is for automata; expected an invariant here]");
  }

  @Test
  void newWordsMayBeNames() throws SourceErrors {
    assertThat(
            new SourceReader()
                .read(
                    "x",
                    """
                    automaton A state by: nat refines: nat start by = 0, refines = 0
                    action nothing eff by := refines
                    """))
        .hasSize(1);
  }
}
