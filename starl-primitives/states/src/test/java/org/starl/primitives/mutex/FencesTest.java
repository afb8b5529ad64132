package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.starl.comms.LamportClock;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexMessage.Fence;
import org.starl.primitives.mutex.MutexMessage.FenceQ;
import org.starl.primitives.mutex.MutexMessage.Fenced;
import org.starl.primitives.mutex.MutexMessage.Noted;
import org.starl.primitives.mutex.MutexMessage.Ok;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;
import org.starl.primitives.mutex.MutexProtocol.Phase;
import org.starl.random.Rng;

/** Fencing and being fenced, message by message, on participant b. */
class FencesTest {

  private static final long S = 1_000_000_000;
  private static final ProcessId A = id("a");
  private static final ProcessId B = id("b");
  private static final ProcessId C = id("c");
  private static final View ALL = View.closed(List.of(A, B, C));

  private final List<MutexMessage> sent = new ArrayList<>();
  private final List<MutexFact> events = new ArrayList<>();
  private long nowNs;
  private final MutexNode node = new MutexNode(B, MutexProtocol::new, sent::add, events::add);
  private final MutexProtocol b = node.protocol;

  @Test
  void aFencerReportsItsGrantAndGrantsNothingMore() {
    b.learn(ALL);
    hears(new Req(A, B, 1, 1, 1, sections("x", "y")));
    hears(new Rem(A, B, 1, sections("y")));
    sent.clear();
    hears(new FenceQ(C, B, A, 1));
    assertThat(sent).containsExactly(new Fence(B, C, A, sections("y")));
    sent.clear();
    hears(new Req(A, B, 1, 1, 1, sections("x", "y")));
    assertThat(sent).as("what was granted stays granted").containsExactly(new Ok(B, A, 1));
    sent.clear();
    hears(new Req(A, B, 2, 1, 5, sections("z")));
    assertThat(sent).containsExactly(new Fenced(B, A));
    assertThat(events).contains(new MutexFact.Fence(B, A, sections("y")));
  }

  @Test
  void aYoungerParticipantThatTheSuspectNeverAskedCannotFence() {
    b.learn(new View(3, ALL.admitted()).next().without(B).with(B));
    hears(new FenceQ(C, B, A, 1));
    assertThat(sent).isEmpty();
    assertThat(b.fenced()).isEmpty();
    hears(new Req(A, B, 1, 1, 1, sections("x")));
    sent.clear();
    hears(new FenceQ(C, B, A, 1));
    assertThat(sent).containsExactly(new Fence(B, C, A, sections("x")));
  }

  @Test
  void aSuspicionAsksAllAndProposesTheIntersectionOfTheAnswers() {
    b.learn(ALL);
    hears(new Req(A, B, 1, 1, 1, sections("x", "y")));
    b.request(sections("z"), 0);
    sent.clear();
    b.suspect(A, S);
    assertThat(sent).containsExactly(new FenceQ(B, C, A, 1));
    assertThat(node.proposed).isEmpty();
    hears(new Fence(C, B, A, sections("y", "w")));
    assertThat(node.proposed).containsExactly(new Confinement(A, sections("y"), ids(B, C)));
    assertThat(b.phase()).as("a fence is no view").isEqualTo(Phase.TRYING);
  }

  @Test
  void withoutAnswersTheParticipantProposesAloneAfterARound() {
    b.learn(ALL);
    b.request(sections("x"), 0);
    b.suspect(A, 0);
    sent.clear();
    for (long ms = 0; ms < 40_000; ms += 100) {
      b.timer(ms * S / 1000);
    }
    assertThat(node.proposed).containsExactly(new Confinement(A, Sections.NONE, ids(B)));
    assertThat(sent.stream().filter(FenceQ.class::isInstance)).hasSizeBetween(2, 10);
  }

  /** Each is at random up to twice as long as its pause. */
  @Test
  void thePausesBetweenRoundsDoubleUpToTheirBound() {
    b.learn(ALL);
    b.request(sections("x"), 0);
    b.suspect(A, 0);
    for (long pauseNs : List.of(S, 2 * S, 4 * S, 8 * S, 16 * S, 16 * S)) {
      sent.clear();
      long askedNs = nowNs;
      while (sent.stream().noneMatch(FenceQ.class::isInstance)) {
        nowNs += S / 100;
        b.timer(nowNs);
      }
      assertThat(nowNs - askedNs).isBetween(pauseNs, 2 * pauseNs + S / 100);
    }
  }

