package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Query;
import org.starl.primitives.agreement.SynodMessage.Vote;
import org.starl.shape.Json;
import org.starl.shape.Shapes;
import org.starl.spec.Monitors;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/** The rules on messages written by hand, among the acceptors a, b, c and d. */
class SynodSpecTest {

  private static final Instance CHANNEL = Instance.of(AgreementFact.PRIMITIVE, "x");
  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");
  private static final RobotId D = new RobotId("d");
  private static final Ballot LOW = new Ballot(1, ProcessId.first(A, 1));
  private static final Ballot HIGH = new Ballot(2, ProcessId.first(B, 1));
  private static final Value X = Value.of(new byte[] {1});
  private static final Value Y = Value.of(new byte[] {2});

  private final Monitors monitors = new Monitors(List.of(new SynodSpec()));

  SynodSpecTest() {
    for (RobotId acceptor : List.of(A, B, C, D)) {
      sends(A, acceptor, new Prepare(1, LOW, Value.EMPTY));
    }
  }

  @Test
  void aDecisionByThreeOfFourKeepsEveryRule() {
    promise(LOW, null, A, B, C);
    sends(A, A, new Accept(1, LOW, X));
    vote(LOW, A, B, C);
    promise(HIGH, new Vote(LOW, X), B, C);
    promise(HIGH, null, D);
    sends(B, B, new Accept(1, HIGH, X));
    sends(1, A, D, new Decided(1, X));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 0, synod.Answers 0");
    assertThat(monitors.report().neverChecked()).isEmpty();
  }

  @Test
  void eachChannelHasRulesOfItsOwn() {
    for (RobotId robot : List.of(A, B, C)) {
      Instance other = Instance.of("registration", "x");
      Promise elsewhere = new Promise(1, HIGH, null, List.of());
      monitors.observe(new Sent(0, robot, A.name(), other, 1, 1, SynodMessage.SHAPE, elsewhere));
    }
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 0, synod.Answers 0");
    sends(B, B, new Accept(1, HIGH, X));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 1, synod.Answers 0");
  }

  @Test
  void otherMessagesHaveNoRule() {
    Json other = new Json("{}");
    monitors.observe(new Sent(0, A, B.name(), CHANNEL, 1, 1, Shapes.JSON, other));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 0, synod.Answers 0");
  }

  @Test
  void anAcceptorThatForgetsAPromiseViolatesBallots() {
    promise(HIGH, null, C);
    monitors.observe(new Fault(0, C, Fault.CRASH, ""));
    monitors.observe(new Fault(0, C, Fault.RESTART, "lost"));
    promise(LOW, null, C);
    assertThat(monitors.report().violations(SynodSpec.BALLOTS)).isEqualTo(1);
    assertThat(violations())
        .isEqualTo("synod.Ballots 1, synod.Votes 0, synod.Quorums 0, synod.Answers 0");
  }

  @Test
  void anAcceptorThatForgetsItsVoteViolatesVotes() {
    vote(LOW, C);
    promise(HIGH, null, C);
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 1, synod.Quorums 0, synod.Answers 0");
  }

  @Test
  void aPromiseWithAnotherValueThanTheBallotsViolatesVotes() {
    promise(LOW, null, A, B, C);
    sends(A, A, new Accept(1, LOW, X));
    promise(HIGH, new Vote(LOW, Y), C);
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 1, synod.Quorums 0, synod.Answers 0");
  }

  @Test
  void aProposalAfterPromisesOfHalfViolatesQuorums() {
    promise(LOW, null, A, B);
    sends(A, A, new Accept(1, LOW, X));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 1, synod.Answers 0");
  }

  @Test
  void aProposalAgainstTheVotesOfAMajorityViolatesQuorums() {
    promise(HIGH, new Vote(LOW, X), A, B, C);
    sends(B, A, new Accept(1, HIGH, Y));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 1, synod.Answers 0");
  }

  @Test
  void twoValuesInOneBallotViolateQuorums() {
    promise(LOW, null, A, B, C);
    sends(A, A, new Accept(1, LOW, X));
    sends(A, B, new Accept(1, LOW, Y));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 1, synod.Answers 0");
  }

