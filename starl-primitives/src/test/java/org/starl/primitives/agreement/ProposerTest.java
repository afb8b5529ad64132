package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Vote;
import org.starl.random.Rng;

class ProposerTest {

  private static final long NS_PER_MS = 1_000_000;
  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");
  private static final ProcessId ME = ProcessId.first(A, 7);
  private static final ProcessId RIVAL = ProcessId.first(B, 9);
  private static final Ballot FIRST = new Ballot(1, ME);
  private static final Value MINE = Value.of(new byte[] {1});
  private static final Value OLD = Value.of(new byte[] {2});
  private static final Value OLDER = Value.of(new byte[] {3});

  private record Sent(RobotId to, SynodMessage message) {}

  private final List<Sent> sent = new ArrayList<>();
  private @Nullable Value chosen;
  private final Proposer proposer =
      new Proposer(
          ME,
          Participants.of(A, B, C),
          SynodTiming.DEFAULT,
          new Rng(1),
          (to, message) -> sent.add(new Sent(to, message)),
          (value, number) -> chosen = value);

  @Test
  void aRefusalAndSilenceLeadToAHigherBallot() {
    begin();
    proposer.promise(A, promise(null), 1);
    proposer.nack(B, new Nack(1, FIRST, new Ballot(5, RIVAL)), 2);
    sent.clear();
    for (long ms = 0; ms < 2_000; ms++) {
      proposer.timer(ms * NS_PER_MS);
    }
    assertThat(questions(Prepare.class))
        .isNotEmpty()
        .allSatisfy(
            question -> assertThat(((Prepare) question.message()).ballot().round()).isEqualTo(6));
  }

