package org.starl.primitives.election;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** One election, as {@link ElectionSpec} sees it in the trace. */
final class ElectionRecord {

  /** The part and the knowledge of a robot. */
  enum Standing {
    /** It has not called {@code do_election}, or is down. */
    NO_CANDIDATE,
    /** It shows fail. */
    FAILED,
    /** It shows the live leader of the latest term. */
    KNOWS_LEADER,
    /** It shows another leader. */
    KNOWS_OLD_LEADER,
    /** It shows null. */
    WAITING
  }

  private final Instance source;
  private final FaultState faults;
  private int size;
  private long latestTerm;
  private long decidedTerm; // the latest one of which a robot has said or shown the leader

  // The id of each robot's present program.
  private final Map<RobotId, ProcessId> ids = new TreeMap<>();
  private final Set<RobotId> seen = new TreeSet<>();
  private final Set<RobotId> callers = new TreeSet<>();
  private final Map<RobotId, Leader> shown = new TreeMap<>();
  private final Map<RobotId, Long> terms = new TreeMap<>();
  private final Map<Long, Set<ProcessId>> candidates = new TreeMap<>();
  private final Map<Long, First> leaders = new TreeMap<>();

  /** The first robot to know the leader of a term, and the leader. */
  private record First(RobotId robot, ProcessId leader) {}

  ElectionRecord(Instance source, FaultState faults) {
    this.source = source;
    this.faults = faults;
  }

  void created(int participants, ProcessId id) {
    size = participants;
    seen.add(id.robot());
    ids.put(id.robot(), id);
  }

  void called(RobotId robot) {
    seen.add(robot);
    callers.add(robot);
  }

  /** A live leader of the term before is deposed. */
  void checkStays(long term, Action action, Report report) {
    report.checked(ElectionSpec.ELECTED);
    First latest = leaders.get(latestTerm);
    if (latest != null
        && term > latestTerm
        && isLatestAndLive(new Leader.Name(latest.leader(), latestTerm))) {
      report.violated(
          ElectionSpec.ELECTED,
          action.timeNs(),
          List.of(action.robot()),
          source + ": stands in term " + term + ", but " + latest.leader() + " leads in calm");
    }
  }

  /**
   * The leader of the term before, if the robot shows it and is the first to stand in the next term:
   * then it suspects that leader.
   */
  @Nullable ProcessId deposedBy(ElectionAction.candidate stands) {
    return !candidates.containsKey(stands.n())
            && shownBy(stands.i().robot()) instanceof Leader.Name name
            && name.term() + 1 == stands.n()
        ? name.id()
        : null;
  }

  /**
   * The term of which the robot must tell the sender of this message: its own, if the sender is behind,
   * or stands in it and does not know the leader that the robot knows, or is a new candidate; else 0.
   */
  long termDue(RobotId robot, ElectionMessage message, boolean isNewCandidate) {
    long term = term(robot);
    boolean knows = shownBy(robot) instanceof Leader.Name name && name.term() == term;
    boolean asks = message instanceof ElectionMessage.Candidacy && knows;
    boolean isBehind =
        message.term() < term || (message.term() == term && (asks || isNewCandidate));
    // What a dead program has sent is ignored.
    return isBehind && message.from().equals(ids.get(message.from().robot())) ? term : 0;
  }

  /**
   * The term in which the robot must stand when it hears this message: a later one than its own, or the next one, as
   * the message is of a later program of its leader; else 0.
   */
  long termCalled(RobotId robot, ElectionMessage message) {
    ProcessId from = message.from();
    if (!callers.contains(robot) || !from.equals(ids.get(from.robot()))) {
      return 0;
    }
    long term = term(robot);
    boolean isLeaderDead =
        shownBy(robot) instanceof Leader.Name name
            && name.term() == term
            && name.id().robot().equals(from.robot())
            && name.id().inc() < from.inc();
    boolean isLater = message instanceof ElectionMessage.Candidacy && message.term() > term;
    return isLater ? message.term() : isLeaderDead ? term + 1 : 0;
  }

