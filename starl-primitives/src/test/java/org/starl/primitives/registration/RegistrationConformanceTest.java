package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.registration.RegistrationAutomaton.States;

/** Which events are which actions, line by line of the table; and what is no run of the theory. */
class RegistrationConformanceTest {

  private final ShownRun<States, RegistrationAction> run =
      new ShownRun<>(RegistrationConformance::new);

  private void acts(String robot, String verb, String id) {
    run.has(Shown.acts(0, robot, verb, id));
  }

  private void confines(String robot, String who, String sections, String fencers) {
    run.has(Shown.confines(0, robot, who, sections, fencers));
  }

  private void sees(String robot, String view) {
    run.has(Shown.sees(0, robot, view));
  }

  private void shows(String robot, String list) {
    run.has(Shown.shows(0, robot, list));
  }

  private List<String> details() {
    run.ends(1);
    return run.details();
  }

  private void aAndBAreIn() {
    acts("a", "do_register", "a");
    acts("b", "do_register", "b");
    sees("a", "1:a@1,b@1");
    sees("b", "1:a@1,b@1");
    run.forgetSteps();
  }

  /** A changed message can have any number; a monitor that counts up to it would not end. */
  @Test
  void aViewFarBeyondAllOthersIsADeviation() {
    aAndBAreIn();
    sees("b", "872480271:a@1,b@1");
    assertThat(details())
        .singleElement()
        .asString()
        .contains("number(b) is 2, but the trace has 872480271");
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    sees("a", "0:");
    acts("a", "do_register", "a");
    sees("a", "1:a@1");
    shows("a", "1:[a]");
    sees("b", "1:a@1");
    acts("b", "do_register", "b");
    sees("b", "2:a@1,b@2");
    confines("b", "a", "A B", "b");
    sees("b", "3:b@2|a@1[A B]");
    acts("b", "unregister", "b");
    acts("a", "give_up", "a");
    acts("a", "give_up", "a.2"); // has not asked
    assertThat(details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "do_register(a)",
            "decide([a])",
            "learn(a, 1)",
            "rList(a) = [a]",
            "ts(a) = 1",
            "rList(a) = 1:[a]",
            "list(1) = [a]",
            "do_register(b)",
            "learn(b, 1)",
            "rList(b) = [a]",
            "decide([a, b])",
            "learn(b, 2)",
            "rList(b) = [a, b]",
            "confine(a)",
            "decide([b])",
            "learn(b, 3)",
            "rList(b) = [b]",
            "unregister(b)",
            "give_up(a)",
            "gone(a) = true");
  }

  @Test
  void aListSeenTooEarlyWaitsForLowerNumbers() {
    acts("a", "do_register", "a");
    acts("b", "do_register", "b");
    sees("a", "2:a@1,b@2");
    shows("a", "2:[a, b]");
    assertThat(run.steps()).containsExactly("do_register(a)", "do_register(b)");
    sees("b", "1:a@1");
    sees("b", "2:a@1,b@2");
    assertThat(details()).isEmpty();
    assertThat(run.steps().subList(2, run.steps().size()))
        .containsExactly(
            "decide([a])",
            "decide([a, b])",
            "learn(a, 2)",
            "rList(a) = [a, b]",
            "ts(a) = 2",
            "rList(a) = 2:[a, b]",
            "learn(b, 1)",
            "rList(b) = [a]",
            "learn(b, 2)",
            "rList(b) = [a, b]");
  }

  @Test
  void anUnseenNumberRepeatsTheListBefore() {
    aAndBAreIn();
    acts("a", "unregister", "a");
    sees("b", "4:b@1");
    assertThat(details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "unregister(a)",
            "decide([a, b])",
            "decide([a, b])",
            "decide([b])",
            "learn(b, 4)",
            "rList(b) = [b]");
  }

  @Test
  void aListWithoutAMemberDeviatesEvenIfNumbersAreMissing() {
    aAndBAreIn();
    sees("a", "3:a@1");
    assertThat(details())
        .containsExactly(
            Shown.HERE
                + ": decide([a]) is not enabled: list(number) minus gone subset L is"
                + " false: list(2) = [a, b], gone = []");
  }

  @Test
  void anotherRobotCannotUnregisterAMember() {
    aAndBAreIn();
    acts("b", "unregister", "a");
    acts("b", "give_up", "a");
    confines("b", "a", "", "");
    sees("b", "2:b@1");
    assertThat(details()).hasSize(1);
  }

  @Test
  void anIdThatNeverAskedOrReturnsDeviates() {
    aAndBAreIn();
    sees("a", "2:a@1,b@1,c@2");
    assertThat(details().get(0)).endsWith("i = c, list(1) = [a, b], asked = [a, b]");
  }

  @Test
  void anIdThatReturnsToAListDeviates() {
    aAndBAreIn();
    acts("a", "unregister", "a");
    sees("b", "2:b@1");
    sees("b", "3:a@3,b@1");
    assertThat(details().get(0)).endsWith("i = a, list(2) = [b], entered = [a, b]");
  }

  @Test
  void aListThatDiffersFromTheDecidedOneDeviates() {
    aAndBAreIn();
    sees("b", "2:a@1,b@1");
    sees("c", "2:a@1");
    assertThat(details())
        .containsExactly(Shown.HERE + ": list(2) is [a, b], but the trace has [a]");
  }

  @Test
  void aListShownUnderAnotherNumberDeviates() {
    aAndBAreIn();
    shows("b", "0:[a, b]");
    assertThat(details()).containsExactly(Shown.HERE + ": ts(b) is 1, but the trace has 0");
  }

  @Test
  void aLongRunForgetsOldListsAndChecksNewOnes() {
    acts("a", "do_register", "a");
    for (int number = 1; number <= 2_000; number++) {
      if (number % 3 > 0) {
        sees("a", number + ":a@1");
      }
    }
    sees("b", "3:"); // too old to be compared
    assertThat(run.report().holds()).isTrue();
    sees("b", "1990:");
    assertThat(details()).hasSize(1);
  }
}
