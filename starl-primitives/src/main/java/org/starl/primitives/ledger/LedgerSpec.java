package org.starl.primitives.ledger;

import static org.starl.time.Time.NS_PER_MS;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.LastVote;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodSpec;
import org.starl.primitives.ledger.LedgerMessage.Here;
import org.starl.primitives.suspicion.SuspicionCheck;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FlagCheck;
import org.starl.spec.InstanceSpec;
import org.starl.spec.Monitor;
import org.starl.spec.TellCheck;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The specification of ledgers, after the package's contract: {@code OneLog}, {@code BegunByOne}, {@code
 * FinishedOnce}, {@code Kept}, {@code Present}, {@code Told}, {@code held}, and, where bounds are given, {@code Answered} and {@code
 * Freed}, and with {@link #patient} {@code Suspected} and {@code Behind}.
 */
public final class LedgerSpec extends InstanceSpec<LedgerRecord> {

  static final String ONE_LOG = "ledger.OneLog";
  static final String BEGUN_BY_ONE = "ledger.BegunByOne";
  static final String FINISHED_ONCE = "ledger.FinishedOnce";
  static final String KEPT = "ledger.Kept";
  static final String PRESENT = "ledger.Present";
  static final String TOLD = "ledger.Told";
  static final String ANSWERED = "ledger.Answered";
  static final String FREED = "ledger.Freed";
  static final String SUSPECTED = "ledger.Suspected";
  static final String BEHIND = "ledger.Behind";
  static final String HELD = "ledger.held";

  private final FlagCheck<SortedSet<TaskId>> held = flag(LedgerFact.HELD, HELD);
  private final Set<ProcessKey> ready = new LinkedHashSet<>();
  private final Deadlines answered;
  private final Deadlines freed;
  private final SuspicionCheck silence = new SuspicionCheck(SUSPECTED, faults);
  private final TellCheck tells = new TellCheck(BEHIND);
  private final LastVote lastVote = new LastVote();

  /** Safety only. */
  public LedgerSpec() {
    this(Deadlines.NO_BOUND, Deadlines.NO_BOUND);
  }

  /**
   * Safety, and progress within bounds; while a majority of the voters is up and no fault but crashes is
   * active, and owed again with the whole bound once that holds again.
   *
   * @param answeredWithinNs from a robot's latest call until no call of it is open, in ns; of robots that
   *     add tasks in the order of their numbers
   * @param freedWithinNs from a robot's crash until it has no claim that is not begun, in ns: the lease
   *     and more
   */
  public LedgerSpec(long answeredWithinNs, long freedWithinNs) {
    super(LedgerFact.PRIMITIVE);
    lemma(ONE_LOG, "All robots apply the same entries at one number of the log.");
    lemma(BEGUN_BY_ONE, "No two robots are told to do a task, unless it was reopened between.");
    lemma(FINISHED_ONCE, "A task is finished at most once, by the robot that has begun it.");
    lemma(KEPT, "A task that was added stays in the ledger until it is finished.");
    lemma(
        PRESENT,
        "Programs of a robot start in order, and only the latest one claims and finishes.");
    lemma(
        TOLD,
        "A claim, or its end, is in the log when its robot is told so, and each ends its own.");
    lemma(HELD, "The variable held says which tasks the robot holds by the log that it has.");
    answered =
        progress(
            ANSWERED,
            "A call is answered within the bound.",
            answeredWithinNs,
            sinceNs -> "has a call without an answer since " + sinceNs + " ns");
    freed =
        progress(
            FREED,
            "A claim of a crashed robot that is not begun ends within the bound.",
            freedWithinNs,
            sinceNs -> "is down, and holds a claim that is not begun, since " + sinceNs + " ns");
  }

  /**
   * Also requires, as part of {@code Answered}, that no call of this ledger is given up before its
   * deadline; that no claim is ended before its lease; and that a robot which asks is told what it lacks.
   */
  public LedgerSpec patient(LedgerSettings settings) {
    lemma(SUSPECTED, "No voter ends the claim of a robot that it has heard within the lease.");
    lemma(
        BEHIND,
        "A robot that decides a decree, or is asked for it, tells it at once; it asks all voters in turn.");
    silence.setSilence(settings.leaseMs() * NS_PER_MS);
    tells.begin();
    answered.setLeast(settings.deadlineMs() * NS_PER_MS);
    return this;
  }

  @Override
  protected LedgerRecord begin(Instance source) {
    return new LedgerRecord(source);
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(ONE_LOG);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new LedgerConformance(), new SynodSpec());
  }

  @Override
  protected void acted(Action action, Report report) {
    LedgerRecord log = instance(action.source());
    RobotId robot = action.robot();
    ProcessKey key = new ProcessKey(action.source(), robot);
    switch (action.fact()) {
      case LedgerFact.Voters voters -> log.voters(voters.robots());
      case LedgerFact.Applied decree -> {
        log.applied(decree, action, report);
        if (lastVote.decides(action, action.source(), decree.number())) {
          mustTell(log, action, decree.number());
        }
        log.knows(robot, decree.number(), false);
        checkHeld(key, action, log, report);
        if (freed.isBounded() && decree.entries().stream().anyMatch(LedgerSpec::endsAClaim)) {
          report.checked(FREED);
        }
      }
      case LedgerFact.Installed known -> {
        log.installed(known, action, report);
        log.knows(robot, known.number(), true);
        checkHeld(key, action, log, report);
      }
      case LedgerFact.Asked call -> {
        log.asked(call.entry(), action, report);
        answered.start(key, action.timeNs());
      }
      case LedgerFact.Told told -> {
        log.told(told, action, report);
        if (log.isAnswered(robot) && told.outcome() == LedgerOutcome.UNKNOWN) {
          answered.giveUp(key, action.timeNs(), faults, report);
        } else if (log.isAnswered(robot)) {
          answered.meet(key, report);
        }
      }
      default -> {}
    }
  }

  private void mustTell(LedgerRecord log, Action action, long number) {
    for (RobotId voter : log.voters()) {
      if (!voter.equals(action.robot())) {
        tells.owes(
            action,
            voter.name(),
            "decree " + number,
            told -> told instanceof Decided decree && decree.number() == number);
      }
    }
  }

  private static boolean endsAClaim(LedgerEntry entry) {
    return entry instanceof LedgerEntry.Begin || entry instanceof LedgerEntry.Free;
  }

  /** A robot whose start is not in the log shows none. */
  private void checkHeld(ProcessKey key, TraceEvent event, LedgerRecord log, Report report) {
    boolean isReady = ready.contains(key);
    held.says(
        key, event, shown -> isReady ? log.holds(key.robot(), shown) : shown.isEmpty(), report);
  }

  @Override
  protected void changed(Variable variable, Report report) {
    ProcessKey key = new ProcessKey(variable.source(), variable.robot());
    Boolean isReady = variable.of(LedgerFact.READY);
    if (isReady != null) {
      LedgerRecord log = instance(variable.source());
      if (isReady && ready.add(key) && !log.mayBeReady(variable.robot())) {
        String detail = variable.source() + ": is ready, and its log lacks its start";
        report.violated(HELD, variable.timeNs(), List.of(variable.robot()), detail);
      }
      checkHeld(key, variable, log, report);
    }
    held.shows(variable, report);
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    tells.observe(event, report);
    lastVote.observe(event);
    if (event instanceof Delivered got && got.message() instanceof Here here) {
      silence.heard(got.channel(), got, here.from());
      if (here.asks() && instance(got.channel()).has(got.robot(), here.number() + 1)) {
        tells.owes(
            got,
            got.from().name(),
            "decree " + (here.number() + 1),
            told -> told instanceof Decided decree && decree.number() == here.number() + 1);
      }
    } else if (event instanceof Sent sent && sent.message() instanceof Here here) {
      if (answered.isBounded() && !instance(sent.channel()).asksInTurn(sent, here.asks())) {
        String detail = sent.channel() + ": has not asked " + sent.to() + " in its turn";
        report.violated(BEHIND, sent.timeNs(), List.of(sent.robot()), detail);
      }
    } else if (event instanceof Sent sent
        && sent.channel().kind().equals(LedgerFact.SYNOD)
        && sent.message() instanceof Prepare asked) {
      Instance source = sent.channel().owner();
      List<LedgerEntry> wish = LedgerProtocol.read(asked.wish());
      if (instance(source).endsBegun(wish, asked.number())) {
        String detail = source + ": wishes to end the claim of a task that was begun: " + wish;
        report.violated(BEGUN_BY_ONE, sent.timeNs(), List.of(sent.robot()), detail);
      }
      var suspects = instance(source).newlyFreedBy(sent.robot(), wish);
      suspects.forEach(id -> silence.suspects(source, sent, id, Long.MIN_VALUE, report));
      if (suspects.isEmpty()) {
        silence.suspectsNobody(report); // it could have ended claims
      }
    }
  }

  @Override
  protected void ended(RobotId robot) {
    ready.removeIf(key -> key.robot().equals(robot));
    instances()
        .forEach((source, log) -> {
          log.ended(robot);
          silence.ended(robot);
          answered.stop(new ProcessKey(source, robot));
        });
  }

  @Override
  protected void review(long nowNs, Report report) {
    instances()
        .forEach((source, log) -> {
          for (RobotId robot : log.robots()) {
            ProcessKey key = new ProcessKey(source, robot);
            if (!faults.isUp(robot) && log.hasClaim(robot)) {
              freed.start(key, nowNs);
            } else {
              freed.stop(key);
            }
          }
          freed.assumeEach(key -> isFair(key.source()), nowNs);
          answered.assumeEach(key -> isFair(key.source()), nowNs);
        });
  }

  private boolean isFair(Instance source) {
    return faults.isFaultFree() && hasMajorityUp(instance(source).voters());
  }
}
