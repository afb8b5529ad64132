package org.starl.primitives.election;

import static org.starl.time.Time.NS_PER_MS;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.LastVote;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodSpec;
import org.starl.primitives.election.ElectionMessage.Candidacy;
import org.starl.primitives.election.ElectionMessage.Elected;
import org.starl.primitives.suspicion.SuspicionCheck;
import org.starl.spec.Deadlines;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
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
 * The specification of elections, after the package's contract: {@code Agreement}, {@code Soundness},
 * where bounds are given, {@code Elected} and {@code Told}, and with {@link #patient} {@code Suspected}, {@code
 * Behind}, {@code Says} and {@code Turn}.
 */
public final class ElectionSpec extends InstanceSpec<ElectionRecord> {

  static final String AGREEMENT = "election.Agreement";
  static final String SOUNDNESS = "election.Soundness";
  static final String TERMS = "election.Terms";
  static final String ELECTED = "election.Elected";
  static final String TOLD = "election.Told";
  static final String SUSPECTED = "election.Suspected";
  static final String SAYS = "election.Says";
  static final String TURN = "election.Turn";
  static final String BEHIND = "election.Behind";
  static final String LEADER = "election.Leader";

  private static final String SAYS_SAYS =
      "Who stands, leads or decides says so, at once and again; who hears of a later term, or a new start, stands.";

  private boolean leaderStays;
  private boolean seesMessages;
  private final TurnCheck turns = new TurnCheck(faults);
  private final LastVote lastVote = new LastVote();
  private final SuspicionCheck silence = new SuspicionCheck(SUSPECTED, faults);
  private final TellCheck tells = new TellCheck(BEHIND);
  private final TellCheck says = new TellCheck(SAYS);
  private final FlagCheck<Leader> shown = flag(ElectionFact.LEADER, LEADER);
  // Robots whose election has failed, until they stand again.
  private final Set<ProcessKey> failed = new LinkedHashSet<>();
  private final Deadlines elected;
  private final Deadlines told;
  private Deadlines leads = new Deadlines(SAYS, Deadlines.NO_BOUND, sinceNs -> "");
  private Deadlines stands = new Deadlines(SAYS, Deadlines.NO_BOUND, sinceNs -> "");

  /** Safety only. */
  public ElectionSpec() {
    this(Deadlines.NO_BOUND, Deadlines.NO_BOUND);
  }

  /**
   * Safety, and progress within bounds.
   *
   * @param electedWithinNs while a majority of the participants is up and no fault but crashes is
   *     active: from {@code do_election}, or from the loss of the leader, until every candidate knows
   *     the live leader of the latest term, in ns
   * @param toldWithinNs a candidate's {@code Leader} is null for no longer at a time, whatever
   *     happens, in ns: the elections' deadline
   */
  public ElectionSpec(long electedWithinNs, long toldWithinNs) {
    super(ElectionFact.PRIMITIVE);
    lemma(AGREEMENT, "In one term, all robots that know a leader know the same one.");
    lemma(SOUNDNESS, "A leader stood for election in its term.");
    lemma(
        TERMS,
        "The term of a robot's program never goes back; one begins after a decision of the one before.");
    lemma(
        LEADER,
        "Leader is null, and no older leader, after a candidacy; it is null and fail at no other time.");
    elected =
        progress(
            ELECTED,
            "All candidates know one live leader within the bound.",
            electedWithinNs,
            sinceNs -> "knows no live leader of the latest term since " + sinceNs + " ns");
    told =
        progress(
            TOLD,
            "No candidate waits for a leader beyond the deadline without being told.",
            toldWithinNs,
            sinceNs -> "Leader is null since " + sinceNs + " ns");
  }

  /**
   * Requires, as part of {@code Elected}, that no term begins in a calm world after that of a live
   * leader. Only for a network that loses nothing then.
   */
  public ElectionSpec leaderStays() {
    leaderStays = true;
    return this;
  }

  /**
   * Also requires that no robot suspects a leader, fails, or proposes before these times; that robots tell
   * each other at once; and that a term begins after the decision of the one before. The trace must have all
   * messages.
   */
  public ElectionSpec patient(ElectionSettings settings) {
    lemma(SUSPECTED, "No robot stands against a leader that it has heard within the silence.");
    lemma(
        BEHIND,
        "Who hears a robot of an earlier term, or without its leader, or a new candidate, tells it at once.");
    leads = repeats("leads", settings.heartbeatMs());
    stands = repeats("stands", settings.deltaMs());
    lemma(
        TURN,
        "A candidate proposes the first one by its strategy, in its own turn; each term has draws of its own.");
    seesMessages = true;
    tells.begin();
    says.begin();
    turns.begin(settings);
    silence.setSilence(settings.silenceMs() * NS_PER_MS);
    told.setLeast(settings.deadlineMs() * NS_PER_MS);
    return this;
  }

