package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.spec.FaultState;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.Note;
import org.starl.trace.TraceEvent;

/** The monitors on handwritten traces, with d1 = 100, d2 = 50, d3 = 10 ns. */
class MutexSpecTest {

  private static final ProcessId I = ProcessId.first(new RobotId("i"), 1);
  private static final ProcessId J = ProcessId.first(new RobotId("j"), 1);
  private static final ProcessId K = ProcessId.first(new RobotId("k"), 1);

  private final Monitors monitors =
      new Monitors(List.of(new MutexSpec(new MutexBounds(100, 50, 10)).only("x")));

  MutexSpecTest() {
    event(0, new MutexFact.Learned(I, View.closed(List.of(I, J, K))));
  }

  @Test
  void aRequestThatGivesUpBeforeItsBoundViolatesServed() {
    ask(0, I, 1, "A");
    event(49, new MutexFact.Withdraw(I, 1, MutexFailure.DEADLINE));
    assertThat(finish(60).violations("mutex.Served")).isEqualTo(1);
  }

  @Test
  void aRequestMayGiveUpAfterItsBoundOrBecauseItsRobotWithdraws() {
    event(0, new MutexFact.Learned(I, View.closed(List.of(I, J, K))));
    monitors.observe(new TraceEvent.Fault(0, TraceEvent.Fault.WORLD, "begin", "loss(1)"));
    ask(0, I, 1, "A");
    event(50, new MutexFact.Withdraw(I, 1, MutexFailure.DEADLINE));
    ask(50, J, 2, "A");
    event(51, new MutexFact.Withdraw(J, 1, MutexFailure.WITHDRAWN));
    assertThat(finish(60).violations()).isEmpty();
  }

  @Test
  void onlyAGhostInTheWayExcusesARequestThatIsToldSo() {
    ask(0, I, 1, "A");
    event(60, new MutexFact.Withdraw(I, 1, MutexFailure.OCCUPIED));
    assertThat(monitors.report().violations("mutex.Served")).isEqualTo(2);
    event(61, new MutexFact.Learned(J, View.closed(List.of(I, J, K)).next().confined(K, set("A"))));
    ask(62, J, 2, "A");
    event(63, new MutexFact.Withdraw(J, 1, MutexFailure.OCCUPIED));
    assertThat(finish(70).violations("mutex.Served")).isEqualTo(2);
  }

  @Test
  void aCalmWorldHasItsOwnBounds() {
    MutexBounds loose = new MutexBounds(100_000, 50_000, 10_000);
    MutexBounds calm = new MutexBounds(100, 50, 10);
    Monitors both = new Monitors(List.of(new MutexSpec(loose, calm)));
    both.observe(action(0, new MutexFact.Learned(I, View.closed(List.of(I, J, K)))));
    both.observe(new TraceEvent.Fault(0, TraceEvent.Fault.WORLD, "begin", "loss(1)"));
    both.observe(new TraceEvent.Fault(1, TraceEvent.Fault.WORLD, "end", "loss(1)"));
    both.observe(action(2, new MutexFact.DoMutex(I, 1, 1, set("A"), ids(I, J, K))));
    both.observe(action(20, new MutexFact.OdMutex(I, 1, set("A"))));
    both.observe(action(21, new MutexFact.Release(I, 1, set("A"), set(""))));
    assertThat(both.report().violations()).isEmpty();
    long settledNs = 2 + FaultState.SETTLE_NS;
    both.observe(action(settledNs, new MutexFact.DoMutex(I, 2, 2, set("A"), ids(I, J, K))));
    both.observe(action(settledNs + 11, new MutexFact.OdMutex(I, 2, set("A"))));
    assertThat(both.report().violations("mutex.NonInterference")).isEqualTo(1);
  }

  @Test
  void theFirstFenceOfALiveParticipantInACalmWorldViolatesServed() {
    MutexBounds bounds = new MutexBounds(100, 50, 10);
    Monitors both = new Monitors(List.of(new MutexSpec(bounds, bounds)));
    both.observe(new TraceEvent.Fault(0, TraceEvent.Fault.WORLD, "begin", "loss(1)"));
    both.observe(action(1, new MutexFact.Fence(I, J, set(""))));
    both.observe(new TraceEvent.Fault(2, TraceEvent.Fault.WORLD, "end", "loss(1)"));
    long calmNs = 2 + FaultState.SETTLE_NS;
    both.observe(action(calmNs, new MutexFact.Fence(K, J, set(""))));
    assertThat(both.report().violations()).isEmpty();
    both.observe(action(calmNs, new MutexFact.Fence(I, K, set(""))));
    assertThat(both.report().violations("mutex.Served")).isEqualTo(1);
  }

