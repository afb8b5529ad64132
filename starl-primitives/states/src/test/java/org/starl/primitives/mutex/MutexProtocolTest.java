package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexMessage.Ok;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;
import org.starl.primitives.mutex.MutexProtocol.Phase;

/** Tests one participant, message by message. */
class MutexProtocolTest {

  private static final long MS = 1_000_000;
  private static final ProcessId A = id("a");
  private static final ProcessId B = id("b");
  private static final ProcessId C = id("c");

  private final List<MutexMessage> sent = new ArrayList<>();
  private final List<MutexFact> events = new ArrayList<>();
  private final MutexNode node = new MutexNode(B, MutexProtocol::new, sent::add, events::add);
  private final MutexProtocol b = node.protocol;

  @Test
  void aSingleParticipantEntersAtOnce() {
    b.learn(View.closed(List.of(B)));
    b.request(sections("x"), 0);
    assertThat(b.held()).containsExactly("x");
    assertThat(sent).isEmpty();
  }

  @Test
  void aParticipantOutsideTheViewFailsAtOnce() {
    b.request(sections("x"), 0);
    assertThat(events).containsExactly(new MutexFact.Withdraw(B, 0, MutexFailure.NOT_REGISTERED));
    b.learn(View.closed(List.of(A, C)));
    b.request(sections("x"), 0);
    assertThat(b.phase()).isEqualTo(Phase.IDLE);
    assertThat(sent).isEmpty();
  }

