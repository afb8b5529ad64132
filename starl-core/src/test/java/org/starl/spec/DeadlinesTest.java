package org.starl.spec;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Fault;

class DeadlinesTest {

  private static final RobotId A = new RobotId("a");
  private static final ProcessKey KEY = new ProcessKey(Instance.of("x", "y"), A);

  private final Deadlines deadlines = new Deadlines("x.Told", 100, since -> "late");
  private final FaultState faults = new FaultState();
  private final List<String> told = new ArrayList<>();

  private final Monitor.Report report =
      new Monitor.Report() {
        @Override
        public void checked(String lemma) {
          told.add("checked");
        }

        @Override
        public void violated(String lemma, long timeNs, List<RobotId> robots, String detail) {
          told.add(detail);
        }
      };

  @BeforeEach
  void requirePatience() {
    deadlines.setLeast(50);
  }

  @Test
  void aWaitThatIsGivenUpBeforeTheLeastTimeIsAViolationOnce() {
    deadlines.start(KEY, 10);
    deadlines.giveUp(KEY, 59, faults, report);
    deadlines.giveUp(KEY, 59, faults, report);
    assertThat(told).containsExactly("checked", "x/y: gives up after 49 ns");
  }

  @Test
  void theLeastTimeIsInTimeAndCountsWhileTheDeadlineIsSuspended() {
    deadlines.start(KEY, 10);
    deadlines.assume(KEY, false, 20);
    deadlines.assume(KEY, true, 55);
    deadlines.giveUp(KEY, 60, faults, report);
    assertThat(told).containsExactly("checked");
  }

  @Test
  void aWaitThatHasSucceededIsNotGivenUp() {
    deadlines.start(KEY, 10);
    deadlines.meet(KEY, report);
    deadlines.giveUp(KEY, 20, faults, report);
    assertThat(told).containsExactly("checked");
  }

  @Test
  void byAClockThatRanWrongMeanwhileNothingIsTooEarly() {
    faults.observe(new Fault(20, A, Fault.BEGIN, "drift", "drift(a,1000ppm)"));
    faults.observe(new Fault(30, A, Fault.END, "drift", "drift(a,1000ppm)"));
    for (long sinceNs : new long[] {10, 25, 30, 31}) {
      deadlines.start(KEY, sinceNs);
      deadlines.giveUp(KEY, 40, faults, report);
    }
    assertThat(told)
        .containsExactly("checked", "checked", "checked", "checked", "x/y: gives up after 9 ns");
  }

  @Test
  void ofRunsInRealTimeNoClockIsKnownToBeRight() {
    assertThat(faults.isClockRight(A, 0)).isTrue();
    faults.observe(new Fault(5, new RobotId("b"), Fault.BEGIN, "skew", "skew(b,1s)"));
    assertThat(faults.isClockRight(A, 0)).isTrue();
    faults.observe(Fault.realTime(6));
    assertThat(faults.isClockRight(A, 7)).isFalse();
  }
}
