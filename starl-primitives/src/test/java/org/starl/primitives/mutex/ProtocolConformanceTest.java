package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.Short;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.ProtocolAutomaton.States;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.TraceEvent;

/** The map from facts to the protocol's actions, and traces that are no runs of it. */
class ProtocolConformanceTest {

  private static final ProcessId I = ProcessId.first(new RobotId("i"), 1);
  private static final ProcessId J = ProcessId.first(new RobotId("j"), 1);
  private static final ProcessId J_AGAIN = ProcessId.first(new RobotId("j"), 2);

  private final ShownRun<States, ProtocolAction> run = new ShownRun<>(ProtocolConformance::new);

  private void event(MutexFact event) {
    run.has(
        TraceEvent.Action.of(
            0, event.who().robot(), MutexFact.source("x"), MutexFact.SHAPE, event));
  }

  private void learn(ProcessId who, View view) {
    event(new MutexFact.Learned(who, view));
  }

  private static View view(long number, ProcessId... listed) {
    Map<ProcessId, Long> admitted = new TreeMap<>();
    for (ProcessId each : listed) {
      admitted.put(each, 1L);
    }
    return new View(number, new TreeMap<>(admitted));
  }

  private static SortedSet<ProcessId> those(ProcessId... ids) {
    return new TreeSet<>(Set.of(ids));
  }

  private void asks(ProcessId who, long num, long ts, String want, ProcessId... known) {
    event(new MutexFact.DoMutex(who, num, ts, Short.sections(want), those(known)));
  }

  private void grants(ProcessId who, ProcessId to, long num) {
    event(new MutexFact.Grant(who, to, num));
  }

  private void enters(ProcessId who, long num, String held) {
    event(new MutexFact.OdMutex(who, num, Short.sections(held)));
  }

  private void fences(ProcessId who, ProcessId suspect) {
    event(new MutexFact.Fence(who, suspect, Sections.NONE));
  }

  private void isGood() {
    assertThat(run.report().violations()).isEmpty();
  }

  private void isBad(String detail) {
    assertThat(run.report().violations())
        .extracting(Violation::lemma)
        .containsOnly("MutexProtocol_decls");
    assertThat(run.report().violations().getFirst().detail()).contains(detail);
  }

  /** Both are listed, and {@code j} holds A. */
  private void holds() {
    learn(I, view(1, I, J));
    learn(J, view(1, I, J));
    asks(J, 1, 1, "A", I);
    grants(I, J, 1);
    enters(J, 1, "A");
  }

  @Test
  void aRequestIsGrantedByAllThatAreKnown() {
    holds();
    asks(I, 1, 2, "A B", J);
    event(new MutexFact.Release(J, 1, Short.sections("A"), Sections.NONE));
    grants(J, I, 1);
    enters(I, 1, "A B");
    assertThat(run.steps())
        .containsSubsequence(
            "request(j, [A], [i], false)",
            "grant(i, j, 1, A)",
            "enter(j, [A])",
            "request(i, [A, B], [j], false)",
            "release(j, [A])",
            "grant(j, i, 2, A)",
            "grant(j, i, 2, B)",
            "enter(i, [A, B])");
    isGood();
  }

  @Test
  void whoHasRetiredGrantsByAMessageAlone() {
    learn(I, view(1, I, J));
    asks(I, 1, 1, "B", J);
    MutexMessage.Ok ok = new MutexMessage.Ok(J, I, 1);
    run.has(
        new TraceEvent.Sent(
            0, J.robot(), "i", MutexFact.source("x"), 1, 1, MutexMessage.SHAPE, ok));
    enters(I, 1, "B");
    assertThat(run.steps()).contains("grant(j, i, 1, B)");
    isGood();
  }

  @Test
  void whoEntersWithoutAGrantIsFound() {
    learn(I, view(1, I, J));
    asks(I, 1, 1, "B", J);
    enters(I, 1, "B");
    isBad("granted?(j, i, ts(i), z)");
  }

  @Test
  void aHolderThatGrantsWhatItHoldsIsFound() {
    holds();
    asks(I, 1, 2, "A", J);
    grants(J, I, 1);
    isBad("keeps_back?");
  }

