package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.MutexMessage.Kind;
import org.starl.primitives.mutex.MutexMessage.Noted;
import org.starl.primitives.mutex.MutexMessage.Ok;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;
import org.starl.primitives.mutex.MutexProtocol.Phase;
import org.starl.primitives.mutex.MutexProtocol.Resume;

/** Tests one participant, message by message, with requests for sequences. */
class SequenceProtocolTest {

  private static final ProcessId A = id("a");
  private static final ProcessId B = id("b");
  private static final ProcessId C = id("c");

  /** Earlier than a first request of {@link #B}: the time is equal, the name lower. */
  private static final int EARLIER = 1;

  private static final int LATER = 9;

  private final List<MutexMessage> sent = new ArrayList<>();
  private final List<MutexFact> events = new ArrayList<>();
  private final MutexNode node = new MutexNode(B, MutexProtocol::new, sent::add, events::add);
  private final MutexProtocol b = node.protocol;

  @Test
  void aSequenceIsGrantedSectionBySectionFromItsFirst() {
    asks("y", "x", "z");
    assertThat(sent)
        .contains(new Req(B, A, 1, 1, 1, wish(Kind.SEQUENCE, sections("x", "y", "z"))))
        .hasSize(2);
    hears(new Ok(C, B, 1));
    hears(new Ok(A, B, 1, sections("x")));
    assertThat(b.held()).as("x is the second").isEmpty();
    hears(new Ok(A, B, 1, sections("x", "y")));
    assertThat(b.held()).containsExactly("x", "y");
    assertThat(b.phase()).as("it waits for z").isEqualTo(Phase.TRYING);
    assertThat(b.missing()).containsExactly(A);
    hears(new Ok(A, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
    assertThat(events)
        .contains(
            new MutexFact.OdMutex(B, 1, sections("x", "y")),
            new MutexFact.OdMutex(B, 1, sections("x", "y", "z")));
  }

  @Test
  void aSetIsNotGrantedInParts() {
    b.learn(View.closed(List.of(A, B)));
    b.request(sections("x", "y"), 0);
    hears(new Ok(A, B, 1, sections("x")));
    assertThat(b.held()).isEmpty();
  }

  @Test
  void aHolderConsentsToTheRestOfASequenceAndToNothingOfASet() {
    holds("x");
    hears(sequence(A, LATER, "x", "y"));
    assertThat(sent).containsExactly(new Ok(B, A, 1, sections("y")));
    assertThat(events).contains(new MutexFact.Grant(B, A, 1, sections("y")));
    assertThat(b.open(A)).containsExactly("y");
    sent.clear();
    hears(new Req(C, B, 1, 1, LATER, sections("x", "y")));
    assertThat(sent).isEmpty();
    b.release(sections("x"));
    assertThat(sent).contains(new Ok(B, A, 1), new Ok(B, C, 1));
  }

  @Test
  void aRepeatedRequestIsAnsweredWithAllConsentsSoFar() {
    holds("x");
    hears(sequence(A, LATER, "x", "y"));
    hears(sequence(A, LATER, "x", "y"));
    assertThat(sent)
        .containsExactly(new Ok(B, A, 1, sections("y")), new Ok(B, A, 1, sections("y")));
    assertThat(events).filteredOn(MutexFact.Grant.class::isInstance).hasSize(1);
  }

  @Test
  void aRepeatedRequestWithoutConsentIsNoted() {
    holds("x");
    hears(sequence(A, LATER, "x"));
    assertThat(sent).isEmpty();
    hears(sequence(A, LATER, "x"));
    assertThat(sent).containsExactly(new Noted(B, A, 1));
  }

  @Test
  void eachSectionIsHandedOverAtItsRelease() {
    holds("x", "y");
    hears(sequence(A, LATER, "x", "y"));
    assertThat(sent).isEmpty();
    b.release(sections("x"));
    assertThat(sent).containsOnlyOnce(new Ok(B, A, 1, sections("x")));
    sent.clear();
    b.release(sections("y"));
    assertThat(sent).containsOnlyOnce(new Ok(B, A, 1));
  }

  @Test
  void theEarlierOfTwoWaitingSequencesGoesFirst() {
    asks("x", "y");
    sent.clear();
    hears(sequence(C, LATER, "y", "z"));
    hears(sequence(A, EARLIER, "y", "z"));
    assertThat(sent).containsExactly(new Ok(B, C, 1, sections("z")), new Ok(B, A, 1));
  }

  @Test
  void aWaitingHolderConsentsToNothingOfALateRequestAndTellsIt() {
    holdsFirst("x", "y");
    hears(sequence(A, EARLIER, "x", "z"));
    assertThat(sent).containsExactly(new Noted(B, A, 1, 1));
    sent.clear();
    hears(sequence(C, LATER, "x", "z"));
    assertThat(sent).as("not late").containsExactly(new Ok(B, C, 1, sections("z")));
  }

  @Test
  void aHolderThatWaitsForNothingIsNotAhead() {
    holds("x");
    hears(sequence(A, EARLIER, "x", "z"));
    assertThat(sent).containsExactly(new Ok(B, A, 1, sections("z")));
  }

  @Test
  void aLateRequestFailsIfItHoldsNothing() {
    asks("x", "y");
    sent.clear();
    hears(new Noted(A, B, 1));
    hears(new Noted(A, B, 2, 1));
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
    hears(new Noted(A, B, 1, 1));
    assertThat(events).contains(new MutexFact.Withdraw(B, 1, MutexFailure.LATE));
    assertThat(sent).containsExactly(rem(A), rem(C));
    assertThat(b.phase()).isEqualTo(Phase.IDLE);
  }

  @Test
  void aWaitingHolderIsNotLate() {
    holdsFirst("x", "y");
    hears(new Noted(A, B, 1, 1));
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
    assertThat(b.wanted()).containsExactly("x", "y");
  }

  @Test
  void aWithdrawnSequenceKeepsWhatItHolds() {
    holdsFirst("x", "y");
    hears(sequence(C, LATER, "x", "y"));
    sent.clear();
    b.withdraw(MutexFailure.WITHDRAWN);
    assertThat(b.held()).containsExactly("x");
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
    assertThat(sent)
        .containsExactly(
            new Rem(B, A, 1, sections("x")),
            new Rem(B, C, 1, sections("x")),
            new Ok(B, C, 1, sections("y")));
    b.release(sections("x"));
    assertThat(b.phase()).isEqualTo(Phase.IDLE);
  }

  @Test
  void aWaitingHolderDoesNotFailAtTheDeadline() {
    holdsFirst("x", "y");
    b.timer(MutexNode.TIMES.deadlineMs() * 1_000_000);
    assertThat(b.phase()).isEqualTo(Phase.TRYING);
    assertThat(b.nextTimerNs()).isGreaterThan(MutexNode.TIMES.deadlineMs() * 1_000_000);
  }

  @Test
  void whileAGhostIsListedTheFirstGrantIsOfAll() {
    View view = View.closed(List.of(A, B, C));
    b.learn(view.next().confined(C, sections("g")));
    b.request(List.of("x", "y"), true, 0);
    hears(new Ok(A, B, 1, sections("x")));
    assertThat(b.held()).isEmpty();
    hears(new Ok(A, B, 1));
    assertThat(b.held()).containsExactly("x", "y");
  }

  @Test
  void aHolderGoesOnSectionBySectionBesideAGhost() {
    asks("x", "y", "z");
    hears(new Ok(A, B, 1, sections("x")));
    hears(new Ok(C, B, 1));
    assertThat(b.held()).containsExactly("x");
    b.learn(b.view().next().confined(C, sections("g")));
    hears(new Ok(A, B, 1, sections("x", "y")));
    assertThat(b.held()).containsExactly("x", "y");
  }

  @Test
  void aGhostsSectionIsNotEntered() {
    View view = View.closed(List.of(A, B, C));
    asks("x", "y");
    b.learn(view.next().confined(C, sections("y")));
    hears(new Ok(A, B, 1));
    assertThat(b.held()).isEmpty();
    b.learn(b.view().next().confined(C, Sections.NONE));
    assertThat(b.held()).containsExactly("x", "y");
  }

  @Test
  void aHolderTakesNothingOnItsWayToAGhost() {
    holdsFirst("x", "y", "g");
    b.learn(b.view().next().confined(C, sections("g")));
    hears(new Ok(A, B, 1));
    assertThat(b.held()).as("the ghost's way may lead through y").containsExactly("x");
    b.timer(2 * MutexNode.TIMES.occupiedMs() * 1_000_000);
    assertThat(b.phase()).as("it keeps its turn for the rest").isEqualTo(Phase.TRYING);
    b.learn(b.view().next().confined(C, Sections.NONE));
    assertThat(b.held()).containsExactly("g", "x", "y");
  }

  @Test
  void aHolderGoesOnTowardsAGhostWhoseRobotIsListedAgain() {
    holdsFirst("x", "y", "g");
    ProcessId next = ProcessId.first(C.robot(), 2);
    b.learn(b.view().next().confined(C, sections("g")).with(next));
    hears(new Ok(A, B, 1));
    assertThat(b.held()).as("the new process has a say").containsExactly("x");
    hears(new Ok(next, B, 1));
    assertThat(b.held()).containsExactly("x", "y");
  }

  @Test
  void aSetAndASequenceExcludeEachOther() {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(sections("x", "y"), 0);
    sent.clear();
    hears(sequence(C, LATER, "y", "z"));
    assertThat(sent).as("later than the set").containsExactly(new Ok(B, C, 1, sections("z")));
    hears(sequence(A, EARLIER, "x", "y"));
    assertThat(sent).as("earlier than the set").contains(new Ok(B, A, 1));
  }

  @Test
  void aSetWaitsForAllOfAWaitingSequence() {
    asks("x", "y");
    sent.clear();
    hears(new Req(C, B, 1, 1, LATER, sections("y", "z")));
    assertThat(sent).isEmpty();
    hears(new Req(A, B, 1, 1, EARLIER, sections("y", "z")));
    assertThat(sent).containsExactly(new Ok(B, A, 1));
  }

  // ---------------------------------------------------------------- resuming

  @Test
  void aNewProcessConsentsToNothingOfWhatItClaims() {
    takesOver("x", "x", "y");
    b.request(List.of("q"), true, 0);
    b.withdraw(MutexFailure.WITHDRAWN);
    sent.clear();
    hears(sequence(A, EARLIER, "x", "y", "z"));
    assertThat(sent).containsExactly(new Ok(B, A, 1, sections("z")));
    sent.clear();
    hears(new Req(C, B, 1, 1, EARLIER, sections("y")));
    assertThat(sent).isEmpty();
  }

  @Test
  void aRequestForTheClaimsResumesAndAnotherOneDoesNot() {
    takesOver("x", "x", "y");
    b.request(List.of("x", "y"), true, 0);
    assertThat(sent).contains(new Req(B, A, 1, 1, 1, wish(Kind.RESUMED, sections("x", "y"))));
    b.withdraw(MutexFailure.WITHDRAWN);
    sent.clear();
    b.request(List.of("x", "z"), true, 0);
    assertThat(sent).contains(new Req(B, A, 2, 1, 2, wish(Kind.SEQUENCE, sections("x", "z"))));
  }

  @Test
  void aResumingProcessConsentsToOneThatIsAhead() {
    takesOver("x", "x", "y");
    b.request(List.of("x", "y"), true, 0);
    hears(sequence(A, LATER, "y", "z"));
    hears(sequence(C, LATER, "y"));
    sent.clear();
    hears(new Noted(A, B, 1, 1));
    assertThat(b.phase()).as("it is not late").isEqualTo(Phase.TRYING);
    assertThat(sent).containsExactly(new Ok(B, A, 1));
    assertThat(node.consentedTo).as("c is not ahead").doesNotContainKey(C);
  }

  @Test
  void whoWasAheadIsNotAheadWithItsNextRequest() {
    takesOver("x", "x", "y");
    b.request(List.of("x", "y"), true, 0);
    hears(new Noted(A, B, 1, 1));
    hears(sequence(A, LATER, "y", "z"));
    sent.clear();
    hears(new Rem(A, B, 1, Sections.NONE));
    hears(new Req(A, B, 2, 1, LATER + 1, wish(Kind.SEQUENCE, sections("y"))));
    assertThat(sent).isEmpty();
    hears(new Noted(A, B, 1, 2));
    assertThat(sent).as("ahead again").containsExactly(new Ok(B, A, 2));
  }

  @Test
  void whoHasToldThatItIsAheadStaysAheadUntilItHasAll() {
    takesOver("x", "x", "y");
    b.request(List.of("x", "y"), true, 0);
    sent.clear();
    hears(resumed(A, EARLIER, "x", "y"));
    assertThat(sent).containsExactly(new Noted(B, A, 1, 1));
    sent.clear();
    b.takeOver(new Resume(Sections.NONE, sections("x", "y")));
    hears(resumed(A, EARLIER, "x", "y"));
    assertThat(sent).containsExactly(new Noted(B, A, 1, 1));
  }

  @Test
  void ofTwoInTheWayOfEachOtherNoneConsents() {
    takesOver("x", "x", "y");
    b.request(List.of("x", "y"), true, 0);
    hears(resumed(A, EARLIER, "y", "x"));
    assertThat(sent).contains(new Noted(B, A, 1, 1));
    sent.clear();
    hears(new Noted(A, B, 1, 1));
    hears(resumed(A, EARLIER, "y", "x"));
    assertThat(sent).containsExactly(new Noted(B, A, 1, 1));
    assertThat(node.consentedTo).doesNotContainKey(A);
  }

  @Test
  void ofTwoResumingProcessesTheEarlierGoesFirst() {
    takesOver("x", "x", "y");
    b.request(List.of("x", "y"), true, 0);
    sent.clear();
    hears(resumed(C, LATER, "y"));
    assertThat(sent).isEmpty();
    hears(resumed(A, EARLIER, "y"));
    assertThat(sent).containsExactly(new Ok(B, A, 1));
  }

  @Test
  void aResumingProcessIsAheadOfAnotherOneThatWantsWhereItStands() {
    takesOver("x", "x", "y");
    b.request(List.of("x", "y"), true, 0);
    sent.clear();
    hears(resumed(A, EARLIER, "x", "z"));
    assertThat(sent).containsExactly(new Ok(B, A, 1, sections("z")), new Noted(B, A, 1, 1));
  }

  @Test
  void aWaitingHolderIsAheadOfAResumingProcess() {
    holdsFirst("x", "y");
    hears(resumed(C, LATER, "x", "y"));
    assertThat(sent).containsExactly(new Noted(B, C, 1, 1));
  }

  @Test
  void aWaitingHolderElsewhereLetsAResumingProcessPass() {
    holdsFirst("x", "y");
    hears(resumed(C, LATER, "y"));
    assertThat(sent).containsExactly(new Ok(B, C, 1));
  }

  @Test
  void aWaitingRequestGivesWayToAResumingProcess() {
    asks("x", "y");
    sent.clear();
    hears(resumed(C, LATER, "z"));
    assertThat(b.phase()).as("it wants nothing of it").isEqualTo(Phase.TRYING);
    hears(resumed(C, 2, LATER, "y"));
    assertThat(events).contains(new MutexFact.Withdraw(B, 1, MutexFailure.LATE));
    assertThat(sent).endsWith(new Ok(B, C, 2));
  }

  @Test
  void aReleaseEndsTheClaim() {
    takesOver("x", "x", "y");
    b.request(List.of("x", "y"), true, 0);
    hears(new Ok(A, B, 1, sections("x")));
    hears(new Ok(C, B, 1));
    b.release(sections("x"));
    assertThat(b.resume()).isEqualTo(new Resume(Sections.NONE, sections("y")));
    hears(new Ok(A, B, 1));
    b.release(sections("y"));
    assertThat(b.resume().isOver()).isTrue();
  }

  @Test
  void aSectionThatTheBodyHasLeftIsHandedOverAtOnce() {
    takesOver("x", "x", "y");
    hears(sequence(A, LATER, "x"));
    assertThat(sent).isEmpty();
    b.leave(sections("x"));
    assertThat(sent).containsExactly(new Ok(B, A, 1));
  }

  @Test
  void aFencedHolderWaitsForTheViewThatRemovesItAndLeavesTheRestToItsNextProcess() {
    holdsFirst("x", "y");
    events.clear();
    hears(new MutexMessage.Fenced(A, B));
    assertThat(events).as("a member still, which holds x").isEmpty();
    b.learn(View.closed(List.of(A)).next().next().next());
    assertThat(events).contains(new MutexFact.Withdraw(B, 1, MutexFailure.REMOVED));
    assertThat(b.held()).containsExactly("x");
    assertThat(b.rest()).isEqualTo(new Resume(sections("x"), sections("x", "y")));
  }

  @Test
  void aRequestForASequenceGivesNoSayOverWhatItsProcessHeldBefore() {
    b.learn(new View(4, new TreeMap<>(Map.of(A, 1L, B, 4L))));
    hears(sequence(A, EARLIER, "x", "y"));
    assertThat(b.hasSayOver(A, 1)).as("a may hold x by older consents").isFalse();
    hears(new Req(A, B, 2, 1, LATER, sections("x")));
    assertThat(b.hasSayOver(A, 1)).as("a set is entered at once").isTrue();
  }

  private void takesOver(String stands, String... claims) {
    b.takeOver(new Resume(sections(stands), sections(claims)));
    b.learn(View.closed(List.of(A, B, C)));
  }

  private void asks(String... names) {
    b.learn(View.closed(List.of(A, B, C)));
    b.request(List.of(names), true, 0);
  }

  private void holds(String... names) {
    asks(names);
    hears(new Ok(A, B, 1));
    hears(new Ok(C, B, 1));
    assertThat(b.phase()).isEqualTo(Phase.CRITICAL);
    sent.clear();
    events.clear();
  }

  /** It holds the first of {@code names}, and waits for the answer of a to the others. */
  private void holdsFirst(String... names) {
    asks(names);
    hears(new Ok(A, B, 1, sections(names[0])));
    hears(new Ok(C, B, 1));
    assertThat(b.held()).containsExactly(names[0]);
    sent.clear();
    events.clear();
  }

  private void hears(MutexMessage message) {
    b.receive(message, 0);
  }

  private static MutexMessage.Wish wish(Kind kind, SortedSet<String> waits) {
    return new MutexMessage.Wish(kind, waits, Sections.NONE);
  }

  private static Req sequence(ProcessId from, long ts, String... names) {
    return new Req(from, B, 1, 1, ts, wish(Kind.SEQUENCE, sections(names)));
  }

  private static Req resumed(ProcessId from, long ts, String... names) {
    return resumed(from, 1, ts, names);
  }

  private static Req resumed(ProcessId from, int num, long ts, String... names) {
    return new Req(from, B, num, 1, ts, wish(Kind.RESUMED, sections(names)));
  }

  private static Rem rem(ProcessId to) {
    return new Rem(B, to, 1, Sections.NONE);
  }

  private static SortedSet<String> sections(String... names) {
    return Sections.copyOf(List.of(names));
  }

  private static ProcessId id(String robot) {
    return ProcessId.first(new RobotId(robot), 1);
  }
}