  @Test
  void aMajorityOfPromisesAndThenOfVotesDecides() {
    begin();
    proposer.promise(A, promise(null), 1);
    assertThat(questions(Accept.class)).isEmpty();
    proposer.promise(B, promise(null), 2);
    assertThat(questions(Accept.class))
        .containsExactly(
            new Sent(A, new Accept(1, FIRST, MINE)),
            new Sent(B, new Accept(1, FIRST, MINE)),
            new Sent(C, new Accept(1, FIRST, MINE)));
    proposer.accepted(C, new Accepted(1, FIRST));
    assertThat(chosen).isNull();
    proposer.accepted(C, new Accepted(1, FIRST));
    assertThat(chosen).as("one acceptor counts once").isNull();
    proposer.accepted(A, new Accepted(1, FIRST));
    assertThat(chosen).isEqualTo(MINE);
    assertThat(proposer.isIdle()).isTrue();
    assertThat(proposer.wakeAtNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void theVoteOfTheHighestBallotReplacesTheOwnValue() {
    begin();
    Proposer unlucky = proposer;
    unlucky.nack(A, new Nack(1, FIRST, new Ballot(4, RIVAL)), 1);
    unlucky.nack(B, new Nack(1, FIRST, new Ballot(4, RIVAL)), 1);
    unlucky.timer(unlucky.wakeAtNs());
    Ballot next = new Ballot(5, ME);
    assertThat(questions(Prepare.class)).contains(new Sent(C, new Prepare(1, next, Value.EMPTY)));
    unlucky.promise(B, new Promise(1, next, new Vote(new Ballot(4, RIVAL), OLD), List.of()), 2);
    unlucky.promise(C, new Promise(1, next, new Vote(new Ballot(3, RIVAL), OLDER), List.of()), 2);
    assertThat(questions(Accept.class)).contains(new Sent(A, new Accept(1, next, OLD)));
  }

  @Test
  void answersToAnEarlierBallotDoNotCountForTheNext() {
    begin();
    proposer.promise(C, promise(null), 1);
    defeat(FIRST);
    Ballot second = new Ballot(2, ME);
    proposer.promise(A, new Promise(1, second, null, List.of()), 1);
    assertThat(questions(Accept.class)).isEmpty();
    proposer.promise(B, new Promise(1, second, null, List.of()), 1);
    proposer.accepted(C, new Accepted(1, second));
    defeat(second);
    Ballot third = new Ballot(3, ME);
    proposer.promise(A, new Promise(1, third, null, List.of()), 1);
    proposer.promise(B, new Promise(1, third, null, List.of()), 1);
    proposer.accepted(A, new Accepted(1, third));
    assertThat(chosen).isNull();
  }

  @Test
  void aRefusalWhileItPausesHasNoEffect() {
    begin();
    proposer.nack(A, new Nack(1, FIRST, FIRST), 0);
    proposer.nack(B, new Nack(1, FIRST, FIRST), 0);
    long wakeAtNs = proposer.wakeAtNs();
    proposer.nack(C, new Nack(1, FIRST, new Ballot(9, RIVAL)), 5);
    assertThat(proposer.wakeAtNs()).isEqualTo(wakeAtNs);
  }

  @Test
  void pausesGrowUpToTheirBound() {
    begin();
    SynodTiming timing = SynodTiming.DEFAULT;
    long nowNs = 0;
    for (int defeats = 1; defeats <= 30; defeats++) {
      Ballot refused = new Ballot(defeats, ME);
      proposer.nack(A, new Nack(1, refused, FIRST), nowNs);
      proposer.nack(B, new Nack(1, refused, FIRST), nowNs);
      long pauseNs = proposer.wakeAtNs() - nowNs;
      long meanMs =
          (long) Math.min(timing.backoffMs() * Math.pow(2, defeats - 1), timing.maxBackoffMs());
      assertThat(pauseNs).isBetween(meanMs * NS_PER_MS / 2, meanMs * NS_PER_MS * 3 / 2);
      nowNs = proposer.wakeAtNs();
      proposer.timer(nowNs);
    }
  }

  /** Two of three refuse {@code ballot}; begins the next one. */
  private void defeat(Ballot ballot) {
    proposer.nack(A, new Nack(1, ballot, ballot), 1);
    proposer.nack(B, new Nack(1, ballot, ballot), 1);
    proposer.timer(proposer.wakeAtNs());
  }

  @Test
  void oneRefusalOfThreeIsNoDefeat() {
    begin();
    proposer.nack(A, new Nack(1, FIRST, new Ballot(4, RIVAL)), 1);
    proposer.promise(B, promise(null), 2);
    proposer.promise(C, promise(null), 3);
    assertThat(questions(Accept.class)).hasSize(3);
  }

  @Test
  void questionsAreRepeatedOnlyToSilentAcceptors() {
    begin();
    proposer.promise(B, promise(null), 1);
    sent.clear();
    proposer.timer(249 * NS_PER_MS);
    assertThat(sent).isEmpty();
    proposer.timer(250 * NS_PER_MS);
    assertThat(sent)
        .containsExactly(
            new Sent(A, new Prepare(1, FIRST, Value.EMPTY)),
            new Sent(C, new Prepare(1, FIRST, Value.EMPTY)));
    assertThat(proposer.wakeAtNs()).isEqualTo((250 + 375) * NS_PER_MS);
  }

  @Test
  void answersToOtherBallotsOrFromOtherRobotsDoNotCount() {
    begin();
    proposer.promise(A, new Promise(1, new Ballot(2, ME), null, List.of()), 1);
    proposer.promise(B, new Promise(2, FIRST, null, List.of()), 1);
    proposer.promise(new RobotId("stranger"), promise(null), 1);
    proposer.promise(C, promise(null), 1);
    assertThat(questions(Accept.class)).isEmpty();
  }

  @Test
  void noBallotIsUsedTwiceEvenForAnotherNumber() {
    begin();
    proposer.stop();
    proposer.propose(2, Value.EMPTY, wishes -> MINE, 5);
    assertThat(questions(Prepare.class))
        .contains(new Sent(A, new Prepare(2, new Ballot(2, ME), Value.EMPTY)));
  }

  @Test
  void wishesHeardReachTheChooserOnceEach() {
    List<Value> heard = new ArrayList<>();
    proposer.propose(
        1,
        MINE,
        wishes -> {
          heard.addAll(wishes);
          return MINE;
        },
        0);
    proposer.promise(A, new Promise(1, FIRST, null, List.of(MINE, OLD)), 1);
    proposer.promise(B, new Promise(1, FIRST, null, List.of(OLDER, OLD)), 1);
    assertThat(heard).containsExactlyInAnyOrder(MINE, OLD, OLDER);
  }

  private void begin() {
    proposer.propose(1, Value.EMPTY, wishes -> MINE, 0);
  }

  private static Promise promise(@Nullable Vote vote) {
    return new Promise(1, FIRST, vote, List.of());
  }

  private List<Sent> questions(Class<? extends SynodMessage> kind) {
    return sent.stream().filter(each -> kind.isInstance(each.message())).toList();
  }
}
