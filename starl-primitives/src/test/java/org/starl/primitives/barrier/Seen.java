package org.starl.primitives.barrier;

import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Ballot;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.barrier.BarrierOutcome.Excluded;
import org.starl.primitives.barrier.BarrierOutcome.Failed;
import org.starl.primitives.barrier.BarrierOutcome.Passed;
import org.starl.primitives.barrier.BarrierOutcome.Unknown;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/** Events of a barrier, and outcomes, for tests. */
final class Seen {

  static final Instance SOURCE = Instance.of(BarrierFact.PRIMITIVE, "x");

  private Seen() {}

  /** These ids, in order: {@code a}. */
  static SortedSet<ProcessId> ids(String... ids) {
    SortedSet<ProcessId> all = new TreeSet<>();
    for (String id : ids) {
      all.add(ProcessId.parse(id));
    }
    return all;
  }

  static BarrierOutcome passed(long generation) {
    return new Passed(generation);
  }

  static BarrierOutcome failed(long generation, String... missing) {
    return new Failed(generation, ids(missing));
  }

  static BarrierOutcome excluded(long generation) {
    return new Excluded(generation);
  }

  static BarrierOutcome unknown(long generation) {
    return new Unknown(generation);
  }

  /** The program of the id's robot has a barrier. */
  static Action exists(long timeNs, Instance source, String id, String... members) {
    ProcessId i = ProcessId.parse(id);
    return Action.of(
        timeNs, i.robot(), source, BarrierFact.CREATED, new BarrierFact.Created(i, ids(members)));
  }

  static Action arrives(long timeNs, RobotId robot, Instance source, long generation, String id) {
    return Action.of(
        timeNs,
        robot,
        source,
        BarrierFact.ARRIVE,
        new BarrierAction.arrive(ProcessId.parse(id), generation));
  }

  /** The robot hears of an id's arrival. */
  static Delivered hears(long timeNs, RobotId robot, String id, long generation) {
    ProcessId from = ProcessId.parse(id);
    BarrierMessage message = new BarrierMessage.Arrival(from, generation);
    return new Delivered(timeNs, robot, from.robot(), SOURCE, 1, BarrierMessage.SHAPE, message);
  }

  /** The robot proposes that these members are missing. */
  static Sent proposes(
      long timeNs,
      RobotId robot,
      SortedSet<ProcessId> members,
      long generation,
      String... missing) {
    Outcomes outcomes = Outcomes.ALL_PASSED.withBroken(generation, ids(missing));
    Ballot ballot = new Ballot(1, ProcessId.first(robot, 1));
    SynodMessage accept =
        new SynodMessage.Accept(generation, ballot, new OutcomesFormat(members).toValue(outcomes));
    Instance channel = Instance.of(BarrierFact.SYNOD, SOURCE.xid());
    return new Sent(timeNs, robot, Sent.ALL, channel, 1, 1, SynodMessage.SHAPE, accept);
  }

  /** The robot sends a message of the barrier, or of its Synod. */
  static Sent tells(long timeNs, RobotId robot, String to, Object message) {
    Instance synod = Instance.of(BarrierFact.SYNOD, SOURCE.xid());
    return message instanceof BarrierMessage
        ? new Sent(timeNs, robot, to, SOURCE, 1, 1, BarrierMessage.SHAPE, message)
        : new Sent(timeNs, robot, to, synod, 1, 1, SynodMessage.SHAPE, message);
  }

  static Delivered hears(long timeNs, RobotId robot, BarrierMessage message) {
    RobotId from = message.from().robot();
    return new Delivered(timeNs, robot, from, SOURCE, 1, BarrierMessage.SHAPE, message);
  }

  static Variable shows(long timeNs, RobotId robot, BarrierOutcome outcome) {
    return new Variable(timeNs, robot, SOURCE, BarrierFact.OUTCOME, outcome);
  }
}
