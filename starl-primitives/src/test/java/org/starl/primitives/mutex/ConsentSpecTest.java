package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.spec.Monitors;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/** Traces written by hand: a ghost blocks for at most 10 ns, a dead participant for 20. */
class ConsentSpecTest {

  private static final ProcessId I = ProcessId.first(new RobotId("i"), 1);
  private static final ProcessId J = ProcessId.first(new RobotId("j"), 1);
  private static final ProcessId K = ProcessId.first(new RobotId("k"), 1);
  private static final ProcessId L = ProcessId.first(new RobotId("l"), 1);

  private static final Instance MUTEX = MutexFact.source("x");

  private final Monitors monitors = new Monitors(List.of(new ConsentSpec(10, 20).answering()));

  ConsentSpecTest() {
    for (ProcessId id : List.of(I, J, K)) {
      event(0, new MutexFact.Learned(id, View.closed(List.of(I, J, K))));
    }
  }

  @Test
  void entryWithAllAnswersHolds() {
    ask(0);
    ok(1, J, I, 1);
    ok(1, K, I, 1);
    event(2, new MutexFact.OdMutex(I, 1, set("A")));
    assertThat(monitors.report().holds()).isTrue();
  }

  @Test
  void entryWithoutAnAnswerViolatesConsent() {
    ask(0);
    ok(1, J, I, 1);
    event(2, new MutexFact.OdMutex(I, 1, set("A")));
    assertThat(monitors.report().violations(ConsentSpec.CONSENT)).isEqualTo(1);
  }

  @Test
  void anAnswerToAnEarlierRequestIsNoConsent() {
    ask(0);
    ok(1, J, I, 1);
    ok(1, K, I, 0);
    event(2, new MutexFact.OdMutex(I, 1, set("A")));
    assertThat(monitors.report().violations(ConsentSpec.CONSENT)).isEqualTo(1);
  }

  @Test
  void aLaterParticipantThatHasAskedIsNeededToo() {
    ask(0);
    ok(1, J, I, 1);
    ok(1, K, I, 1);
    deliver(1, new MutexMessage.Req(L, I, 1, 2, 5, set("A")));
    event(2, new MutexFact.OdMutex(I, 1, set("A")));
    assertThat(monitors.report().violations(ConsentSpec.CONSENT)).isEqualTo(1);
  }

  @Test
  void entryIntoAGhostsSectionViolatesConsent() {
    event(0, new MutexFact.Learned(I, ghost()));
    ask(0);
    ok(1, J, I, 1);
    ok(1, K, I, 1);
    event(2, new MutexFact.OdMutex(I, 1, set("A")));
    assertThat(monitors.report().violations(ConsentSpec.CONSENT)).isEqualTo(1);
  }

  @Test
  void entryIntoAPartOfASequenceOnTheWayToAGhostViolatesConsent() {
    event(0, new MutexFact.Learned(I, ghost()));
    event(
        0,
        new MutexFact.DoMutex(
            I, 1, 1, set("A", "B"), List.of("B", "A"), false, new TreeSet<>(Set.of(J))));
    ok(1, J, I, 1);
    event(2, new MutexFact.OdMutex(I, 1, set("B")));
    assertThat(monitors.report().violations(ConsentSpec.CONSENT)).isEqualTo(1);
  }

  @Test
  void aQuestionForAFenceOfAProcessThatIsNotListedViolatesFenced() {
    send(1, new MutexMessage.FenceQ(I, J, K, 1));
    assertThat(monitors.report().holds()).isTrue();
    event(2, new MutexFact.Learned(I, ghost()));
    send(3, new MutexMessage.FenceQ(I, J, L, 3)); // of a view that it does not know yet
    assertThat(monitors.report().holds()).isTrue();
    send(4, new MutexMessage.FenceQ(I, J, K, 1));
    assertThat(monitors.report().violations(ConsentSpec.FENCED)).isEqualTo(1);
  }

  @Test
  void aRequestThatEndsAsLateOnANoteToAnEarlierOneViolatesLate() {
    ask(0);
    deliver(1, new MutexMessage.Noted(J, I, 1, 7));
    event(1, new MutexFact.Withdraw(I, 1, MutexFailure.LATE));
    assertThat(monitors.report().violations(ConsentSpec.LATE)).isZero();
    event(2, new MutexFact.DoMutex(I, 2, 2, set("A"), new TreeSet<>(Set.of(J, K))));
    deliver(3, new MutexMessage.Noted(J, I, 1, 7));
    event(3, new MutexFact.Withdraw(I, 2, MutexFailure.LATE));
    assertThat(monitors.report().violations(ConsentSpec.LATE)).isEqualTo(1);
  }

