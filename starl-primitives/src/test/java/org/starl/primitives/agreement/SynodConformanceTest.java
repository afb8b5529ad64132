package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodAutomaton.States;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Vote;
import org.starl.primitives.conformance.ShownRun;
import org.starl.spec.SpecReport.Violation;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/** Which messages are which actions, among the acceptors a, b and c; and what is no run of the theory. */
class SynodConformanceTest {

  private static final Instance CHANNEL = Instance.of(AgreementFact.PRIMITIVE, "x");
  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final RobotId C = new RobotId("c");
  private static final Ballot LOW = new Ballot(1, ProcessId.first(A, 1));
  private static final Ballot HIGH = new Ballot(2, ProcessId.first(B, 1));
  private static final Value X = Value.of(new byte[] {1});
  private static final Value Y = Value.of(new byte[] {2});

  private final ShownRun<States, SynodAction> run = new ShownRun<>(SynodConformance::new);

  @Test
  void messagesMapToTheActionsInTheTable() {
    prepare(LOW);
    promise(LOW, null, A, B);
    sends(A, B, new Accept(1, LOW, X));
    vote(LOW, A, B);
    sends(A, C, new Decided(1, X));
    run.has(new Delivered(0, C, A, CHANNEL, 1, SynodMessage.SHAPE, new Decided(1, X)));
    run.has(new Fault(0, C, Fault.CRASH, ""));
    assertThat(run.details()).isEmpty();
    String low = "Ballot[round=1, proposer=a]";
    assertThat(run.steps())
        .containsExactly(
            "proposer(" + low + ") = a",
            "prepare(a, 1)",
            "Prepared(a, " + low + ")",
            "vote(a) = bottom",
            "Prepared(b, " + low + ")",
            "vote(b) = bottom",
            "proposer(" + low + ") = a",
            "wish(a, 01)",
            "Propose(a, 01, [a, b])",
            "Accept(a, " + low + ", 01)",
            "Accept(b, " + low + ", 01)",
            "chosen(a, 01, [a, b])",
            "Learn(a, 01)",
            "Learn(c, 01)",
            "restart(c)");
  }

  @Test
  void aVoteThatACrashKeptFromBeingToldIsOne() {
    lowAsksForVotes();
    prepare(HIGH);
    run.forgetSteps();
    promise(HIGH, new Vote(LOW, X), C);
    assertThat(run.details()).isEmpty();
    assertThat(run.steps()).first().isEqualTo("Accept(c, Ballot[round=1, proposer=a], 01)");
  }

  @Test
  void aPromiseThatIsNotKeptDeviates() {
    prepare(LOW);
    prepare(HIGH);
    promise(HIGH, null, C);
    run.has(new Fault(0, C, Fault.CRASH, ""));
    promise(LOW, null, C);
    assertDeviates("Prepared(c, ", "allows?(r, b) is false");
  }

  @Test
  void aVoteBelowThePromiseDeviates() {
    lowAsksForVotes();
    prepare(HIGH);
    promise(HIGH, null, C);
    vote(LOW, C);
    assertDeviates("Accept(c, ", "allows?(r, b) is false");
  }

  @Test
  void aVoteThatAPromiseDoesNotTellDeviates() {
    lowAsksForVotes();
    vote(LOW, C);
    prepare(HIGH);
    promise(HIGH, null, C);
    assertDeviates("vote(c) is up(", "but the trace has bottom");
  }

  @Test
  void aProposalAfterOnePromiseOfThreeDeviates() {
    prepare(LOW);
    promise(LOW, null, A);
    sends(A, B, new Accept(1, LOW, X));
    assertDeviates("Propose(a, 01, [a])", "quorum?(Q) is false");
  }

  @Test
  void aProposalAgainstTheHighestVoteDeviates() {
    lowAsksForVotes();
    vote(LOW, C);
    prepare(HIGH);
    promise(HIGH, new Vote(LOW, X), C);
    promise(HIGH, null, B);
    sends(B, A, new Accept(1, HIGH, Y));
    assertDeviates("Propose(b, 02, [b])", "quorum?(Q) is false");
  }

  @Test
  void twoValuesInOneBallotDeviate() {
    lowAsksForVotes();
    sends(A, B, new Accept(1, LOW, Y));
    assertDeviates("Propose(a, 02, [a, b])", "phase(i) = PREPARING is false");
  }

  @Test
  void aBallotOfAnotherRobotDeviates() {
    sends(C, A, new Prepare(1, LOW, Value.EMPTY));
    assertDeviates("proposer(", "is a, but the trace has c");
  }

  @Test
  void aDecisionWithoutAQuorumDeviates() {
    lowAsksForVotes();
    vote(LOW, C);
    sends(A, C, new Decided(1, X));
    assertDeviates("Learn(a, 01)", "v in decideds is false");
  }

  @Test
  void inRealTimeACauseMayBeMissingButAPromiseIsKept() {
    run.has(Fault.realTime(0));
    sends(A, C, new Decided(1, X));
    lowAsksForVotes(2);
    sends(B, C, new Prepare(2, HIGH, Value.EMPTY));
    sends(C, B, new Promise(2, HIGH, null, List.of()));
    assertThat(run.details()).isEmpty();
    sends(C, A, new Accepted(2, LOW));
    assertDeviates("Accept(c, ", "allows?(r, b) is false");
  }

  private void assertDeviates(String action, String why) {
    assertThat(run.report().violations())
        .extracting(Violation::lemma)
        .containsExactly("Synod_decls");
    assertThat(run.details()).singleElement().asString().contains(action).contains(why);
  }

  private void lowAsksForVotes() {
    lowAsksForVotes(1);
  }

  private void lowAsksForVotes(long number) {
    for (RobotId acceptor : List.of(A, B, C)) {
      sends(A, acceptor, new Prepare(number, LOW, Value.EMPTY));
    }
    for (RobotId acceptor : List.of(A, B)) {
      sends(acceptor, A, new Promise(number, LOW, null, List.of()));
    }
    sends(A, B, new Accept(number, LOW, X));
  }

  private void prepare(Ballot ballot) {
    for (RobotId acceptor : List.of(A, B, C)) {
      sends(ballot.proposer().robot(), acceptor, new Prepare(1, ballot, Value.EMPTY));
    }
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
    run.has(new Sent(0, from, to.name(), CHANNEL, 1, 1, SynodMessage.SHAPE, message));
  }
}
