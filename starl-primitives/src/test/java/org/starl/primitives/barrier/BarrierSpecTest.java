package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

class BarrierSpecTest {

  private static final String SOURCE = "barrier/x";
  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");

  private Monitors monitors = new Monitors(List.of(new BarrierSpec(100, 300)));
  private long nowNs;

  BarrierSpecTest() {
    begin();
  }

  private void begin() {
    for (RobotId robot : List.of(A, B, C)) {
      act(robot, "Barrier", robot + "#1", "a#1", "b#1", "c#1");
    }
  }

  @Test
  void aBarrierThatAllPassHolds() {
    allArrive(1);
    allTold("1:passed", 20);
    assertThat(monitors.report().holds()).as("%s", monitors.report()).isTrue();
    assertThat(monitors.report().checks(BarrierSpec.NO_EARLY)).isEqualTo(3);
    assertThat(monitors.report().checks(BarrierSpec.NOT_HUNG)).isEqualTo(3);
  }

  @Test
  void passingBeforeAMemberHasArrivedViolatesNoEarly() {
    arrive(A, 1);
    arrive(B, 1);
    told(A, "1:passed", 20);
    assertThat(monitors.report().violations(BarrierSpec.NO_EARLY)).isEqualTo(1);
  }

  @Test
  void anArrivalCountsOnlyForItsGeneration() {
    allArrive(1);
    allTold("1:passed", 20);
    arrive(A, 2);
    told(A, "2:passed", 30);
    assertThat(monitors.report().violations(BarrierSpec.NO_EARLY)).isEqualTo(1);
  }

  @Test
  void anExcludedMemberNeedNotArrive() {
    arrive(A, 1);
    arrive(B, 1);
    told(A, "1:failed[c#1]", 20);
    told(B, "1:failed[c#1]", 20);
    arrive(A, 2);
    arrive(B, 2);
    told(A, "2:passed", 30);
    arrive(C, 1);
    told(C, "1:excluded", 40);
    assertThat(monitors.report().holds()).as("%s", monitors.report()).isTrue();
  }

  @Test
  void passedAndFailedViolateUniform() {
    allArrive(1);
    told(A, "1:passed", 20);
    told(B, "1:failed[c#1]", 20);
    assertThat(monitors.report().violations(BarrierSpec.UNIFORM)).isEqualTo(1);
  }

  @Test
  void failedWithDifferentMissingMembersViolatesUniform() {
    arrive(A, 1);
    arrive(B, 1);
    told(A, "1:failed[c#1]", 20);
    told(B, "1:failed[a#1, c#1]", 20);
    assertThat(monitors.report().violations(BarrierSpec.UNIFORM)).isEqualTo(1);
  }

  @Test
  void excludedAndPassedViolateUniformInEitherOrder() {
    allArrive(1);
    told(A, "1:passed", 20);
    told(B, "1:excluded", 20);
    allArrive(2);
    told(C, "2:excluded", 30);
    told(A, "2:passed", 30);
    assertThat(monitors.report().violations(BarrierSpec.UNIFORM)).isEqualTo(2);
  }

  @Test
  void unknownEndsTheWaitWithoutAClaim() {
    arrive(A, 1);
    told(A, "1:unknown", 50);
    monitors.finish(1_000);
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void waitingWithoutAbsentMembersViolatesNotHung() {
    allArrive(1);
    told(A, "1:passed", 20);
    monitors.finish(101);
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(2);
  }

  @Test
  void waitingForALiveMemberIsAllowedUntilTheDeadlines() {
    arrive(A, 1);
    see(new Variable(300, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
    monitors.finish(301);
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(1);
  }

  @Test
  void theCrashOfTheLastAbsentMemberStartsTheBound() {
    arrive(A, 1);
    arrive(B, 1);
    fault(C, Fault.CRASH, 150);
    see(new Variable(250, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
    monitors.finish(251);
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(2);
  }

  @Test
  void duringFaultsOrWithoutAMajorityOnlyTheDeadlinesCount() {
    allArrive(1);
    fault(Fault.WORLD, Fault.BEGIN, 50);
    fault(Fault.WORLD, Fault.END, 160);
    fault(B, Fault.CRASH, 170);
    fault(C, Fault.CRASH, 170);
    see(new Variable(300, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
    monitors.finish(301);
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(1);
  }

  @Test
  void aRobotIsOneAcceptorThoughAnEarlierProcessOfItIsAMember() {
    String other = SOURCE + "2";
    List<String> members = List.of("a#1", "a#2", "b#1", "c#1", "d#1");
    for (String id : List.of("a#2", "b#1")) {
      RobotId robot = new RobotId(id.substring(0, 1));
      see(new Action(0, robot, other, "Barrier", join(id, members)));
      see(new Action(0, robot, other, "arrive", List.of("1", id)));
    }
    see(new Variable(300, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
  }

  @Test
  void inACalmWorldARobotIsToldSoonAfterTheLastArrival() {
    monitors = new Monitors(List.of(new BarrierSpec(100, 300, 10)));
    begin();
    arrive(A, 1);
    arrive(B, 1);
    see(new Variable(20, A, "app", "loc", "x"));
    nowNs = 50;
    arrive(C, 1);
    see(new Variable(60, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
    see(new Variable(61, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(3);
  }

  @Test
  void inACalmWorldHalfOfTheMembersNeedNotDecideSoon() {
    monitors = new Monitors(List.of(new BarrierSpec(100, 300, 10)));
    for (RobotId robot : List.of(A, B)) {
      act(robot, "Barrier", robot + "#1", "a#1", "b#1", "c#1", "d#1");
      arrive(robot, 1);
    }
    // Robots c and d have restarted, and know nothing of this barrier.
    act(C, "arrive", "1", "c#1");
    act(new RobotId("d"), "arrive", "1", "d#1");
    see(new Variable(61, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
  }

  @Test
  void soonAfterAFaultARobotMayWaitForTheWholeBound() {
    monitors = new Monitors(List.of(new BarrierSpec(100, 300, 10)));
    fault(A, Fault.CRASH, 5);
    fault(A, Fault.RESTART, 5);
    begin();
    allArrive(1);
    see(new Variable(105, A, "app", "loc", "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
  }

  private static List<String> join(String first, List<String> others) {
    return Stream.concat(Stream.of(first), others.stream()).toList();
  }

  private void allArrive(long generation) {
    for (RobotId robot : List.of(A, B, C)) {
      arrive(robot, generation);
    }
  }

  private void allTold(String outcome, long atNs) {
    for (RobotId robot : List.of(A, B, C)) {
      told(robot, outcome, atNs);
    }
  }

  private void arrive(RobotId robot, long generation) {
    act(robot, "arrive", String.valueOf(generation), robot + "#1");
  }

  private void act(RobotId robot, String name, String... args) {
    see(new Action(nowNs, robot, SOURCE, name, List.of(args)));
  }

  private void told(RobotId robot, String outcome, long atNs) {
    nowNs = atNs;
    see(new Variable(nowNs, robot, SOURCE, "outcome", outcome));
  }

  private void fault(RobotId robot, String name, long atNs) {
    nowNs = atNs;
    see(new Fault(nowNs, robot, name, ""));
  }

  private void see(TraceEvent event) {
    monitors.observe(event);
  }
}