  @Test
  void whoseNextTimeIsNotLaterThanWhatItGrantedIsFound() {
    learn(I, view(1, I, J));
    asks(J, 1, 5, "A", I);
    grants(I, J, 1);
    asks(I, 1, 3, "B", J);
    isBad("ts(i) is 6, but the trace has 3");
  }

  @Test
  void whoLeavesAHolderOutOfItsListIsFound() {
    holds();
    learn(I, view(2, I));
    isBad("not active?(j)");
  }

  @Test
  void whoHasFencedAHolderMayEnterWhatThatDoesNotHold() {
    holds();
    fences(I, J);
    learn(I, view(1, I, J).next().confined(J, Short.sections("A")));
    asks(I, 1, 2, "B");
    enters(I, 1, "B");
    assertThat(run.steps()).contains("fence(i, j)", "vouch(i, j, i, 2, B)");
    isGood();
  }

  @Test
  void whoEntersAGhostsSectionIsFound() {
    holds();
    fences(I, J);
    learn(I, view(1, I, J).next().confined(J, Short.sections("A")));
    asks(I, 1, 2, "A");
    enters(I, 1, "A");
    isBad("may_hold?");
  }

  @Test
  void aFencedProcessThatEntersLaterIsFound() {
    learn(I, view(1, I, J));
    learn(J, view(1, I, J));
    asks(J, 1, 1, "A", I);
    fences(I, J);
    learn(I, view(2, I));
    asks(I, 1, 2, "A");
    enters(I, 1, "A"); // i never granted it to j
    isGood();
    event(new MutexFact.Known(J, 1, those())); // and forgets whom it has to ask
    enters(J, 1, "A");
    isBad("f in fencers(i) => forall z: Zones :: z in G => granted?(f, i, ts(i), z)");
  }

  @Test
  void whoAsksItselfTooMayEnterThoughItIsConfinedToWhatItAsksFor() {
    learn(I, view(1, I, J));
    learn(J, view(1, I, J));
    asks(J, 1, 1, "A", I, J);
    grants(I, J, 1);
    fences(I, J);
    learn(I, view(1, I, J).next().confined(J, Short.sections("A")));
    enters(J, 1, "A");
    assertThat(run.steps()).contains("fence(i, j)", "enter(j, [A])");
    isGood();
  }

  @Test
  void whoIsRemovedBeforeItsFirstRequestIsVouchedFor() {
    ProcessId k = ProcessId.first(new RobotId("k"), 1);
    learn(I, view(1, I, J, k));
    fences(k, J);
    learn(I, view(2, I, k));
    asks(J, 1, 1, "A", I, k); // it does not know yet
    asks(I, 1, 2, "A", k);
    grants(I, J, 1);
    grants(k, I, 1);
    enters(I, 1, "A");
    assertThat(run.steps()).contains("fence(k, j)", "vouch(k, j, i, 2, A)");
    isGood();
  }

  @Test
  void aFencedProcessIsGrantedNothing() {
    holds();
    fences(I, J);
    learn(I, view(2, I));
    asks(J, 2, 3, "B", I);
    event(new MutexFact.Release(J, 1, Short.sections("A"), Sections.NONE));
    isBad("not active?(i)");
  }

  @Test
  void aLaterStartHoldsWhereItsBodyIsAndVouchesForTheRest() {
    holds();
    event(new MutexFact.StandsIn(J_AGAIN, Short.sections("A")));
    learn(I, view(1, I, J).next().confined(J, Short.sections("A")));
    asks(I, 1, 2, "B");
    enters(I, 1, "B");
    event(new MutexFact.StandsIn(J_AGAIN, Sections.NONE));
    event(new MutexFact.Release(I, 1, Short.sections("B"), Sections.NONE));
    asks(I, 2, 3, "A");
    enters(I, 2, "A");
    assertThat(run.steps()).contains("fence(j.2, j)", "vouch(j.2, j, i, 2, B)", "release(j, [A])");
    isGood();
  }

  @Test
  void ofAProcessThatIsKilledInRealTimeTheLastEventsMayBeMissing() {
    run.has(TraceEvent.Fault.realTime(0));
    holds();
    asks(I, 1, 2, "A", J);
    run.has(new TraceEvent.Fault(1, J.robot(), TraceEvent.Fault.CRASH, ""));
    // That J has given back A and granted it.
    enters(I, 1, "A");
    isGood();
    run.ends(2);
    assertThat(run.report().inPart())
        .containsExactly(Map.entry("MutexProtocol_decls", "the trace of j is cut off at 0.000 s"));
  }