  @Test
  void aBallotOfAnotherRobotViolatesQuorums() {
    promise(LOW, null, A, B, C);
    sends(D, A, new Accept(1, LOW, X));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 1, synod.Answers 0");
  }

  @Test
  void aDecisionByHalfViolatesQuorums() {
    promise(LOW, null, A, B, C);
    sends(A, A, new Accept(1, LOW, X));
    vote(LOW, A, B);
    sends(A, D, new Decided(1, X));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 1, synod.Answers 0");
  }

  @Test
  void anAcceptorThatDoesNotRefuseALowerBallotViolatesAnswers() {
    promise(HIGH, null, C);
    hears(1, C, A, new Prepare(1, LOW, Value.EMPTY));
    hears(2, C, A, new Accept(1, LOW, X));
    hears(3, C, B, new Prepare(1, HIGH, Value.EMPTY)); // the same again
    sends(3, C, A, new Nack(1, LOW, HIGH)); // late
    sends(4, C, A, new Nack(1, LOW, HIGH));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 0, synod.Answers 2");
  }

  @Test
  void anAcceptorThatRefusesABallotThatIsNotLowerViolatesBallots() {
    sends(1, C, A, new Nack(1, LOW, HIGH));
    assertThat(monitors.report().violations(SynodSpec.BALLOTS)).isZero();
    sends(2, C, A, new Nack(1, LOW, LOW));
    assertThat(monitors.report().violations(SynodSpec.BALLOTS)).isEqualTo(1);
  }

  @Test
  void whoKnowsADecisionAndDoesNotTellItViolatesAnswers() {
    promise(LOW, null, A, B, C);
    sends(A, A, new Accept(1, LOW, X));
    vote(LOW, A, B, C);
    hears(1, C, A, new Decided(1, X));
    for (SynodMessage question :
        List.of(new Query(0), new Prepare(1, HIGH, Value.EMPTY), new Accept(1, HIGH, X))) {
      hears(2, C, B, question);
      sends(2, C, B, new Decided(1, X));
      hears(3, C, B, question);
      sends(3, C, D, new Decided(1, X)); // another robot
    }
    hears(4, C, B, new Query(1));
    monitors.observe(new Fault(4, C, Fault.CRASH, ""));
    hears(5, C, B, new Query(0)); // it may have forgotten
    hears(6, C, B, new Query(0));
    assertThat(violations())
        .isEqualTo("synod.Ballots 0, synod.Votes 0, synod.Quorums 0, synod.Answers 3");
  }

  @Test
  void aBallotThatDoesNotAskAllAcceptorsAtOnceViolatesAsks() {
    List<RobotId> all = List.of(A, B, C, D);
    all.forEach(acceptor -> sends(1, B, acceptor, new Prepare(1, HIGH, Value.EMPTY)));
    all.forEach(acceptor -> sends(2, A, acceptor, new Accept(1, LOW, X)));
    all.subList(0, 3).forEach(acceptor -> sends(3, B, acceptor, new Accept(1, HIGH, X)));
    sends(4, B, D, new Accept(1, HIGH, X));
    sends(5, B, D, new Accept(1, HIGH, X)); // again
    assertThat(monitors.report().checks(SynodSpec.ASKS)).isGreaterThan(8);
    assertThat(monitors.report().violations(SynodSpec.ASKS)).isEqualTo(1);
  }

  @Test
  void aQuestionToAnAcceptorThatHasAnsweredViolatesAsks() {
    List<RobotId> all = List.of(A, B, C, D);
    all.forEach(acceptor -> sends(1, B, acceptor, new Prepare(1, HIGH, Value.EMPTY)));
    sends(2, B, D, new Prepare(1, HIGH, Value.EMPTY)); // again
    hears(3, B, D, new Promise(1, HIGH, null, List.of()));
    all.forEach(acceptor -> sends(4, B, acceptor, new Accept(1, HIGH, X)));
    assertThat(monitors.report().violations(SynodSpec.ASKS)).isZero();
    sends(5, B, D, new Prepare(1, HIGH, Value.EMPTY));
    assertThat(monitors.report().violations(SynodSpec.ASKS)).isEqualTo(1);
    hears(6, B, D, new Accepted(1, HIGH));
    sends(7, B, D, new Accept(1, HIGH, X));
    assertThat(monitors.report().violations(SynodSpec.ASKS)).isEqualTo(2);
  }