  @Test
  void aParticipantEntersWithTheLastAnswer() {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections("x", "y"), 0);
    assertThat(sent)
        .containsExactly(
            new Req(B, A, 1, 1, 1, sections("x", "y")), new Req(B, C, 1, 1, 1, sections("x", "y")));
    hears(new Ok(A, B, 1));
    hears(new Ok(A, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
    hears(new Ok(C, B, 1));
    assertThat(b.held()).containsExactly("x", "y");
  }

  @Test
  void anAnswerToAnEarlierRequestHasNoEffect() {
    b.learn(View.closed(List.of(A, B)));
    b.request(sections("x"), 0);
    b.withdraw(MutexFailure.WITHDRAWN);
    b.request(sections("x"), 0);
    hears(new Ok(A, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
    hears(new Ok(A, B, 2));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
  }

  @Test
  void aDeferredRequestIsAnsweredOnce() {
    holds("x");
    hears(new Req(A, B, 1, 1, 9, sections("x")));
    b.release(sections("x"));
    assertThat(sent).contains(new Ok(B, A, 1));
    sent.clear();
    b.request(sections("y"), 0);
    b.withdraw(MutexFailure.WITHDRAWN);
    assertThat(sent).doesNotContain(new Ok(B, A, 1));
  }

  @Test
  void aViewIsLearnedOnce() {
    View both = View.closed(List.of(A, B));
    b.learn(both);
    b.learn(both);
    assertThat(events).containsExactly(new MutexFact.Learned(B, both));
  }

  @Test
  void eachFourthRepetitionAsksForALaterView() {
    b.learn(View.closed(List.of(A, B)));
    b.request(sections("x"), 0);
    for (int repetition = 1; repetition <= 8; repetition++) {
      b.timer(repetition * 2_000_000_000L);
      assertThat(node.refreshes).isEqualTo(repetition / 4);
    }
  }

  @Test
  void aRemovedParticipantIsIdleOnceItHasNotLeftBefore() {
    View all = View.closed(List.of(A, B));
    b.learn(all);
    b.learn(all.next().without(B));
    assertThat(node.isDone).isTrue();

    MutexNode leaving = new MutexNode(B, MutexProtocol::new, sent::add, events::add);
    leaving.protocol.learn(all);
    leaving.protocol.beginLeave();
    leaving.protocol.learn(all.next().without(B));
    assertThat(leaving.isDone).isFalse();
  }

  @Test
  void theBoundsAreThoseOfTheAlgorithm() {
    assertThat(MutexBounds.of(4, 100, 10)).isEqualTo(new MutexBounds(100, 10 + 3 * 120 + 20, 20));
    assertThat(MutexBounds.of(1, 100, 0)).isEqualTo(new MutexBounds(100, 0, 0));
  }

  @Test
  void onlyAnEndedParticipantMustRegister() {
    assertThat(MutexFailure.values())
        .filteredOn(MutexFailure::mustRegister)
        .containsExactly(MutexFailure.NOT_REGISTERED, MutexFailure.REMOVED, MutexFailure.FENCED);
  }

  @Test
  void theEarlierRequestGoesFirstAndTheLaterOneIsAnsweredAtTheRelease() {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections("x"), 0);
    sent.clear();
    hears(new Req(C, B, 1, 1, 1, sections("x")));
    assertThat(sent).as("equal times: the name decides").isEmpty();
    hears(new Req(A, B, 1, 1, 1, sections("x")));
    assertThat(sent).containsExactly(new Ok(B, A, 1));
    hears(new Ok(A, B, 1));
    hears(new Ok(C, B, 1));
    sent.clear();
    b.release(sections("x"));
    assertThat(sent)
        .containsExactly(
            new Rem(B, A, 1, Sections.NONE), new Rem(B, C, 1, Sections.NONE), new Ok(B, C, 1));
  }

  @Test
  void aPartialReleaseAnswersThoseWhoseSectionsAreFree() {
    holds("x", "y", "z");
    hears(new Req(A, B, 1, 1, 9, sections("x")));
    hears(new Req(C, B, 1, 1, 9, sections("x", "y")));
    assertThat(sent).isEmpty();
    b.release(sections("x"));
    assertThat(sent).contains(new Ok(B, A, 1), new Rem(B, A, 1, sections("y", "z")));
    assertThat(sent).doesNotContain(new Ok(B, C, 1));
    sent.clear();
    b.release(sections("y"));
    assertThat(sent).contains(new Ok(B, C, 1));
    assertThat(b.held()).containsExactly("z");
  }

  @Test
  void aHolderDefersARequestWithALowerTime() {
    holds("x");
    hears(new Req(A, B, 1, 1, 1, sections("x")));
    assertThat(sent).isEmpty();
  }

  @Test
  void aRequestForOtherSectionsIsAnsweredAtOnceAndAgainWhenRepeated() {
    holds("x");
    hears(new Req(A, B, 1, 1, 9, sections("y")));
    hears(new Req(A, B, 1, 1, 9, sections("y")));
    assertThat(sent).containsExactly(new Ok(B, A, 1), new Ok(B, A, 1));
    assertThat(b.open(A)).containsExactly("y");
  }

  @Test
  void staleAndWithdrawnRequestsAreNeverAnswered() {
    b.learn(View.closed(List.of(A, B)));
    hears(new Rem(A, B, 3, Sections.NONE));
    hears(new Req(A, B, 2, 1, 5, sections("x")));
    hears(new Req(A, B, 3, 1, 6, sections("x")));
    assertThat(sent).isEmpty();
    hears(new Req(A, B, 4, 1, 7, sections("x")));
    assertThat(sent).containsExactly(new Ok(B, A, 4));
  }

  @Test
  void aWithdrawnRequestIsNotAnsweredAtTheRelease() {
    holds("x");
    hears(new Req(A, B, 1, 1, 9, sections("x")));
    hears(new Rem(A, B, 1, Sections.NONE));
    b.release(sections("x"));
    assertThat(sent).doesNotContain(new Ok(B, A, 1));
  }

  @Test
  void aPartialReleaseShrinksTheOpenSections() {
    b.learn(View.closed(List.of(A, B)));
    hears(new Req(A, B, 1, 1, 5, sections("x", "y", "z")));
    hears(new Rem(A, B, 1, sections("y")));
    hears(new Rem(A, B, 1, sections("x", "y")));
    assertThat(b.open(A)).as("whatever the order of arrival").containsExactly("y");
  }

  @Test
  void aRequesterOutsideTheViewIsAskedBack() {
    b.learn(View.closed(List.of(A, B)));
    b.request(sections("x"), 0);
    hears(new Ok(A, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
    b.release(sections("x"));
    hears(new Req(C, B, 1, 2, 1, sections("x")));
    assertThat(b.known()).containsExactly(A, C);
    sent.clear();

    b.request(sections("x"), 0);
    assertThat(sent).hasSize(2);
    hears(new Ok(A, B, 2));
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
    hears(new Ok(C, B, 2));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
  }

  @Test
  void aNewRequesterIsAskedAtOnceDuringAWait() {
    b.learn(View.closed(List.of(A, B)));
    b.request(sections("x"), 0);
    sent.clear();
    hears(new Req(C, B, 1, 2, 9, sections("y")));
    assertThat(sent).containsExactly(new Req(B, C, 1, 1, 1, sections("x")), new Ok(B, C, 1));
    hears(new Ok(A, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
  }

  @Test
  void aViewRemovesTheNeedForUnlistedParticipants() {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections("x"), 0);
    hears(new Ok(A, B, 1));
    b.learn(view(4, A, B));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
  }

  @Test
  void anOlderViewHasNoEffect() {
    b.learn(view(4, A, B));
    b.learn(view(3, A, B, C));
    assertThat(b.known()).containsExactly(A);
  }

  @Test
  void aViewWithoutTheParticipantEndsItsRequestsForEver() {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections("x"), 0);
    b.learn(view(2, A, C));
    assertThat(events).contains(new MutexFact.Withdraw(B, 1, MutexFailure.REMOVED));
    b.learn(view(3, A, B, C));
    b.request(sections("x"), 0);
    assertThat(events).contains(new MutexFact.Withdraw(B, 0, MutexFailure.NOT_REGISTERED));
  }

  @Test
  void aRemovedHolderKeepsItsSectionsUntilTheRelease() {
    holds("x");
    b.learn(view(2, A, C));
    hears(new Req(A, B, 1, 1, 1, sections("x")));
    assertThat(sent).isEmpty();
    assertThat(b.held()).containsExactly("x");
    b.release(sections("x"));
    hears(new Req(A, B, 1, 1, 1, sections("x")));
    assertThat(sent).contains(new Ok(B, A, 1));
  }

  @Test
  void aLeavingParticipantStopsRequestsAndContinuesAnswers() {
    b.learn(View.closed(List.of(A, B)));
    b.beginLeave();
    b.request(sections("x"), 0);
    assertThat(b.phase()).isEqualTo(Phase.IDLE);
    hears(new Req(A, B, 1, 1, 1, sections("x")));
    assertThat(sent).containsExactly(new Ok(B, A, 1));
  }

  @Test
  void aRequestIsRepeatedWithGrowingPausesWhereAnswersAreMissing() {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections("x"), 0);
    hears(new Ok(A, B, 1));
    sent.clear();
    List<Long> repeatedAtMs = new ArrayList<>();
    for (long ms = 0; ms < 4_000; ms++) {
      b.timer(ms * MS);
      if (!sent.isEmpty()) {
        assertThat(sent).containsExactly(new Req(B, C, 1, 1, 1, sections("x")));
        repeatedAtMs.add(ms);
        sent.clear();
      }
    }
    assertThat(repeatedAtMs).containsExactly(250L, 625L, 1188L, 2032L, 3032L);
  }

  @Test
  void aRequestFailsAtItsDeadlineAndFreesTheOthers() {
    b.learn(View.closed(List.of(A, B)));
    b.request(sections("x"), 5 * MS);
    long deadlineNs = (5 + MutexNode.TIMES.deadlineMs()) * MS;
    hears(new Req(A, B, 1, 1, 9, sections("x")));
    sent.clear();
    b.timer(deadlineNs - 1);
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
    sent.clear();
    b.timer(deadlineNs);
    assertThat(events).contains(new MutexFact.Withdraw(B, 1, MutexFailure.DEADLINE));
    assertThat(sent).containsExactly(new Rem(B, A, 1, Sections.NONE), new Ok(B, A, 1));
    assertThat(b.nextTimerNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void timersRunOnlyForAWaitingRequest() {
    b.learn(View.closed(List.of(A, B)));
    assertThat(b.nextTimerNs()).isEqualTo(Long.MAX_VALUE);
    b.request(sections("x"), 5 * MS);
    assertThat(b.nextTimerNs()).isEqualTo(255 * MS);
    hears(new Ok(A, B, 1));
    assertThat(b.nextTimerNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void wrongCallsAreRefused() {
    holds("x");
    assertThatThrownBy(() -> b.request(sections("y"), 0))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("while CRITICAL");
    assertThatThrownBy(() -> b.release(sections("y")))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("release of [y] while holding [x]");
    assertThatThrownBy(() -> b.release(Sections.NONE)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(b::beginLeave).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> hears(new Ok(A, C, 1))).isInstanceOf(IllegalArgumentException.class);
    b.release(sections("x"));
    assertThatThrownBy(() -> b.request(Sections.NONE, 0))
        .isInstanceOf(IllegalArgumentException.class);
  }

  private void hears(MutexMessage message) {
    b.receive(message, 0);
  }

  private void holds(String... names) {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections(names), 0);
    hears(new Ok(A, B, 1));
    hears(new Ok(C, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
    sent.clear();
  }

  private static View view(long number, ProcessId... ids) {
    SortedMap<ProcessId, Long> admitted = new TreeMap<>();
    for (ProcessId id : ids) {
      admitted.put(id, 1L);
    }
    return new View(number, admitted);
  }

  private static SortedSet<String> sections(String... names) {
    return Sections.copyOf(List.of(names));
  }

  private static ProcessId id(String robot) {
    return ProcessId.first(new RobotId(robot), 1);
  }
}