  @Test
  void twoHoldersOfOneSectionViolateExclusive() {
    ask(0, I, 1, "A B");
    enter(1, I, "A B");
    ask(2, J, 2, "B C");
    enter(3, J, "B C");
    assertThat(finish(4).violations())
        .extracting(SpecReport.Violation::toString)
        .containsExactly("mutex.Exclusive violated at 0.000 s by i j: j and i both hold B");
  }

  @Test
  void aLongRunKeepsWaitingAndHoldingRequests() {
    ask(0, I, 1, "A");
    enter(1, I, "A");
    ask(2, J, 2, "A");
    event(3, new MutexFact.Grant(K, J, 1));
    for (int i = 0; i < 5_000; i++) {
      ProcessId passer = ProcessId.first(new RobotId("p" + i), 1);
      ask(4, passer, 3, "Z");
      event(4, new MutexFact.Withdraw(passer, 1, MutexFailure.WITHDRAWN));
    }
    // K has consented to J, but comes before it.
    ask(5, K, 1, "A");
    assertThat(monitors.report().violations(MutexSpec.PROMISE)).isEqualTo(1);
    enter(6, J, "A");
    assertThat(finish(7).violations(MutexSpec.EXCLUSIVE)).isEqualTo(1);
  }

  @Test
  void aReleasedSectionIsFree() {
    ask(0, I, 1, "A B");
    enter(1, I, "A B");
    event(2, new MutexFact.Release(I, 1, set("B"), set("A")));
    ask(2, J, 2, "B C");
    enter(3, J, "B C");
    assertThat(finish(4).holds()).isTrue();
  }

  @Test
  void aRobotThatLeavesWithoutReleaseStillHolds() {
    ask(0, I, 1, "A");
    enter(1, I, "A");
    monitors.observe(new TraceEvent.Left(2, I.robot()));
    ask(2, J, 2, "A");
    enter(3, J, "A");
    assertThat(finish(4).violations(MutexSpec.EXCLUSIVE)).isEqualTo(1);
  }

  @Test
  void confiningToLessThanHeldViolatesKept() {
    ask(0, I, 1, "A B");
    enter(1, I, "A B");
    View first = View.closed(List.of(I, J, K)).next();
    event(2, new MutexFact.Learned(J, first.confined(I, set("A B"))));
    assertThat(monitors.report().violations(MutexSpec.KEPT)).isZero();
    event(3, new MutexFact.Learned(J, first.next().confined(I, set("B"))));
    assertThat(finish(4).violations(MutexSpec.KEPT)).isEqualTo(1);
  }

  @Test
  void enteringAfterRemovalViolatesKeptAndWithoutListingViolatesComplete() {
    ask(0, I, 1, "A");
    event(2, new MutexFact.Learned(J, View.closed(List.of(J, K)).next()));
    enter(3, I, "A");
    assertThat(monitors.report().violations(MutexSpec.KEPT)).isEqualTo(1);
    ProcessId stranger = ProcessId.first(new RobotId("l"), 1);
    ask(4, stranger, 2, "B");
    enter(5, stranger, "B");
    assertThat(finish(6).violations(MutexSpec.COMPLETE)).isEqualTo(1);
  }

  @Test
  void sectionsOfACrashedRobotAreFreeAfterStandsIn() {
    ask(0, I, 1, "A B");
    enter(1, I, "A B");
    ProcessId next = ProcessId.first(I.robot(), 2);
    event(2, new MutexFact.StandsIn(next, set("B")));
    ask(3, J, 2, "A");
    enter(4, J, "A");
    assertThat(monitors.report().violations(MutexSpec.EXCLUSIVE)).isZero();
    ask(5, K, 3, "B");
    enter(6, K, "B");
    assertThat(finish(7).violations(MutexSpec.EXCLUSIVE)).isEqualTo(1);
  }

  @Test
  void consentingAndComingFirstViolatesPromise() {
    ask(0, I, 5, "A");
    ask(1, J, 4, "A");
    event(2, new MutexFact.Grant(J, I, 1));
    assertThat(finish(3).violations(MutexSpec.PROMISE)).isEqualTo(1);
  }