  @Override
  protected ElectionRecord begin(Instance source) {
    return new ElectionRecord(source, faults);
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(AGREEMENT, LEADER);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new ElectionConformance(), new SynodSpec());
  }

  @Override
  protected void acted(Action action, Report report) {
    ElectionRecord ballots = instance(action.source());
    switch (action.fact()) {
      case ElectionFact.Created created -> {
        ballots.created(created.size(), created.i());
        silence.heard(action.source(), action, created.i());
      }
      case ElectionAction.do_election call -> {
        if (ballots.shownBy(action.robot()) instanceof Leader.Fail) {
          turns.stands(key(action), ballots.term(action.robot()), action.timeNs());
        }
        failed.remove(key(action));
        ballots.called(action.robot());
        allow(ballots, action, action.source(), 0, report);
      }
      case ElectionAction.candidate stands -> {
        if (leaderStays && faults.isCalm(action.timeNs(), FaultState.SETTLE_NS)) {
          ballots.checkStays(stands.n(), action, report);
        }
        ProcessId deposed = ballots.deposedBy(stands);
        if (deposed != null) {
          silence.suspects(action.source(), action, deposed, Long.MIN_VALUE, report);
        } else {
          silence.suspectsNobody(report); // it knows no leader of the term before
        }
        failed.remove(key(action));
        if (seesMessages) {
          ballots.checkBegins(stands, action, report);
        }
        ballots.stood(stands.n(), stands.i());
        turns.stands(key(action), stands.n(), action.timeNs());
        says.owes(
            action,
            Sent.ALL,
            "its candidacy in term " + stands.n(),
            told -> told instanceof Candidacy m && m.term() == stands.n());
        allow(ballots, action, action.source(), stands.n(), report);
      }
      default -> {}
    }
  }

  @Override
  protected void changed(Variable variable, Report report) {
    Leader leader = variable.of(ElectionFact.LEADER);
    if (leader != null) {
      ElectionRecord ballots = instance(variable.source());
      ballots.shown(variable, leader, report);
      shown.shows(variable, report);
      if (leader instanceof Leader.Fail) {
        failed.add(new ProcessKey(variable.source(), variable.robot()));
      }
      if (leader instanceof Leader.Name name) {
        silence.heard(variable.source(), variable, name.id());
        if (lastVote.decides(variable, name.term())) {
          says.owes(
              variable,
              Sent.ALL,
              "the leader of term " + name.term(),
              told -> told instanceof Elected m && m.term() == name.term());
        }
        if (ballots.leads(variable.robot())) {
          says.owes(
              variable,
              Sent.ALL,
              "that it leads term " + name.term(),
              told -> told instanceof Elected m && m.leader().equals(name.id()));
        }
      }
      allow(ballots, variable, variable.source(), 0, report);
    }
  }

  private static ProcessKey key(TraceEvent.Action action) {
    return new ProcessKey(action.source(), action.robot());
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    tells.observe(event, report);
    says.observe(event, report);
    lastVote.observe(event);
    boolean isNewCandidate =
        event instanceof Delivered got
            && got.message() instanceof ElectionMessage message
            && turns.isNew(got, message);
    turns.observe(event, report);
    if (event instanceof Sent sent) {
      if (sent.message() instanceof Elected elected) {
        instance(sent.channel()).decided(elected.term());
      }
      sent(sent, report);
    }
    if (event instanceof Delivered got && got.message() instanceof ElectionMessage message) {
      silence.heard(got.channel(), got, message.from());
      ElectionRecord ballots = instance(got.channel());
      if (message instanceof Elected elected) {
        ballots.decided(elected.term());
      }
      long due = ballots.termDue(got.robot(), message, isNewCandidate);
      if (due > 0) {
        tells.owes(
            got,
            got.from().name(),
            "term " + due,
            told -> told instanceof ElectionMessage m && m.term() >= due);
      }
      long called = ballots.termCalled(got.robot(), message);
      if (called > 0) {
        says.owes(
            got,
            Sent.ALL,
            "its candidacy in term " + called,
            told -> told instanceof Candidacy m && m.term() >= called);
      }
    }
  }

  private void sent(Sent sent, Report report) {
    if (sent.message() instanceof ElectionMessage message && sent.to().equals(Sent.ALL)) {
      ProcessKey key = new ProcessKey(sent.channel(), sent.robot());
      (message instanceof Elected ? leads : stands).meet(key, report);
      ElectionRecord ballots = instance(sent.channel());
      RobotId robot = sent.robot();
      saysAgain(key, ballots.standing(robot), ballots.leads(robot), sent.timeNs());
    } else if (told.isBounded()
        && (sent.message() instanceof Prepare || sent.message() instanceof Accept)
        && sent.channel().kind().equals(ElectionFact.SYNOD)
        && failed.contains(new ProcessKey(sent.channel().owner(), sent.robot()))) {
      String detail = sent.channel() + ": " + sent.message() + " after it has failed";
      report.violated(TOLD, sent.timeNs(), List.of(sent.robot()), detail);
    }
  }

  private Deadlines repeats(String what, long periodMs) {
    return progress(
        SAYS,
        SAYS_SAYS,
        2 * periodMs * NS_PER_MS,
        sinceNs -> what + ", and does not say so since " + sinceNs + " ns");
  }

  /** Candidates and leaders repeat what they say. */
  private void saysAgain(
      ProcessKey key, ElectionRecord.Standing standing, boolean isLeader, long nowNs) {
    await(leads, key, isLeader, nowNs);
    await(stands, key, standing == ElectionRecord.Standing.WAITING, nowNs);
    // A clock that was set back delays the next period.
    boolean isOwed =
        faults.isFaultFree() && faults.isClockRight(key.robot(), nowNs - FaultState.SETTLE_NS);
    leads.assume(key, isOwed, nowNs);
    stands.assume(key, isOwed, nowNs);
  }

  private static void await(Deadlines deadlines, ProcessKey key, boolean isDue, long nowNs) {
    if (isDue) {
      deadlines.start(key, nowNs);
    } else {
      deadlines.stop(key);
    }
  }

  /**
   * A candidacy ends an earlier leader and a failure; nothing else makes {@code Leader} null, and only
   * null becomes fail.
   */
  private void allow(
      ElectionRecord ballots, TraceEvent event, Instance source, long term, Report report) {
    Leader now = ballots.shownBy(event.robot());
    boolean isNull = now.equals(Leader.NONE);
    boolean isCall = event instanceof Action;
    shown.says(
        new ProcessKey(source, event.robot()),
        event,
        leader ->
            switch (leader) {
              case Leader.None none -> isNull || term > 0 || (isCall && !now.isElected());
              case Leader.Fail fail -> isNull || (!isCall && !now.isElected());
              case Leader.Name name -> name.term() >= term;
            },
        report);
  }

  @Override
  protected void ended(RobotId robot) {
    instances().values().forEach(ballots -> ballots.ended(robot));
    silence.ended(robot);
    turns.ended(robot);
    failed.removeIf(key -> key.robot().equals(robot));
    for (Instance source : instances().keySet()) {
      List.of(leads, stands).forEach(each -> each.stop(new ProcessKey(source, robot)));
    }
  }

  @Override
  protected void review(long nowNs, Report report) {
    instances()
        .forEach((source, ballots) -> {
          boolean assumed = faults.isFaultFree() && ballots.hasMajorityUp();
          for (RobotId robot : ballots.robots()) {
            ProcessKey key = new ProcessKey(source, robot);
            ElectionRecord.Standing standing = ballots.standing(robot);
            review(key, standing, nowNs, report);
            elected.assume(key, assumed, nowNs);
            saysAgain(key, standing, ballots.leads(robot), nowNs);
          }
        });
  }

  private void review(ProcessKey key, ElectionRecord.Standing standing, long nowNs, Report report) {
    switch (standing) {
      case NO_CANDIDATE -> {
        elected.stop(key);
        told.stop(key);
      }
      case FAILED -> {
        elected.stop(key);
        told.giveUp(key, nowNs, faults, report);
      }
      case KNOWS_LEADER -> {
        elected.meet(key, report);
        told.meet(key, report);
      }
      case KNOWS_OLD_LEADER -> {
        elected.start(key, nowNs);
        told.meet(key, report);
      }
      case WAITING -> {
        elected.start(key, nowNs);
        told.start(key, nowNs);
      }
    }
  }
}
