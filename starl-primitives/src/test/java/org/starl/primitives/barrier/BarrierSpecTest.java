package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.primitives.barrier.Seen.SOURCE;
import static org.starl.primitives.barrier.Seen.excluded;
import static org.starl.primitives.barrier.Seen.failed;
import static org.starl.primitives.barrier.Seen.passed;
import static org.starl.primitives.barrier.Seen.unknown;
import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodTiming;
import org.starl.primitives.agreement.Value;
import org.starl.shape.Shapes;
import org.starl.spec.Monitors;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

class BarrierSpecTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");
  private static final Var<String> LOC = Var.of("loc", Shapes.TEXT);

  private Monitors monitors = new Monitors(List.of(new BarrierSpec(100, 300)));
  private long nowNs;

  BarrierSpecTest() {
    begin();
  }

  private void begin() {
    for (RobotId robot : List.of(A, B, C)) {
      see(Seen.exists(nowNs, SOURCE, robot + "", "a", "b", "c"));
    }
  }

  @Test
  void aBarrierThatAllPassHolds() {
    allArrive(1);
    allTold(passed(1), 20);
    assertThat(monitors.report().holds()).as("%s", monitors.report()).isTrue();
    assertThat(monitors.report().checks(BarrierSpec.NO_EARLY)).isEqualTo(3);
    assertThat(monitors.report().checks(BarrierSpec.NOT_HUNG)).isEqualTo(3);
  }

  @Test
  void passingBeforeAMemberHasArrivedViolatesNoEarly() {
    arrive(A, 1);
    arrive(B, 1);
    told(A, passed(1), 20);
    assertThat(monitors.report().violations(BarrierSpec.NO_EARLY)).isEqualTo(1);
  }

  @Test
  void anArrivalCountsOnlyForItsGeneration() {
    allArrive(1);
    allTold(passed(1), 20);
    arrive(A, 2);
    told(A, passed(2), 30);
    assertThat(monitors.report().violations(BarrierSpec.NO_EARLY)).isEqualTo(1);
  }

  @Test
  void anExcludedMemberNeedNotArrive() {
    arrive(A, 1);
    arrive(B, 1);
    told(A, failed(1, "c"), 20);
    told(B, failed(1, "c"), 20);
    arrive(A, 2);
    arrive(B, 2);
    told(A, passed(2), 30);
    arrive(C, 1);
    told(C, excluded(1), 40);
    assertThat(monitors.report().holds()).as("%s", monitors.report()).isTrue();
  }

  @Test
  void passedAndFailedViolateUniform() {
    allArrive(1);
    told(A, passed(1), 20);
    told(B, failed(1, "c"), 20);
    assertThat(monitors.report().violations(BarrierSpec.UNIFORM)).isEqualTo(1);
  }

  @Test
  void failedWithDifferentMissingMembersViolatesUniform() {
    arrive(A, 1);
    arrive(B, 1);
    told(A, failed(1, "c"), 20);
    told(B, failed(1, "a", "c"), 20);
    assertThat(monitors.report().violations(BarrierSpec.UNIFORM)).isEqualTo(1);
  }

  @Test
  void excludedAndPassedViolateUniformInEitherOrder() {
    allArrive(1);
    told(A, passed(1), 20);
    told(B, excluded(1), 20);
    allArrive(2);
    told(C, excluded(2), 30);
    told(A, passed(2), 30);
    assertThat(monitors.report().violations(BarrierSpec.UNIFORM)).isEqualTo(2);
  }

  @Test
  void unknownEndsTheWaitWithoutAClaim() {
    arrive(A, 1);
    told(A, unknown(1), 50);
    monitors.finish(1_000);
    assertThat(monitors.report().holds()).isTrue();
  }

  /** A silence of 2 ms, a deadline of 3 ms. */
  private void bePatient() {
    BarrierSettings settings = new BarrierSettings(SynodTiming.DEFAULT, 1, 1, 2, 3);
    BarrierSpec spec = new BarrierSpec(10 * NS_PER_MS, 10 * NS_PER_MS);
    monitors = new Monitors(List.of(spec.patient(settings)));
    begin();
  }

  @Test
  void givingUpAMemberBeforeItsSilenceOrTheDeadlineViolatesSuspected() {
    for (long[] heardAndGivenUpUs : new long[][] {{500, 2_500}, {500, 2_499}, {2_000, 3_000}}) {
      nowNs = 0;
      bePatient();
      arrive(A, 1);
      see(Seen.hears(heardAndGivenUpUs[0] * 1_000, A, "c", 1));
      see(Seen.proposes(heardAndGivenUpUs[1] * 1_000, A, Seen.ids("a", "b", "c"), 1, "c"));
      see(Seen.proposes(heardAndGivenUpUs[1] * 1_000, B, Seen.ids("a", "b", "c"), 1, "c"));
      assertThat(monitors.report().violations(BarrierSpec.SUSPECTED))
          .isEqualTo(heardAndGivenUpUs[1] == 2_499 ? 1 : 0);
    }
  }

  @Test
  void anArrivalWithoutAnAnswerViolatesBehind() {
    BarrierMessage heard = new BarrierMessage.Arrival(ProcessId.parse("c"), 2);
    BarrierMessage here = new BarrierMessage.Here(ProcessId.parse("a"), 2, false, 2);
    assertThat(behind(heard, Seen.tells(5, A, "c", here))).isZero();
    assertThat(behind(heard, Seen.tells(5, A, "c", decided()))).isZero();
    assertThat(behind(heard, Seen.tells(5, A, "b", here))).isEqualTo(1);
    assertThat(behind(heard, Seen.tells(6, A, "c", here))).isEqualTo(1);
    BarrierMessage untrue = new BarrierMessage.Here(ProcessId.parse("a"), 2, true, 2);
    assertThat(behind(heard, Seen.tells(5, A, "c", untrue))).as("not arrived").isEqualTo(1);
  }

  @Test
  void aMemberThatIsBehindAndIsNotToldViolatesBehind() {
    BarrierMessage heard = new BarrierMessage.Here(ProcessId.parse("c"), 1, false, 1);
    assertThat(behind(heard, Seen.tells(5, A, "c", decided()))).isZero();
    assertThat(behind(heard, Seen.tells(5, A, "b", decided()))).isEqualTo(1);
    BarrierMessage level = new BarrierMessage.Here(ProcessId.parse("c"), 2, false, 1);
    assertThat(behind(level, Seen.tells(5, A, "b", decided()))).isZero();
  }

  @Test
  void aMemberThatIsAheadAndIsNotAskedViolatesBehind() {
    BarrierMessage heard = new BarrierMessage.Arrival(ProcessId.parse("c"), 3);
    BarrierMessage here = new BarrierMessage.Here(ProcessId.parse("a"), 2, false, 3);
    SynodMessage query = new SynodMessage.Query(1);
    Sent answer = Seen.tells(5, A, "c", here);
    assertThat(behind(heard, Seen.tells(5, A, "c", query), answer)).isZero();
    assertThat(behind(heard, answer)).isEqualTo(1);
  }

  private static SynodMessage decided() {
    return new SynodMessage.Decided(1, Value.EMPTY);
  }

  /** A was told that generation 1 is passed. It hears this at 5 ns, and this happens. */
  private long behind(BarrierMessage heard, TraceEvent... then) {
    nowNs = 0;
    bePatient();
    allArrive(1);
    told(A, passed(1), 2);
    see(Seen.hears(5, A, heard));
    for (TraceEvent event : then) {
      see(event);
    }
    see(Seen.tells(9, B, "a", new SynodMessage.Query(1)));
    return monitors.report().violations(BarrierSpec.BEHIND);
  }

  @Test
  void whoDoesNotWaitAndProposesViolatesNotHung() {
    arrive(A, 1);
    see(Seen.proposes(10, A, Seen.ids("a", "b", "c"), 1, "c"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
    told(A, unknown(1), 20);
    see(Seen.proposes(30, A, Seen.ids("a", "b", "c"), 1, "c"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(1);
  }

  @Test
  void anUnknownOutcomeBeforeTwoDeadlinesViolatesNotHung() {
    for (long toldNs : List.of(6 * NS_PER_MS, 6 * NS_PER_MS - 1)) {
      nowNs = 0;
      bePatient();
      arrive(A, 1);
      told(A, unknown(1), toldNs);
      assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG))
          .isEqualTo(6 * NS_PER_MS - toldNs);
    }
  }

  @Test
  void waitingWithoutAbsentMembersViolatesNotHung() {
    allArrive(1);
    told(A, passed(1), 20);
    monitors.finish(101);
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(2);
  }

  @Test
  void waitingForALiveMemberIsAllowedUntilTheDeadlines() {
    arrive(A, 1);
    see(new Variable(300, A, Instance.APP, LOC, "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
    monitors.finish(301);
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(1);
  }

  @Test
  void theCrashOfTheLastAbsentMemberStartsTheBound() {
    arrive(A, 1);
    arrive(B, 1);
    fault(C, Fault.CRASH, 150);
    see(new Variable(250, A, Instance.APP, LOC, "x"));
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
    see(new Variable(300, A, Instance.APP, LOC, "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
    monitors.finish(301);
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(1);
  }

  @Test
  void aRobotIsOneAcceptorThoughAnEarlierProcessOfItIsAMember() {
    Instance other = Instance.of(BarrierFact.PRIMITIVE, "x2");
    for (String id : List.of("a.2", "b")) {
      RobotId robot = new RobotId(id.substring(0, 1));
      see(Seen.exists(0, other, id, "a", "a.2", "b", "c", "d"));
      see(Seen.arrives(0, robot, other, 1, id));
    }
    see(new Variable(300, A, Instance.APP, LOC, "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
  }

  @Test
  void inACalmWorldARobotIsToldSoonAfterTheLastArrival() {
    monitors = new Monitors(List.of(new BarrierSpec(100, 300, 10)));
    begin();
    arrive(A, 1);
    arrive(B, 1);
    see(new Variable(20, A, Instance.APP, LOC, "x"));
    nowNs = 50;
    arrive(C, 1);
    see(new Variable(60, A, Instance.APP, LOC, "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
    see(new Variable(61, A, Instance.APP, LOC, "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isEqualTo(3);
  }

  @Test
  void inACalmWorldHalfOfTheMembersNeedNotDecideSoon() {
    monitors = new Monitors(List.of(new BarrierSpec(100, 300, 10)));
    for (RobotId robot : List.of(A, B)) {
      see(Seen.exists(nowNs, SOURCE, robot + "", "a", "b", "c", "d"));
      arrive(robot, 1);
    }
    // Robots c and d have restarted, and know nothing of this barrier.
    arrive(C, 1);
    arrive(new RobotId("d"), 1);
    see(new Variable(61, A, Instance.APP, LOC, "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
  }

  @Test
  void soonAfterAFaultARobotMayWaitForTheWholeBound() {
    monitors = new Monitors(List.of(new BarrierSpec(100, 300, 10)));
    fault(A, Fault.CRASH, 5);
    fault(A, Fault.RESTART, 5);
    begin();
    allArrive(1);
    see(new Variable(105, A, Instance.APP, LOC, "x"));
    assertThat(monitors.report().violations(BarrierSpec.NOT_HUNG)).isZero();
  }

  private void allArrive(long generation) {
    for (RobotId robot : List.of(A, B, C)) {
      arrive(robot, generation);
    }
  }

  private void allTold(BarrierOutcome outcome, long atNs) {
    for (RobotId robot : List.of(A, B, C)) {
      told(robot, outcome, atNs);
    }
  }

  private void arrive(RobotId robot, long generation) {
    see(Seen.arrives(nowNs, robot, SOURCE, generation, robot + ""));
  }

  private void told(RobotId robot, BarrierOutcome outcome, long atNs) {
    nowNs = atNs;
    see(Seen.shows(nowNs, robot, outcome));
  }

  private void fault(RobotId robot, String name, long atNs) {
    nowNs = atNs;
    see(new Fault(nowNs, robot, name, ""));
  }

  private void see(TraceEvent event) {
    monitors.observe(event);
  }
}