  @Test
  void aPromiseIsNotForWhatTheOtherOneHoldsAlready() {
    event(0, new MutexFact.DoMutex(I, 1, 5, set("A B"), List.of("A", "B"), false, ids(I, J, K)));
    enter(1, I, "A");
    ask(2, J, 4, "A");
    event(3, new MutexFact.Grant(J, I, 1));
    assertThat(monitors.report().violations(MutexSpec.PROMISE)).isZero();
    ask(4, K, 3, "B");
    event(5, new MutexFact.Grant(K, I, 1));
    assertThat(finish(6).violations(MutexSpec.PROMISE)).isEqualTo(1);
  }

  @Test
  void aPromiseIsForOneRequestOnlyAlsoIfItIsMadeAnewWithoutAnEnd() {
    event(0, new MutexFact.DoMutex(I, 1, 5, set("A B"), List.of("A", "B"), true, ids(I, J, K)));
    event(1, new MutexFact.Grant(J, I, 1, set("B")));
    event(2, new MutexFact.OdMutex(I, 1, set("A")));
    event(3, new MutexFact.DoMutex(I, 2, 9, set("A B"), List.of("B"), true, ids(I, J, K)));
    event(4, new MutexFact.DoMutex(J, 1, 7, set("B"), List.of("B"), true, ids(I, J, K)));
    event(5, new MutexFact.OdMutex(J, 1, set("B")));
    event(6, new MutexFact.Grant(J, I, 2, set("A")));
    assertThat(monitors.report().violations(MutexSpec.PROMISE)).isZero();
    event(7, new MutexFact.OdMutex(J, 1, set("A B")));
    assertThat(finish(8).violations(MutexSpec.EXCLUSIVE)).isEqualTo(1); // I still holds A
  }

  @Test
  void aLaterRequestWithALowerTimeViolatesPromise() {
    ask(0, I, 5, "A");
    event(1, new MutexFact.Grant(J, I, 1));
    ask(2, J, 4, "A");
    assertThat(finish(3).violations(MutexSpec.PROMISE)).isEqualTo(1);
  }

  @Test
  void aPromiseToARemovedProcessIsVoidButForItsGhost() {
    ask(1, I, 4, "A");
    event(2, new MutexFact.Grant(J, I, 1));
    event(3, new MutexFact.Learned(J, View.closed(List.of(I, J, K)).next().confined(I, set(""))));
    ask(4, J, 5, "A");
    enter(5, J, "A");
    event(6, new MutexFact.Grant(J, I, 1));
    assertThat(finish(7).violations(MutexSpec.PROMISE)).isZero();
  }

  @Test
  void aPromiseToAGhostBinds() {
    ask(1, I, 4, "A");
    event(2, new MutexFact.Grant(J, I, 1));
    event(3, new MutexFact.Learned(J, View.closed(List.of(I, J, K)).next().confined(I, set("A"))));
    ask(4, J, 3, "A");
    assertThat(finish(7).violations(MutexSpec.PROMISE)).isEqualTo(1);
  }

  @Test
  void aPromiseBindsOneRequestAndOverlappingSections() {
    ask(0, I, 5, "A");
    event(1, new MutexFact.Grant(J, I, 1));
    ask(2, J, 4, "B");
    event(3, new MutexFact.Withdraw(I, 1, MutexFailure.WITHDRAWN));
    event(3, new MutexFact.Withdraw(J, 1, MutexFailure.WITHDRAWN));
    event(4, new MutexFact.DoMutex(I, 2, 6, set("A"), ids(I, J, K)));
    event(5, new MutexFact.DoMutex(J, 2, 5, set("A"), ids(I, J, K)));
    assertThat(finish(6).violations(MutexSpec.PROMISE)).isZero();
  }

  @Test
  void requestsThatNeedNoConsentOfEachOtherViolateConnected() {
    event(0, new MutexFact.DoMutex(I, 1, 1, set("A"), ids(K)));
    event(1, new MutexFact.DoMutex(J, 1, 2, set("B"), ids(I, K)));
    assertThat(monitors.report().violations(MutexSpec.CONNECTED)).isZero();
    event(2, new MutexFact.Known(J, 1, ids(K)));
    assertThat(finish(3).violations(MutexSpec.CONNECTED)).isEqualTo(1);
  }

  @Test
  void nonInterferenceExcusesARequestBehindAWaiter() {
    ask(0, K, 1, "A");
    enter(0, K, "A");
    ask(1, J, 2, "A B");
    ask(2, I, 3, "B");
    event(40, new MutexFact.Release(K, 1, set("A"), set("")));
    enter(45, J, "A B");
    event(46, new MutexFact.Release(J, 1, set("B"), set("A")));
    enter(50, I, "B");
    assertThat(finish(60).holds()).isTrue();
  }