  @Test
  void aGrantAfterTheFenceViolatesFencedAlsoByAMessageAlone() {
    ok(0, J, I, 1);
    event(1, new MutexFact.Fence(J, I, set("A")));
    ok(2, J, I, 1);
    assertThat(monitors.report().holds()).isTrue();
    ok(3, J, I, 2);
    assertThat(monitors.report().violations(ConsentSpec.FENCED)).isEqualTo(1);
    event(4, new MutexFact.Grant(J, I, 3));
    assertThat(monitors.report().violations(ConsentSpec.FENCED)).isEqualTo(2);
  }

  @Test
  void aRequestThatWaitsOnlyForAGhostMustEnd() {
    event(0, new MutexFact.Learned(I, ghost()));
    ask(0);
    ok(1, J, I, 1);
    ok(5, K, I, 1);
    monitors.finish(15);
    assertThat(monitors.report().violations()).isEmpty();
  }

  @Test
  void aRequestThatWaitsTooLongForAGhostViolatesServed() {
    event(0, new MutexFact.Learned(I, ghost()));
    ask(0);
    ok(5, J, I, 1);
    ok(5, K, I, 1);
    monitors.finish(16);
    assertThat(monitors.report().violations("mutex.Served")).isEqualTo(1);
  }

  @Test
  void aDeadParticipantThatIsNotConfinedViolatesServed() {
    monitors.observe(new Fault(0, K.robot(), Fault.CRASH, ""));
    ask(1);
    ok(1, J, I, 1);
    monitors.finish(22);
    assertThat(monitors.report().violations("mutex.Served")).isEqualTo(1);
  }

  @Test
  void theAcceptorsOfTheRegistrationDecideAlsoWithoutAMutex() {
    List<RobotId> acceptors =
        List.of(I.robot(), J.robot(), K.robot(), new RobotId("x"), new RobotId("y"));
    monitors.observe(
        Action.of(
            0,
            I.robot(),
            Instance.of("registration", MUTEX.xid()),
            AgreementFact.ACCEPTORS,
            new AgreementFact.Acceptors(acceptors)));
    for (RobotId dead : List.of(K.robot(), new RobotId("x"), new RobotId("y"))) {
      monitors.observe(new Fault(0, dead, Fault.CRASH, ""));
    }
    ask(1);
    ok(1, J, I, 1);
    monitors.finish(50);
    assertThat(monitors.report().violations()).isEmpty();
  }

  @Test
  void withoutAMajorityNoParticipantMustBeConfined() {
    monitors.observe(new Fault(0, K.robot(), Fault.CRASH, ""));
    monitors.observe(new Fault(0, J.robot(), Fault.CRASH, ""));
    ask(1);
    monitors.finish(50);
    assertThat(monitors.report().violations()).isEmpty();
  }

  private static View ghost() {
    return View.closed(List.of(I, J, K)).next().confined(K, set("A"));
  }

  @Test
  void whoWantsNoSectionMustConsentAtOnce() {
    req(1, J, I, 1);
    ok(1, I, J, 1);
    req(2, K, I, 1);
    ok(3, I, K, 1);
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isEqualTo(1);
  }

  @Test
  void anEarlierProcessOfAProgramMustAnswerToo() {
    ProcessId next = new ProcessId(I.robot(), I.inc() + 1);
    event(0, new MutexFact.Learned(next, View.closed(List.of(next, J, K))));
    req(1, J, I, 1);
    ok(1, I, J, 1);
    req(2, J, I, 2);
    event(3, new MutexFact.Known(next, 0, new TreeSet<>()));
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isEqualTo(1);
    event(3, new MutexFact.Fence(I, J, set()));
    req(4, J, I, 3);
    event(5, new MutexFact.Known(next, 0, new TreeSet<>()));
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isEqualTo(1);
  }

  @Test
  void whoWantsASectionMustGiveAFenceAtOnce() {
    deliver(0, new MutexMessage.FenceQ(J, I, K, 1)); // it may leave
    ask(1);
    deliver(2, new MutexMessage.FenceQ(J, I, K, 1));
    send(2, new MutexMessage.Fence(I, J, K, set()));
    deliver(3, new MutexMessage.FenceQ(J, I, K, 0)); // its consent is not needed
    deliver(4, new MutexMessage.FenceQ(J, I, K, 1));
    send(4, new MutexMessage.Fence(I, J, L, set()));
    event(5, new MutexFact.Known(I, 1, new TreeSet<>(Set.of(J, K))));
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isEqualTo(1);
  }

  @Test
  void whoDefersMustSayWhenItIsAskedAgain() {
    ask(0);
    req(1, J, I, 1);
    req(2, J, I, 1);
    noted(2, I, J, 1);
    req(3, J, I, 1);
    event(4, new MutexFact.Known(I, 1, new TreeSet<>(Set.of(J, K))));
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isEqualTo(1);
  }

