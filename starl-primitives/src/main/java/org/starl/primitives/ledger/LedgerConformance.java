package org.starl.primitives.ledger;

import org.starl.id.RobotId;
import org.starl.primitives.ledger.LedgerAutomaton.States;
import org.starl.primitives.ledger.LedgerEntry.Add;
import org.starl.primitives.ledger.LedgerEntry.Begin;
import org.starl.primitives.ledger.LedgerEntry.Claim;
import org.starl.primitives.ledger.LedgerEntry.Finish;
import org.starl.primitives.ledger.LedgerEntry.Free;
import org.starl.primitives.ledger.LedgerEntry.Reopen;
import org.starl.primitives.ledger.LedgerEntry.Start;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Replay;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;

/**
 * Every run of every ledger is a run of the theory {@code Ledger_decls}. The map of events to actions,
 * where {@code i} is the event's robot:
 *
 * <pre>
 * event                           action
 * applied, at a number that no    the actions of its entries, in order: restart(i) for Start, after
 *   robot has applied before        which told(i) is 0 everywhere; insert for Add, take for Claim, commit
 *                                   for Begin, finish, free, reopen
 * told DONE of Begin(t, n)        tell(i, t, n); told(i)(t) is n
 * all other events                none
 * </pre>
 *
 * Memory grows with the tasks.
 */
public final class LedgerConformance extends Conformance<LedgerConformance.Log> {

  public LedgerConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public LedgerConformance(AutomatonListener<States, LedgerAction> steps) {
    super(
        LedgerAutomaton.LEDGER_DECLS,
        "every ledger",
        source -> new Log(source, steps),
        LedgerFact.PRIMITIVE);
  }

  /** One ledger: its replay, and the number of the latest decree in it. */
  static final class Log {
    private final Replay<States, LedgerAction> replay;
    private long number;

    Log(Instance source, AutomatonListener<States, LedgerAction> steps) {
      replay = new Replay<>(new LedgerAutomaton(), source, steps);
    }

    Fun<TaskId, Long> told(RobotId i) {
      return replay.state().told().at(i);
    }

    void take(Action action, LedgerEntry entry, Report report) {
      replay.step(action, step(entry), report);
      if (entry instanceof Start start) {
        RobotId i = start.who().robot();
        replay.<Fun<TaskId, Long>>result(action, "told", i, Fun.always(0L), told(i), report);
      }
    }
  }

  @Override
  protected void acted(Action action, Report report) {
    Log log = instance(action.source());
    switch (action.fact()) {
      case LedgerFact.Applied decree when decree.number() > log.number -> {
        log.number = decree.number();
        decree.entries().forEach(entry -> log.take(action, entry, report));
      }
      case LedgerFact.Told told
          when told.outcome() == LedgerOutcome.DONE && told.entry() instanceof Begin e -> {
        RobotId i = action.robot();
        log.replay.step(action, new LedgerAction.tell(i, e.task(), e.claim()), report);
        log.replay.<Long>result(action, "told", i, e.claim(), log.told(i).at(e.task()), report);
      }
      default -> {}
    }
  }

  private static LedgerAction step(LedgerEntry entry) {
    return switch (entry) {
      case Start e -> new LedgerAction.restart(e.who().robot());
      case Add e -> new LedgerAction.insert(e.task());
      case Claim e -> new LedgerAction.take(e.who().robot(), e.task(), e.claim());
      case Begin e -> new LedgerAction.commit(e.who().robot(), e.task(), e.claim());
      case Finish e -> new LedgerAction.finish(e.who().robot(), e.task(), e.claim());
      case Free e -> new LedgerAction.free(e.task(), e.claim());
      case Reopen e -> new LedgerAction.reopen(e.task(), e.claim());
    };
  }
}
