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
    acts("a", "do_register", "a#1");
    acts("b", "do_register", "b#1");
    sees("a", "1:a#1@1,b#1@1");
    sees("b", "1:a#1@1,b#1@1");
    run.forgetSteps();
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    sees("a", "0:");
    acts("a", "do_register", "a#1");
    sees("a", "1:a#1@1");
    shows("a", "1:[a]");
    sees("b", "1:a#1@1");
    acts("b", "do_register", "b#1");
    sees("b", "2:a#1@1,b#1@2");
    confines("b", "a#1", "A B", "b#1");
    sees("b", "3:b#1@2|a#1@1[A B]");
    acts("b", "unregister", "b#1");
    acts("a", "give_up", "a#1");
    acts("a", "give_up", "a#2"); // has not asked
    assertThat(details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "do_register(a#1)",
            "decide([a#1])",
            "learn(a#1, 1)",
            "rList(a#1) = [a#1]",
            "ts(a#1) = 1",
            "rList(a#1) = 1:[a]",
            "list(1) = [a#1]",
            "do_register(b#1)",
            "learn(b#1, 1)",
            "rList(b#1) = [a#1]",
            "decide([a#1, b#1])",
            "learn(b#1, 2)",
            "rList(b#1) = [a#1, b#1]",
            "confine(a#1)",
            "decide([b#1])",
            "learn(b#1, 3)",
            "rList(b#1) = [b#1]",
            "unregister(b#1)",
            "give_up(a#1)",
            "gone(a#1) = true");
  }

  @Test
  void aListSeenTooEarlyWaitsForLowerNumbers() {
    acts("a", "do_register", "a#1");
    acts("b", "do_register", "b#1");
    sees("a", "2:a#1@1,b#1@2");
    shows("a", "2:[a, b]");
    assertThat(run.steps()).containsExactly("do_register(a#1)", "do_register(b#1)");
    sees("b", "1:a#1@1");
    sees("b", "2:a#1@1,b#1@2");
    assertThat(details()).isEmpty();
    assertThat(run.steps().subList(2, run.steps().size()))
        .containsExactly(
            "decide([a#1])",
            "decide([a#1, b#1])",
            "learn(a#1, 2)",
            "rList(a#1) = [a#1, b#1]",
            "ts(a#1) = 2",
            "rList(a#1) = 2:[a, b]",
            "learn(b#1, 1)",
            "rList(b#1) = [a#1]",
            "learn(b#1, 2)",
            "rList(b#1) = [a#1, b#1]");
  }

  @Test
  void anUnseenNumberRepeatsTheListBefore() {
    aAndBAreIn();
    acts("a", "unregister", "a#1");
    sees("b", "4:b#1@1");
    assertThat(details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "unregister(a#1)",
            "decide([a#1, b#1])",
            "decide([a#1, b#1])",
            "decide([b#1])",
            "learn(b#1, 4)",
            "rList(b#1) = [b#1]");
  }

  @Test
  void aListWithoutAMemberDeviatesEvenIfNumbersAreMissing() {
    aAndBAreIn();
    sees("a", "3:a#1@1");
    assertThat(details())
        .containsExactly(
            Shown.HERE
                + ": decide([a#1]) is not enabled: list(number) minus gone subset L is"
                + " false: list(2) = [a#1, b#1], gone = []");
  }

  @Test
  void anotherRobotCannotUnregisterAMember() {
    aAndBAreIn();
    acts("b", "unregister", "a#1");
    acts("b", "give_up", "a#1");
    confines("b", "a#1", "", "");
    sees("b", "2:b#1@1");
    assertThat(details()).hasSize(1);
  }

  @Test
  void anIdThatNeverAskedOrReturnsDeviates() {
    aAndBAreIn();
    sees("a", "2:a#1@1,b#1@1,c#1@2");
    assertThat(details().get(0)).endsWith("i = c#1, list(1) = [a#1, b#1], asked = [a#1, b#1]");
  }

  @Test
  void anIdThatReturnsToAListDeviates() {
    aAndBAreIn();
    acts("a", "unregister", "a#1");
    sees("b", "2:b#1@1");
    sees("b", "3:a#1@3,b#1@1");
    assertThat(details().get(0)).endsWith("i = a#1, list(2) = [b#1], entered = [a#1, b#1]");
  }

  @Test
  void aListThatDiffersFromTheDecidedOneDeviates() {
    aAndBAreIn();
    sees("b", "2:a#1@1,b#1@1");
    sees("c", "2:a#1@1");
    assertThat(details())
        .containsExactly(Shown.HERE + ": list(2) is [a#1, b#1], but the trace has [a#1]");
  }

  @Test
  void aListShownUnderAnotherNumberDeviates() {
    aAndBAreIn();
    shows("b", "0:[a, b]");
    assertThat(details()).containsExactly(Shown.HERE + ": ts(b#1) is 1, but the trace has 0");
  }

  @Test
  void aLongRunForgetsOldListsAndChecksNewOnes() {
    acts("a", "do_register", "a#1");
    for (int number = 1; number <= 2_000; number++) {
      if (number % 3 > 0) {
        sees("a", number + ":a#1@1");
      }
    }
    sees("b", "3:"); // too old to be compared
    assertThat(run.report().holds()).isTrue();
    sees("b", "1990:");
    assertThat(details()).hasSize(1);
  }
}