  @Test
  void aRequestWithoutCompetitorsIsOwedAccessWithinD3() {
    ask(0, K, 1, "A");
    enter(0, K, "A");
    ask(1, I, 3, "B");
    ask(2, J, 2, "C");
    enter(8, J, "C");
    SpecReport report = finish(30);
    assertThat(report.violations(MutexProgress.NON_INTERFERENCE)).isEqualTo(1);
    assertThat(report.violations().get(0).timeNs()).isEqualTo(11);
  }

  @Test
  void aDeadHolderIsOwedNothingMore() {
    event(0, new MutexFact.DoMutex(I, 1, 1, set("A B"), List.of("A", "B"), false, ids(J, K)));
    enter(1, I, "A");
    monitors.observe(new TraceEvent.Fault(2, I.robot(), "crash", ""));
    assertThat(finish(200).violations()).isEmpty();
  }

  @Test
  void everyRequestIsOwedAccessWithinD2() {
    ask(0, K, 1, "A");
    enter(0, K, "A");
    ask(5, I, 3, "A");
    SpecReport report = finish(60);
    assertThat(report.violations(MutexProgress.SERVED)).isEqualTo(1);
    assertThat(report.violations(MutexProgress.NON_INTERFERENCE)).isZero();
  }

  @Test
  void servedIsNotOwedWhileAHolderIsOverdue() {
    ask(0, K, 1, "A");
    enter(0, K, "A");
    ask(60, I, 3, "A");
    event(500, new MutexFact.Release(K, 1, set("A"), set("")));
    enter(505, I, "A");
    assertThat(finish(510).holds()).isTrue();
  }

  @Test
  void afterAnOverdueReleaseTheWholeBoundIsOwed() {
    ask(0, K, 1, "A");
    enter(0, K, "A");
    ask(60, I, 3, "B");
    ask(60, J, 2, "B");
    enter(61, J, "B");
    event(500, new MutexFact.Release(J, 1, set("B"), set("")));
    event(500, new MutexFact.Release(K, 1, set("A"), set("")));
    SpecReport report = finish(551);
    assertThat(report.violations(MutexProgress.SERVED)).isEqualTo(1);
    assertThat(report.violations())
        .extracting(SpecReport.Violation::timeNs)
        .containsExactly(550L, 510L);
  }

  @Test
  void aRequestThatNeedsOtherParticipantsHasItsWholeBoundAgain() {
    ask(0, I, 1, "A");
    event(9, new MutexFact.Known(I, 1, ids(J, K)));
    enter(19, I, "A");
    assertThat(finish(20).holds()).isTrue();
  }

  @Test
  void nothingIsOwedWhileACrashedParticipantIsNeeded() {
    ask(0, I, 1, "A");
    ask(0, J, 2, "B");
    monitors.observe(new TraceEvent.Fault(5, K.robot(), "crash", ""));
    View without = View.closed(List.of(I, J, K)).next().without(K);
    event(500, new MutexFact.Learned(I, without));
    event(500, new MutexFact.Known(I, 1, ids(J)));
    event(500, new MutexFact.Known(J, 1, ids(I)));
    enter(509, I, "A");
    SpecReport report = finish(600);
    assertThat(report.violations(MutexProgress.NON_INTERFERENCE)).isEqualTo(1);
    assertThat(report.violations(MutexProgress.SERVED)).isEqualTo(1);
    assertThat(report.violations().get(0).robots()).containsExactly(J.robot());
  }

  @Test
  void nothingIsOwedToAFencedParticipantThatIsNotRemovedYet() {
    ask(0, I, 1, "A");
    event(1, new MutexFact.Fence(J, I, set("A")));
    SpecReport report = finish(600);
    assertThat(report.violations(MutexProgress.NON_INTERFERENCE)).isZero();
    assertThat(report.violations(MutexProgress.SERVED)).isZero();
  }

  @Test
  void nothingIsOwedInAFencedSectionOrBehindSuchARequest() {
    View ghost = View.closed(List.of(I, J, K)).next().confined(K, set("A"));
    event(0, new MutexFact.Learned(I, ghost));
    event(0, new MutexFact.DoMutex(I, 1, 1, set("A B"), ids(J)));
    event(1, new MutexFact.DoMutex(J, 1, 2, set("B"), ids(I)));
    event(501, new MutexFact.Withdraw(I, 1, MutexFailure.OCCUPIED));
    SpecReport report = finish(520);
    assertThat(report.violations(MutexProgress.NON_INTERFERENCE)).isEqualTo(1);
    assertThat(report.violations(MutexProgress.SERVED)).isZero();
  }