  @Test
  void aProposalOfWhatIsKnownToBeDecidedViolatesAnswers() {
    promise(LOW, null, A, B, C);
    sends(A, A, new Accept(1, LOW, X));
    vote(LOW, A, B, C);
    hears(1, B, A, new Decided(1, X));
    sends(2, B, C, new Prepare(2, HIGH, Value.EMPTY));
    assertThat(monitors.report().violations(SynodSpec.ANSWERS)).isZero();
    sends(3, B, C, new Prepare(1, HIGH, Value.EMPTY));
    assertThat(monitors.report().violations(SynodSpec.ANSWERS)).isEqualTo(1);
  }

  @Test
  void aLearnerMayWaitForTheDecreesBeforeOneThatComesTooEarly() {
    hears(1, B, A, new Decided(3, X));
    sends(2, B, C, new Prepare(1, HIGH, Value.EMPTY));
    assertThat(monitors.report().violations()).isEmpty();
  }

  @Test
  void inRealTimeAProgramWithNewStorageMayAskWhatThatBeforeItKnew() {
    monitors.observe(Fault.realTime(0));
    sends(A, B, new Decided(1, X));
    // Killed, its storage deleted, started again: the trace has no event of it.
    sends(A, B, new Prepare(1, HIGH, Value.EMPTY));
    assertThat(monitors.report().violations(SynodSpec.ANSWERS)).isZero();
  }

  @Test
  void theEndOfATraceInRealTimeMayBeMissing() {
    monitors.observe(Fault.realTime(0));
    sends(A, A, new Accept(1, LOW, X));
    sends(A, D, new Decided(1, X));
    assertThat(monitors.report().violations()).isEmpty();
  }

  /** What is not looked at does not count as held. */
  @Test
  void inRealTimeQuestionsAndDecisionsAreNotChecked() {
    Monitors others = new Monitors(List.of(new SynodSpec()));
    others.observe(Fault.realTime(0));
    others.observe(
        new Sent(
            0, A, B.name(), CHANNEL, 1, 1, SynodMessage.SHAPE, new Prepare(1, LOW, Value.EMPTY)));
    others.observe(new Sent(0, A, B.name(), CHANNEL, 2, 1, SynodMessage.SHAPE, new Decided(1, X)));
    assertThat(others.report().neverChecked())
        .contains(SynodSpec.ASKS, SynodSpec.ANSWERS, SynodSpec.QUORUMS);
  }

  private void promise(Ballot ballot, @Nullable Vote vote, RobotId... acceptors) {
    for (RobotId acceptor : acceptors) {
      sends(acceptor, ballot.proposer().robot(), new Promise(1, ballot, vote, List.of()));
    }
  }

  private void vote(Ballot ballot, RobotId... acceptors) {
    for (RobotId acceptor : acceptors) {
      sends(acceptor, ballot.proposer().robot(), new Accepted(1, ballot));
    }
  }

  private void sends(RobotId from, RobotId to, SynodMessage message) {
    sends(0, from, to, message);
  }

  private void sends(long atNs, RobotId from, RobotId to, SynodMessage message) {
    monitors.observe(new Sent(atNs, from, to.name(), CHANNEL, 1, 1, SynodMessage.SHAPE, message));
  }

  private void hears(long atNs, RobotId robot, RobotId from, SynodMessage message) {
    monitors.observe(new Delivered(atNs, robot, from, CHANNEL, 1, SynodMessage.SHAPE, message));
  }

  private String violations() {
    StringBuilder text = new StringBuilder();
    for (String lemma :
        List.of(SynodSpec.BALLOTS, SynodSpec.VOTES, SynodSpec.QUORUMS, SynodSpec.ANSWERS)) {
      String separator = text.length() == 0 ? "" : ", ";
      text.append(separator).append(lemma).append(' ').append(monitors.report().violations(lemma));
    }
    return text.toString();
  }
}