  @Test
  void whoConsentsToARequestThatItKnowsToBeOverViolatesAnswered() {
    req(1, J, I, 1);
    ok(1, I, J, 1);
    req(2, J, I, 2);
    ok(2, I, J, 2);
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isZero();
    ok(3, I, J, 1);
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isEqualTo(1);
    deliver(4, new MutexMessage.Rem(J, I, 2, new TreeSet<>()));
    ok(5, I, J, 2);
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isEqualTo(2);
  }

  @Test
  void whoseRequestEndsMustConsentToWhatItDeferred() {
    ask(0);
    req(1, J, I, 1);
    req(1, K, I, 1);
    event(2, new MutexFact.Withdraw(I, 1, MutexFailure.WITHDRAWN));
    ok(2, I, J, 1);
    event(3, new MutexFact.Known(I, 1, new TreeSet<>(Set.of(J, K))));
    assertThat(monitors.report().violations(ConsentSpec.ANSWERED)).isEqualTo(1);
  }

  @Test
  void aProcessTellsThoseThatItHasAskedWhatItGivesBack() {
    for (MutexFact end :
        List.of(
            new MutexFact.Release(I, 1, set("A"), set()),
            new MutexFact.Withdraw(I, 1, MutexFailure.WITHDRAWN))) {
      boolean isRelease = end instanceof MutexFact.Release;
      ask(0);
      event(2, end);
      send(2, new MutexMessage.Rem(I, J, 1, set()));
      send(2, new MutexMessage.Rem(I, K, isRelease ? 1 : 2, isRelease ? set("A") : set()));
      event(3, new MutexFact.Known(I, 1, new TreeSet<>(Set.of(J, K))));
      assertThat(monitors.report().violations(ConsentSpec.TELLS)).isEqualTo(isRelease ? 1 : 2);
    }
  }

  @Test
  void aProcessAsksAllThatItKnowsAtOnce() {
    event(0, new MutexFact.DoMutex(I, 1, 1, set("A"), new TreeSet<>(Set.of(J, K))));
    send(0, new MutexMessage.Req(I, J, 1, 1, 5, set("A")));
    send(1, new MutexMessage.Req(I, K, 1, 1, 5, set("A")));
    assertThat(monitors.report().violations(ConsentSpec.TELLS)).isEqualTo(1);
    event(2, new MutexFact.Learned(I, View.closed(List.of(I, J, K, L))));
    send(3, new MutexMessage.FenceQ(I, J, K, 1));
    send(4, new MutexMessage.FenceQ(I, L, K, 1));
    send(4, new MutexMessage.FenceQ(I, J, K, 1));
    event(5, new MutexFact.Known(I, 1, new TreeSet<>(Set.of(J, K))));
    assertThat(monitors.report().violations(ConsentSpec.TELLS)).isEqualTo(2);
  }

  @Test
  void nothingIsOwedToARequestThatHasEnded() {
    ask(0);
    req(1, J, I, 1);
    deliver(2, new MutexMessage.Rem(J, I, 1, set()));
    event(3, new MutexFact.Withdraw(I, 1, MutexFailure.WITHDRAWN));
    send(3, new MutexMessage.Rem(I, J, 1, set()));
    send(3, new MutexMessage.Rem(I, K, 1, set()));
    req(4, J, I, 1);
    event(5, new MutexFact.Known(I, 1, new TreeSet<>(Set.of(J, K))));
    assertThat(monitors.report().holds()).isTrue();
  }

  private void req(long timeNs, ProcessId from, ProcessId to, long num) {
    deliver(timeNs, new MutexMessage.Req(from, to, num, 1, 5, set("A")));
  }

  private void noted(long timeNs, ProcessId from, ProcessId to, long num) {
    send(timeNs, new MutexMessage.Noted(from, to, num));
  }

  private void deliver(long timeNs, MutexMessage message) {
    monitors.observe(
        new Delivered(
            timeNs,
            message.to().robot(),
            message.from().robot(),
            MUTEX,
            1,
            MutexMessage.SHAPE,
            message));
  }

  private void ask(long timeNs) {
    event(timeNs, new MutexFact.DoMutex(I, 1, 1, set("A"), new TreeSet<>(Set.of(J, K))));
    for (ProcessId other : List.of(J, K)) {
      send(timeNs, new MutexMessage.Req(I, other, 1, 1, 5, set("A")));
    }
  }

  private void ok(long timeNs, ProcessId from, ProcessId to, long num) {
    send(timeNs, new MutexMessage.Ok(from, to, num));
  }

  private void send(long timeNs, MutexMessage message) {
    RobotId from = message.from().robot();
    String to = message.to().robot().name();
    monitors.observe(new Sent(timeNs, from, to, MUTEX, 1, 1, MutexMessage.SHAPE, message));
  }

  private static SortedSet<String> set(String... sections) {
    return Sections.copyOf(List.of(sections));
  }

  private void event(long timeNs, MutexFact event) {
    monitors.observe(Action.of(timeNs, event.who().robot(), MUTEX, MutexFact.SHAPE, event));
  }
}