  @Test
  void aSimulatedCrashEndsNothing() {
    holds();
    asks(I, 1, 2, "A", J);
    run.has(new TraceEvent.Fault(1, J.robot(), TraceEvent.Fault.CRASH, ""));
    enters(I, 1, "A");
    isBad("enter(i, [A])");
  }

  private void asksInOrder(ProcessId who, long num, long ts, boolean resumes, String... want) {
    List<String> sequence = List.of(want);
    ProcessId other = who.equals(I) ? J : I;
    event(
        new MutexFact.DoMutex(
            who, num, ts, Sections.copyOf(sequence), sequence, resumes, those(other)));
  }

  private void grants(ProcessId who, ProcessId to, long num, String part) {
    event(new MutexFact.Grant(who, to, num, Short.sections(part)));
  }

  /** Both are listed, and {@code j} asks for A and then B, and holds A. */
  private void holdsAndWaits() {
    learn(I, view(1, I, J));
    learn(J, view(1, I, J));
    asksInOrder(J, 1, 1, false, "A", "B");
    grants(I, J, 1, "A");
    enters(J, 1, "A");
  }

  @Test
  void aSequenceIsGrantedAndGivenBackPartByPart() {
    holdsAndWaits();
    grants(I, J, 1, "A B");
    enters(J, 1, "A B");
    event(new MutexFact.Release(J, 1, Short.sections("A"), Short.sections("B")));
    asksInOrder(I, 1, 2, false, "A", "B");
    grants(J, I, 1, "A");
    enters(I, 1, "A");
    assertThat(run.steps())
        .containsSubsequence(
            "request(j, [A, B], [i], true)",
            "grant(i, j, 1, A)",
            "enter(j, [A])",
            "grant(i, j, 1, B)",
            "enter(j, [B])",
            "release(j, [A])",
            "grant(j, i, 2, A)",
            "enter(i, [A])");
    isGood();
  }

  @Test
  void whoGrantsTheSectionThatItHoldsOfASequenceIsFound() {
    holdsAndWaits();
    asksInOrder(I, 1, 2, false, "B", "A");
    grants(J, I, 1, "A");
    isBad("keeps_back?");
  }

  @Test
  void whoGrantsASectionThatItWaitsForBeforeTheOtherIsFound() {
    holdsAndWaits();
    asksInOrder(I, 1, 2, false, "B", "A");
    grants(J, I, 1, "B");
    isBad("keeps_back?");
  }

  @Test
  void whoEntersAPartOfASetIsFound() {
    learn(I, view(1, I, J));
    asks(I, 1, 1, "A B", J);
    grants(J, I, 1);
    enters(I, 1, "A");
    isBad("i in parts or G = want(i)");
  }

  @Test
  void whoEntersASectionOfASequenceWithoutItsGrantIsFound() {
    holdsAndWaits();
    enters(J, 1, "A B");
    isBad("granted?(j, i, ts(i), z)");
  }

  @Test
  void whoWithdrawsKeepsWhatItHolds() {
    holdsAndWaits();
    event(new MutexFact.Withdraw(J, 1, MutexFailure.DEADLINE));
    asks(I, 1, 2, "B", J);
    grants(J, I, 1);
    enters(I, 1, "B");
    isGood();
    asks(I, 2, 3, "A", J);
    isBad("not active?(i)");
  }

  @Test
  void aHolderNeedsNoGrantOfOneThatComesLater() {
    holdsAndWaits();
    event(new MutexFact.Known(J, 1, those(I, J_AGAIN)));
    grants(I, J, 1, "A B");
    enters(J, 1, "A B");
    assertThat(run.steps()).contains("known(j, [i])");
    isGood();
  }

  @Test
  void aMutexIsLeftOutFromTheFirstSequenceOnThatIsResumed() {
    asksInOrder(J, 1, 1, true, "A", "B");
    enters(J, 1, "A");
    assertThat(run.steps()).isEmpty();
    run.ends(2);
    assertThat(run.report().inPart())
        .containsExactly(
            Map.entry("MutexProtocol_decls", "mutex/x: j resumes a sequence at 0.000 s"));
  }
}