  @Test
  void aFencerContinuesForTheAskingOneUntilAViewExcludesTheSuspect() {
    b.learn(ALL);
    hears(new FenceQ(C, B, A, 1));
    assertThat(b.nextTimerNs()).isBetween(3 * S, 5 * S);
    b.timer(5 * S);
    b.timer(20 * S);
    assertThat(node.proposed).contains(new Confinement(A, Sections.NONE, ids(B)));
    b.learn(ALL.next().without(A));
    assertThat(b.nextTimerNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void aGhostIsNotNeededAndBlocksOnlyRequestsForItsSections() {
    b.learn(ALL);
    b.request(sections("x"), 0);
    hears(new Ok(C, B, 1));
    b.learn(ALL.next().confined(A, sections("x")));
    assertThat(b.missing()).isEmpty();
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
    b.timer(MutexNode.TIMES.deadlineMs() * S / 1000);
    assertThat(events).contains(new MutexFact.Withdraw(B, 1, MutexFailure.OCCUPIED));
    b.request(sections("y"), 0);
    hears(new Ok(C, B, 2));
    assertThat(b.held()).containsExactly("y");
  }

  @Test
  void aRequestBlockedOnlyByAGhostSoonFailsForThoseBehindIt() {
    MutexTimes times = MutexTimes.DEFAULT;
    assertThat(times.occupiedMs()).isLessThan(times.suspectMs()).isLessThan(times.deadlineMs());
    RequestTimers timers = new RequestTimers(times);
    timers.begin(7 * S);
    assertThat(timers.isGhostTimeOver(7 * S + times.occupiedMs() * S / 1000 - 1)).isFalse();
    assertThat(timers.isGhostTimeOver(7 * S + times.occupiedMs() * S / 1000)).isTrue();
  }

  @Test
  void aGhostDoesNotBlockItsOwnRobot() {
    ProcessId older = ProcessId.first(new RobotId("b"), 1);
    ProcessId newer = ProcessId.first(new RobotId("b"), 2);
    MutexNode next = new MutexNode(newer, MutexProtocol::new, sent::add, events::add);
    View views = View.closed(List.of(older)).next().with(newer).confined(older, sections("x"));
    next.protocol.learn(views);
    next.protocol.request(sections("x"), 0);
    assertThat(next.protocol.held()).containsExactly("x");
  }

  @Test
  void aParticipantProposesASmallerBoundOfAGhost() {
    b.learn(ALL);
    hears(new Req(A, B, 1, 1, 1, sections("x", "y")));
    b.learn(ALL.next().confined(A, sections("x", "y")));
    assertThat(node.proposed).isEmpty();
    hears(new Rem(A, B, 1, sections("y")));
    assertThat(node.proposed).containsExactly(new Confinement(A, sections("y"), ids(B)));
  }

  @Test
  void aFencedParticipantWithdrawsAndNeverRequestsAgain() {
    b.learn(ALL);
    b.request(sections("x"), 0);
    hears(new Fenced(A, B));
    assertThat(events).contains(new MutexFact.Withdraw(B, 1, MutexFailure.FENCED));
    assertThat(node.isDone).isTrue();
    b.request(sections("x"), 0);
    assertThat(events).contains(new MutexFact.Withdraw(B, 0, MutexFailure.NOT_REGISTERED));
  }

  @Test
  void aFencedHolderKeepsItsSectionsUntilTheRelease() {
    b.learn(ALL);
    b.request(sections("x"), 0);
    hears(new Ok(A, B, 1));
    hears(new Ok(C, B, 1));
    hears(new Fenced(A, B));
    assertThat(b.held()).containsExactly("x");
    assertThat(node.isDone).isFalse();
    b.learn(ALL.next().confined(B, sections("x")));
    assertThat(b.held()).containsExactly("x");
    b.release(sections("x"));
    assertThat(node.isDone).isTrue();
  }

  @Test
  void aDeferringParticipantReportsThatItIsAliveWhenAskedAgain() {
    b.learn(ALL);
    b.request(sections("x"), 0);
    hears(new Ok(A, B, 1));
    hears(new Ok(C, B, 1));
    sent.clear();
    hears(new Req(A, B, 1, 1, 9, sections("x")));
    assertThat(sent).isEmpty();
    hears(new Req(A, B, 1, 1, 9, sections("x")));
    assertThat(sent).containsExactly(new Noted(B, A, 1));
  }

  @Test
  void silenceRaisesASuspicionAndAnyMessageEndsIt() {
    MutexTimes times = MutexNode.TIMES.withSuspectMs(10_000);
    MutexProtocol patient =
        new MutexProtocol(
            new MutexProtocol.Self(B, new LamportClock(), times, new Rng(1), true), node);
    patient.learn(ALL);
    patient.request(sections("x"), 0);
    for (long ms = 0; ms < 10_000; ms += 50) {
      patient.timer(ms * S / 1000);
    }
    patient.receive(new Noted(A, B, 1), 10 * S);
    assertThat(patient.fenced()).isEmpty();
    for (long ms = 10_000; ms < 15_000; ms += 50) {
      patient.timer(ms * S / 1000);
    }
    assertThat(patient.fenced()).containsExactly(C);
  }

  @Test
  void aRepeatedPartialReleaseOfAnUnknownRequestIsNoRequest() {
    b.learn(new View(3, ALL.admitted()).next().without(B).with(B));
    hears(new Rem(A, B, 1, sections("y")));
    sent.clear();
    hears(new FenceQ(C, B, A, 1));
    assertThat(sent).isEmpty();
  }

  /** Participant b came after a and was never asked by it, so its fence would mean nothing. */
  @Test
  void aMessageOfTheSuspectEndsASuspicionWithoutAFence() {
    for (boolean isHeard : new boolean[] {false, true}) {
      MutexNode young = new MutexNode(B, MutexProtocol::new, sent::add, events::add);
      young.protocol.learn(new View(3, ALL.admitted()).next().without(B).with(B));
      young.protocol.request(sections("x"), 0);
      young.protocol.suspect(A, 0);
      if (isHeard) {
        young.protocol.receive(new Noted(A, B, 1), 0);
      }
      sent.clear();
      young.protocol.timer(60 * S);
      assertThat(sent.contains(new FenceQ(B, C, A, 1))).isEqualTo(!isHeard);
    }
  }

  @Test
  void aMessageOfAFencedParticipantEndsNothing() {
    b.learn(ALL);
    hears(new FenceQ(C, B, A, 1));
    hears(new Noted(A, B, 1));
    assertThat(b.nextTimerNs()).isBetween(3 * S, 5 * S);
  }

  @Test
  void aViewThatStillListsTheSuspectEndsNothing() {
    b.learn(ALL);
    hears(new FenceQ(C, B, A, 1));
    b.learn(ALL.next().with(id("d")));
    assertThat(b.nextTimerNs()).isBetween(3 * S, 5 * S);
  }

  @Test
  void aParticipantThatIsOverAsksForNoFences() {
    List<Consumer<MutexProtocol>> ends =
        List.of(
            MutexProtocol::beginLeave,
            each -> each.receive(new Fenced(C, B), 0),
            each -> each.learn(ALL.next().without(B)));
    for (Consumer<MutexProtocol> end : ends) {
      MutexNode one = new MutexNode(B, MutexProtocol::new, sent::add, events::add);
      one.protocol.learn(ALL);
      one.protocol.receive(new FenceQ(C, B, A, 1), 0);
      assertThat(one.protocol.nextTimerNs()).isLessThan(Long.MAX_VALUE);
      end.accept(one.protocol);
      assertThat(one.protocol.nextTimerNs()).isEqualTo(Long.MAX_VALUE);
    }
  }

  @Test
  void aDeferredRequestOfAFencedParticipantIsNeverGranted() {
    b.learn(ALL);
    b.request(sections("x"), 0);
    hears(new Ok(A, B, 1));
    hears(new Ok(C, B, 1));
    hears(new Req(A, B, 1, 1, 9, sections("x")));
    hears(new FenceQ(C, B, A, 1));
    sent.clear();
    b.release(sections("x"));
    assertThat(sent).noneMatch(Ok.class::isInstance);
    assertThat(b.open(A)).isEmpty();
  }

  @Test
  void aLaterRequestOfAGhostShowsThatItHasGivenBack() {
    b.learn(ALL);
    hears(new Req(A, B, 1, 1, 1, sections("x")));
    b.learn(ALL.next().confined(A, sections("x")));
    assertThat(node.proposed).isEmpty();
    hears(new Req(A, B, 2, 1, 9, sections("x")));
    assertThat(node.proposed).containsExactly(new Confinement(A, Sections.NONE, ids(B)));
  }

  /** Only the silence while an answer is missing counts. */
  @Test
  void theSilenceBetweenRequestsRaisesNoSuspicion() {
    MutexTimes times = MutexNode.TIMES.withSuspectMs(10_000);
    for (boolean isAnswered : new boolean[] {false, true}) {
      MutexProtocol patient =
          new MutexProtocol(
              new MutexProtocol.Self(B, new LamportClock(), times, new Rng(1), true), node);
      patient.learn(ALL);
      patient.request(sections("x"), 0);
      patient.timer(5 * S);
      if (isAnswered) {
        patient.receive(new Ok(A, B, 1), 5 * S);
        patient.receive(new Ok(C, B, 1), 5 * S);
        patient.release(sections("x"));
      } else {
        patient.withdraw(MutexFailure.WITHDRAWN);
      }
      patient.request(sections("x"), 60 * S);
      patient.timer(61 * S);
      patient.timer(70 * S);
      assertThat(patient.fenced()).isEmpty();
      patient.timer(71 * S);
      assertThat(patient.fenced()).containsExactlyInAnyOrder(A, C);
    }
  }

  private void hears(MutexMessage message) {
    b.receive(message, 0);
  }

  private static SortedSet<String> sections(String... names) {
    return Sections.copyOf(List.of(names));
  }

  private static SortedSet<ProcessId> ids(ProcessId... ids) {
    return new TreeSet<>(List.of(ids));
  }

  private static ProcessId id(String robot) {
    return ProcessId.first(new RobotId(robot), 1);
  }
}
