package org.starl.primitives.election;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Ballot;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.Value;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/** Events of the election {@code election/x}, for tests. */
final class Seen {

  static final Instance SOURCE = Instance.of(ElectionFact.PRIMITIVE, "x");

  private static final Instance SYNOD = Instance.of(ElectionFact.SYNOD, "x");

  private Seen() {}

  /** The robot's program has an election. */
  static Action exists(long timeNs, int size, ProcessId i) {
    return Action.of(
        timeNs, i.robot(), SOURCE, ElectionFact.CREATED, new ElectionFact.Created(size, i));
  }

  static Action calls(long timeNs, RobotId robot, ProcessId i) {
    return Action.of(
        timeNs, robot, SOURCE, ElectionFact.DO_ELECTION, new ElectionAction.do_election(i));
  }

  static Action stands(long timeNs, RobotId robot, long term, ProcessId i) {
    return Action.of(
        timeNs, robot, SOURCE, ElectionFact.CANDIDATE, new ElectionAction.candidate(i, term));
  }

  static Delivered hears(long timeNs, RobotId robot, ElectionMessage message) {
    RobotId from = message.from().robot();
    return new Delivered(timeNs, robot, from, SOURCE, 1, ElectionMessage.SHAPE, message);
  }

  static Sent tells(long timeNs, RobotId robot, RobotId to, ElectionMessage message) {
    return new Sent(timeNs, robot, to.name(), SOURCE, 1, 1, ElectionMessage.SHAPE, message);
  }

  static Sent says(long timeNs, RobotId robot, ElectionMessage message) {
    return new Sent(timeNs, robot, Sent.ALL, SOURCE, 1, 1, ElectionMessage.SHAPE, message);
  }

  /** An acceptor's vote comes that decides, perhaps. */
  static Delivered hearsVote(long timeNs, RobotId robot, RobotId from, long term) {
    SynodMessage vote = new SynodMessage.Accepted(term, new Ballot(1, ProcessId.first(robot, 1)));
    return new Delivered(timeNs, robot, from, SYNOD, 1, SynodMessage.SHAPE, vote);
  }

  /** An acceptor promises, and has voted for {@code voted} if that is not null. */
  static Delivered hearsPromise(long timeNs, RobotId robot, long term, @Nullable ProcessId voted) {
    Ballot ballot = new Ballot(1, ProcessId.first(robot, 1));
    SynodMessage.Vote vote =
        voted == null ? null : new SynodMessage.Vote(ballot, ElectionProtocol.toValue(voted));
    SynodMessage promise = new SynodMessage.Promise(term, ballot, vote, List.of());
    return new Delivered(timeNs, robot, robot, SYNOD, 1, SynodMessage.SHAPE, promise);
  }

  static Sent proposes(long timeNs, RobotId robot, long term, ProcessId leader) {
    Ballot ballot = new Ballot(1, ProcessId.first(robot, 1));
    SynodMessage asks = new SynodMessage.Accept(term, ballot, ElectionProtocol.toValue(leader));
    return new Sent(timeNs, robot, robot.name(), SYNOD, 1, 1, SynodMessage.SHAPE, asks);
  }

  static Sent prepares(long timeNs, RobotId robot, long term) {
    SynodMessage asks =
        new SynodMessage.Prepare(term, new Ballot(1, ProcessId.first(robot, 1)), Value.EMPTY);
    return new Sent(timeNs, robot, robot.name(), SYNOD, 1, 1, SynodMessage.SHAPE, asks);
  }

  static Variable shows(long timeNs, RobotId robot, Leader leader) {
    return new Variable(timeNs, robot, SOURCE, ElectionFact.LEADER, leader);
  }
}
