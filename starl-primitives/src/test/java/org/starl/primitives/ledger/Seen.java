package org.starl.primitives.ledger;

import java.util.Arrays;
import java.util.List;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.Ballot;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.ledger.LedgerEntry.Add;
import org.starl.primitives.ledger.LedgerEntry.Begin;
import org.starl.primitives.ledger.LedgerEntry.Claim;
import org.starl.primitives.ledger.LedgerEntry.Finish;
import org.starl.primitives.ledger.LedgerEntry.Free;
import org.starl.primitives.ledger.LedgerEntry.Reopen;
import org.starl.primitives.ledger.LedgerEntry.Start;
import org.starl.shape.RecordShape;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;

/** Entries and events of a ledger, for tests. */
final class Seen {

  static final Instance SOURCE = Instance.of(LedgerFact.PRIMITIVE, "jobs");
  static final RobotId A = new RobotId("a");
  static final RobotId B = new RobotId("b");
  static final ProcessId PA = ProcessId.first(A, 1);
  static final ProcessId PA2 = ProcessId.first(A, 2);
  static final ProcessId PB = ProcessId.first(B, 1);
  static final TaskId T = new TaskId("orders", 1);
  static final TaskId U = new TaskId("orders", 2);
  static final Value WHAT = Value.of(new byte[] {7});

  static final Add ADD = new Add(T, WHAT);
  static final Claim CLAIM_A = new Claim(T, 1, PA);
  static final Begin BEGIN_A = new Begin(T, 1, PA);
  static final Finish FINISH_A = new Finish(T, 1, PA);
  static final Free FREE = new Free(T, 1);
  static final Reopen REOPEN = new Reopen(T, 1);
  static final Start START_A = new Start(PA);
  static final Start START_B = new Start(PB);

  private Seen() {}

  static <F> Action acts(long timeNs, RobotId robot, RecordShape<F> shape, F fact) {
    return Action.of(timeNs, robot, SOURCE, shape, fact);
  }

  static Action votes(long timeNs, RobotId robot) {
    return acts(timeNs, robot, LedgerFact.VOTERS, new LedgerFact.Voters(List.of(A, B)));
  }

  static Action applies(
      long timeNs, RobotId robot, long number, int tasks, LedgerEntry... entries) {
    return acts(
        timeNs,
        robot,
        LedgerFact.APPLIED,
        new LedgerFact.Applied(number, Arrays.asList(entries), tasks));
  }

  static Action installs(long timeNs, RobotId robot, long number, int tasks) {
    return acts(timeNs, robot, LedgerFact.INSTALLED, new LedgerFact.Installed(number, tasks));
  }

  static Action asks(long timeNs, RobotId robot, LedgerEntry entry) {
    return acts(timeNs, robot, LedgerFact.ASKED, new LedgerFact.Asked(entry));
  }

  static Action isTold(long timeNs, RobotId robot, LedgerEntry entry, LedgerOutcome outcome) {
    return acts(timeNs, robot, LedgerFact.TOLD, new LedgerFact.Told(entry, outcome));
  }

  static Delivered hears(long timeNs, RobotId robot, LedgerMessage message) {
    RobotId from = message.from().robot();
    return new Delivered(timeNs, robot, from, SOURCE, 1, LedgerMessage.SHAPE, message);
  }

  /** The robot asks all voters for promises, and wishes these entries. */
  static Sent prepares(long timeNs, RobotId robot, LedgerEntry... wish) {
    Value wished = Value.write(out -> LedgerEntry.LIST.write(List.of(wish), out));
    Ballot ballot = new Ballot(1, ProcessId.first(robot, 1));
    return says(timeNs, robot, Sent.ALL, new SynodMessage.Prepare(2, ballot, wished));
  }

  /** The robot tells another one a decree. */
  static Sent decrees(long timeNs, RobotId robot, RobotId to, long number) {
    return says(timeNs, robot, to.name(), new SynodMessage.Decided(number, Value.EMPTY));
  }

  /** The robot hears a vote for its ballot. */
  static Delivered hearsVote(long timeNs, RobotId robot, RobotId from, long number) {
    Instance synod = Instance.of(LedgerFact.SYNOD, SOURCE.xid());
    SynodMessage vote = new SynodMessage.Accepted(number, new Ballot(1, ProcessId.first(robot, 1)));
    return new Delivered(timeNs, robot, from, synod, 1, SynodMessage.SHAPE, vote);
  }

  /** The robot tells a voter that it lives. */
  static Sent beacons(long timeNs, RobotId robot, RobotId to, boolean asks) {
    LedgerMessage here = new LedgerMessage.Here(ProcessId.first(robot, 1), 1, asks);
    return new Sent(timeNs, robot, to.name(), SOURCE, 1, 1, LedgerMessage.SHAPE, here);
  }

  private static Sent says(long timeNs, RobotId robot, String to, SynodMessage message) {
    Instance synod = Instance.of(LedgerFact.SYNOD, SOURCE.xid());
    return new Sent(timeNs, robot, to, synod, 1, 1, SynodMessage.SHAPE, message);
  }
}
