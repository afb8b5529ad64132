package org.starl.primitives.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;
import org.starl.trace.TraceEvent;

class PrimitivePhasesTest {

  private static final RobotId BOT = new RobotId("bot1");

  private static Phases of(String primitive) {
    return PrimitivePhases.ALL.stream()
        .filter(phases -> phases.primitive().equals(primitive))
        .findFirst()
        .orElseThrow();
  }

  /** The phases after each event: {@code failed=true} for a variable, {@code arrive} for an action. */
  private static List<String> after(String primitive, String... events) {
    Phases phases = of(primitive);
    List<String> after = new ArrayList<>();
    Phases.Step step = phases.steps().get();
    String phase = phases.first();
    for (String text : events) {
      String[] parts = text.split("=", 2);
      TraceEvent event =
          parts.length == 2
              ? new TraceEvent.Variable(0, BOT, primitive + "/x", parts[0], parts[1])
              : new TraceEvent.Action(
                  0,
                  BOT,
                  primitive + "/x",
                  text.split(" ", 2)[0],
                  Arrays.asList(text.split(" ", -1)).subList(1, text.split(" ", -1).length));
      phase = step.after(phase, event);
      assertThat(phases.names()).contains(phase);
      after.add(phase);
    }
    return after;
  }

  @Test
  void eachPrimitiveDeclaresItsPhasesAndSealedMessages() {
    assertThat(PrimitivePhases.ALL)
        .extracting(Phases::primitive)
        .containsExactlyInAnyOrder(
            "agreement",
            "barrier",
            "broadcast",
            "election",
            "geocast",
            "mutex",
            "registration",
            "tubes");
    for (Phases phases : PrimitivePhases.ALL) {
      assertThat(phases.names()).hasSizeGreaterThan(1).doesNotHaveDuplicates();
      assertThat(phases.channels().values()).isNotEmpty().allMatch(Class::isSealed);
    }
  }

  @Test
  void aMutexIsTryingUntilItIsCriticalOrGivesUp() {
    assertThat(
            after(
                "mutex",
                "do_mutex b#1 1 1 A,B b#1",
                "od_mutex b#1 1 A,B",
                "release b#1 1 A B",
                "release b#1 1 B ",
                "do_mutex b#1 2 1 A b#1",
                "withdraw b#1 2 DEADLINE"))
        .containsExactly("TRYING", "CRITICAL", "CRITICAL", "IDLE", "TRYING", "IDLE");
  }

  @Test
  void aRegistrationLeavesWithTheViewWithoutIt() {
    assertThat(
            after(
                "registration",
                "do_register bot1#1",
                "view=1:bot1#1@1",
                "rList=1:[bot1]",
                "rList=null",
                "unregister bot1#1",
                "failed=true",
                "view=2:bot11#1@1"))
        .containsExactly("JOINING", "IN", "IN", "IN", "LEAVING", "LEFT_HALFWAY", "OUT");
    assertThat(after("registration", "do_register bot1#1", "give_up bot1#1", "failed=true"))
        .containsExactly("JOINING", "JOINING", "OUT");
  }

  @Test
  void aBarrierWaitsFromTheArrivalToTheOutcome() {
    assertThat(
            after(
                "barrier",
                "arrive 1 bot1#1",
                "outcome=null",
                "outcome=1:passed",
                "arrive 2 bot1#1",
                "outcome=2:failed[bot2#1]"))
        .containsExactly("WAITING", "WAITING", "PASSED", "WAITING", "FAILED");
  }

  @Test
  void anElectionKnowsALeaderOrWaits() {
    assertThat(
            after(
                "election",
                "Leader=null",
                "do_election bot1#1",
                "Leader=1:bot2#1",
                "Leader=null",
                "Leader=fail"))
        .containsExactly("NO_CANDIDATE", "WAITING", "KNOWS_LEADER", "WAITING", "FAILED");
  }

  @Test
  void anAgreementStaysDecided() {
    assertThat(
            after(
                "agreement",
                "decided=null",
                "propose 0a",
                "failed=true",
                "propose 0a",
                "decided=0a",
                "propose 0b"))
        .containsExactly("IDLE", "PROPOSING", "FAILED", "PROPOSING", "DECIDED", "DECIDED");
  }

  @Test
  void aGeocastIsCastingUntilItsFlagIsTrue() {
    assertThat(after("geocast", "Gcastflag=false", "do_geocast 1", "Gcastflag=true"))
        .containsExactly("IDLE", "CASTING", "IDLE");
    assertThat(after("broadcast", "BCast 1", "copy 1", "Gcastflag=true"))
        .containsExactly("CASTING", "CASTING", "IDLE");
  }

  @Test
  void tubesHaveThePhasesOfTheirFlag() {
    assertThat(after("tubes", "tubeflag=PLANNING", "held=", "tubeflag=DONE"))
        .containsExactly("PLANNING", "PLANNING", "DONE");
  }
}
