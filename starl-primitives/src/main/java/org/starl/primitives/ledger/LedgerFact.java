package org.starl.primitives.ledger;

import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.ROBOT;
import static org.starl.shape.Shapes.part;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a ledger. */
public final class LedgerFact {

  /** The primitive's name in sources. */
  public static final String PRIMITIVE = "ledger";

  /** The Synod's own channel. */
  static final String SYNOD = "ledger.synod";

  /** The channel of auctions. */
  static final String BIDS = "ledger.bids";

  private static final Shape<Long> NUMBER = Shapes.atLeast(0, "decree number");

  /** Whether the log has the start of the robot's program. */
  public static final Var<Boolean> READY = Var.of("ready", Shapes.BOOL);

  /** The tasks that the robot has claimed or begun. */
  public static final Var<SortedSet<TaskId>> HELD =
      Var.of("held", Shapes.set(TaskId.SHAPE, 0xFFFF));

  /** The robots that decide: from now on this robot takes part. */
  public record Voters(List<RobotId> robots) {
    public Voters {
      robots = List.copyOf(robots);
    }
  }

  /** A call. */
  public record Asked(LedgerEntry entry) {}

  /** The outcome of a call. */
  public record Told(LedgerEntry entry, LedgerOutcome outcome) {}

  /**
   * The robot knows one more decree.
   *
   * @param entries those that took effect
   * @param tasks how many are not finished now
   */
  public record Applied(long number, List<LedgerEntry> entries, int tasks) {
    public Applied {
      entries = List.copyOf(entries);
    }
  }

  /** The robot knows the log up to a decree, from its storage or from another robot. */
  public record Installed(long number, int tasks) {}

  /** Named {@code voters}. */
  static final RecordShape<Voters> VOTERS =
      Shapes.of(
              Voters.class, part("robots", Shapes.list(ROBOT, 0xFFFF), Voters::robots), Voters::new)
          .named("voters");

  /** Named {@code asked}. */
  static final RecordShape<Asked> ASKED =
      Shapes.of(Asked.class, part("entry", LedgerEntry.SHAPE, Asked::entry), Asked::new)
          .named("asked");

  /** Named {@code told}. */
  static final RecordShape<Told> TOLD =
      Shapes.of(
              Told.class,
              part("entry", LedgerEntry.SHAPE, Told::entry),
              part("outcome", Shapes.constant(LedgerOutcome.class), Told::outcome),
              Told::new)
          .named("told");

  /** Named {@code applied}. */
  static final RecordShape<Applied> APPLIED =
      Shapes.of(
              Applied.class,
              part("number", NUMBER, Applied::number),
              part("entries", LedgerEntry.LIST, Applied::entries),
              part("tasks", INT, Applied::tasks),
              Applied::new)
          .named("applied");

  /** Named {@code installed}. */
  static final RecordShape<Installed> INSTALLED =
      Shapes.of(
              Installed.class,
              part("number", NUMBER, Installed::number),
              part("tasks", INT, Installed::tasks),
              Installed::new)
          .named("installed");

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      Vocabulary.NONE
          .messages(PRIMITIVE, LedgerMessage.SHAPE)
          .messages(SYNOD, SynodMessage.SHAPE)
          .messages(BIDS, Auction.Bid.SHAPE)
          .facts(PRIMITIVE, VOTERS, ASKED, TOLD, APPLIED, INSTALLED)
          .variables(PRIMITIVE, READY, HELD);

  private static final String STARTING = "STARTING";
  private static final String FREE = "FREE";
  private static final String HOLDING = "HOLDING";

  /** The phases: its start is not in the log, it holds no task, it holds some. */
  public static final Phases PHASES =
      Phases.of(PRIMITIVE, LedgerMessage.class, () -> LedgerFact::phase, STARTING, FREE, HOLDING)
          .with(SYNOD, SynodMessage.class);

  private LedgerFact() {}

  private static String phase(String before, TraceEvent event) {
    if (!(event instanceof Variable variable)) {
      return before;
    }
    Boolean ready = variable.of(READY);
    SortedSet<TaskId> held = variable.of(HELD);
    if (ready != null) {
      return ready ? FREE : STARTING;
    }
    if (held == null || before.equals(STARTING)) {
      return before;
    }
    return held.isEmpty() ? FREE : HOLDING;
  }
}