  void decided(long term) {
    decidedTerm = Math.max(decidedTerm, term);
  }

  /** A term begins after the decision of the one before; others may stand in it already. */
  void checkBegins(ElectionAction.candidate stands, Action action, Report report) {
    report.checked(ElectionSpec.TERMS);
    if (stands.n() > decidedTerm + 1 && !candidates.containsKey(stands.n())) {
      report.violated(
          ElectionSpec.TERMS,
          action.timeNs(),
          List.of(action.robot()),
          source + ": begins term " + stands.n() + " after the decision of term " + decidedTerm);
    }
  }

  void stood(long term, ProcessId id) {
    terms.merge(id.robot(), term, Math::max);
    // A robot that stands without a call of do_election is no valid candidate.
    if (callers.contains(id.robot())) {
      candidates.computeIfAbsent(term, t -> new TreeSet<>()).add(id);
    }
  }

  void ended(RobotId robot) {
    ids.remove(robot);
    callers.remove(robot);
    shown.remove(robot);
    terms.remove(robot);
  }

  void shown(Variable variable, Leader value, Report report) {
    shown.put(variable.robot(), value);
    if (!(value instanceof Leader.Name name)) {
      return;
    }
    long term = name.term();
    ProcessId leader = name.id();
    latestTerm = Math.max(latestTerm, term);
    decided(term);
    report.checked(ElectionSpec.TERMS);
    long before = terms.merge(variable.robot(), term, Math::max);
    if (before > term) {
      report.violated(
          ElectionSpec.TERMS,
          variable.timeNs(),
          List.of(variable.robot()),
          source + ": shows the leader of term " + term + " in term " + before);
    }
    report.checked(ElectionSpec.AGREEMENT);
    First first = leaders.computeIfAbsent(term, t -> new First(variable.robot(), leader));
    if (!first.leader().equals(leader)) {
      report.violated(
          ElectionSpec.AGREEMENT,
          variable.timeNs(),
          List.of(first.robot(), variable.robot()),
          source + ", term " + term + ": " + first.leader() + " and " + leader);
    }
    report.checked(ElectionSpec.SOUNDNESS);
    if (!candidates.getOrDefault(term, Set.of()).contains(leader)) {
      report.violated(
          ElectionSpec.SOUNDNESS,
          variable.timeNs(),
          List.of(variable.robot()),
          source + ", term " + term + ": " + leader + " did not stand for election");
    }
  }

  long term(RobotId robot) {
    return terms.getOrDefault(robot, 0L);
  }

  Leader shownBy(RobotId robot) {
    return shown.getOrDefault(robot, Leader.NONE);
  }

  /** Whether the robot knows that the present start of its program leads. */
  boolean leads(RobotId robot) {
    return shownBy(robot) instanceof Leader.Name name && name.id().equals(ids.get(robot));
  }

  /** Every robot seen so far, in order. */
  Set<RobotId> robots() {
    return seen;
  }

  boolean hasMajorityUp() {
    long up = ids.keySet().stream().filter(faults::isUp).count();
    return 2 * up > size;
  }

  Standing standing(RobotId robot) {
    if (!callers.contains(robot) || !faults.isUp(robot)) {
      return Standing.NO_CANDIDATE;
    }
    return switch (shownBy(robot)) {
      case Leader.None none -> Standing.WAITING;
      case Leader.Fail fail -> Standing.FAILED;
      case Leader.Name name ->
          isLatestAndLive(name) ? Standing.KNOWS_LEADER : Standing.KNOWS_OLD_LEADER;
    };
  }

  private boolean isLatestAndLive(Leader.Name name) {
    First latest = leaders.get(latestTerm);
    return latest != null
        && name.equals(new Leader.Name(latest.leader(), latestTerm))
        && faults.isUp(latest.leader().robot())
        && latest.leader().equals(ids.get(latest.leader().robot()));
  }
}