  @Test
  void nothingIsOwedDuringANetworkFault() {
    ask(0, I, 1, "A");
    RobotId world = TraceEvent.Fault.WORLD;
    monitors.observe(new TraceEvent.Fault(5, world, "begin", "loss 0.9"));
    monitors.observe(new TraceEvent.Fault(300, world, "end", "loss 0.9"));
    enter(310, I, "A");
    assertThat(finish(500).violations(MutexProgress.NON_INTERFERENCE)).isZero();
  }

  @Test
  void withdrawnRequestsAndRobotsThatLeftAreOwedNothing() {
    ask(0, I, 1, "A");
    ask(0, J, 2, "B");
    event(5, new MutexFact.Withdraw(I, 1, MutexFailure.WITHDRAWN));
    monitors.observe(new TraceEvent.Joined(5, J.robot(), new Pose(0, 0, 0), 165));
    monitors.observe(new TraceEvent.Left(6, J.robot()));
    assertThat(finish(200).holds()).isTrue();
  }

  @Test
  void otherInstancesAndEventsAreIgnored() {
    monitors.observe(
        TraceEvent.Action.of(
            0,
            I.robot(),
            MutexFact.source("y"),
            Note.SHAPE,
            new Note("od_mutex", List.of("nonsense"))));
    monitors.observe(
        new TraceEvent.Variable(0, I.robot(), MutexFact.source("x"), MutexFact.CRIT, true));
    assertThat(finish(1).holds()).isTrue();
  }

  @Test
  void everyEventIsReadAsItWasWritten() throws JsonFormatException {
    List<MutexFact> all =
        List.of(
            new MutexFact.DoMutex(I, 1, 7, set("A B"), ids(J, K)),
            new MutexFact.DoMutex(I, 1, 7, set("A"), ids()),
            new MutexFact.OdMutex(I, 1, set("A B")),
            new MutexFact.Release(I, 1, set("A"), set("B")),
            new MutexFact.Release(I, 1, set("B"), set("")),
            new MutexFact.Withdraw(I, 2, MutexFailure.DEADLINE),
            new MutexFact.Grant(I, J, 3),
            new MutexFact.Learned(I, View.closed(List.of(I, J)).next().confined(J, set("A B"))),
            new MutexFact.Fence(I, J, set("A B")),
            new MutexFact.Fence(I, J, set("")),
            new MutexFact.StandsIn(I, set("B")),
            new MutexFact.Known(I, 1, ids(K)));
    for (MutexFact event : all) {
      assertThat(MutexFact.SHAPE.readJson(new JsonReader("a", 1, MutexFact.SHAPE.json(event))))
          .isEqualTo(event);
    }
  }

  @Test
  void anUnreadableActionIsReported() {
    String bad = "{\"od_mutex\":{\"who\":\"i\",\"num\":\"two\",\"held\":[]}}";
    assertThatThrownBy(() -> MutexFact.SHAPE.readJson(new JsonReader("a.jsonl", 7, bad)))
        .isInstanceOf(JsonFormatException.class)
        .hasMessageStartingWith("a.jsonl:7: column 30: expected a digit");
  }

  private void ask(long atNs, ProcessId who, long ts, String sections) {
    event(atNs, new MutexFact.DoMutex(who, 1, ts, set(sections), ids(I, J, K)));
  }

  private void enter(long atNs, ProcessId who, String sections) {
    event(atNs, new MutexFact.OdMutex(who, 1, set(sections)));
  }

  private void event(long atNs, MutexFact event) {
    monitors.observe(action(atNs, event));
  }

  private static TraceEvent action(long atNs, MutexFact event) {
    return TraceEvent.Action.of(
        atNs, event.who().robot(), MutexFact.source("x"), MutexFact.SHAPE, event);
  }

  private SpecReport finish(long endNs) {
    monitors.finish(endNs);
    return monitors.report();
  }

  private static SortedSet<String> set(String names) {
    return names.isEmpty() ? Sections.NONE : Sections.copyOf(Set.of(names.split(" ")));
  }

  private static SortedSet<ProcessId> ids(ProcessId... ids) {
    return new TreeSet<>(List.of(ids));
  }
}
