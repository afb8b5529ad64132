package org.starl.primitives.election;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.Circumstances;
import org.starl.spec.Monitor.Report;
import org.starl.trace.TraceEvent.Variable;

/** What {@link ElectionSpec} knows of one election. */
final class Ballots {

  /** How a robot stands to the leader. */
  enum Standing {
    /** It takes no part, or is not up. */
    OUT,
    /** It has been told fail. */
    FAILED,
    /** It knows the live leader of the latest term. */
    SERVED,
    /** It knows another one. */
    MISLED,
    /** It has been told nothing. */
    WAITING
  }

  private final String source;
  private final Circumstances circumstances;
  private int size;
  private long latestTerm;

  // Of each robot, under what id its present program takes part if it does.
  private final Map<RobotId, ProcessId> ids = new TreeMap<>();
  private final Set<RobotId> seen = new TreeSet<>();
  private final Set<RobotId> takers = new TreeSet<>();
  private final Map<RobotId, String> shown = new TreeMap<>();
  private final Map<Long, Set<ProcessId>> candidates = new TreeMap<>();
  private final Map<Long, First> leaders = new TreeMap<>();

  /** Who first knew the leader of a term, and whom. */
  private record First(RobotId robot, ProcessId leader) {}

  Ballots(String source, Circumstances circumstances) {
    this.source = source;
    this.circumstances = circumstances;
  }

  void made(int participants, ProcessId id) {
    size = participants;
    seen.add(id.robot());
    ids.put(id.robot(), id);
  }

  void takesPart(RobotId robot) {
    seen.add(robot);
    takers.add(robot);
  }

  void candidate(long term, ProcessId id) {
    // Who stands without having been asked to is no candidate of anybody's.
    if (takers.contains(id.robot())) {
      candidates.computeIfAbsent(term, t -> new TreeSet<>()).add(id);
    }
  }

  void crashed(RobotId robot) {
    ids.remove(robot);
    takers.remove(robot);
    shown.remove(robot);
  }

  void shown(Variable variable, Report report) {
    shown.put(variable.robot(), variable.value());
    if (!(Leader.parse(variable.value()) instanceof Leader.Name name)) {
      return;
    }
    long term = name.term();
    ProcessId leader = name.id();
    latestTerm = Math.max(latestTerm, term);
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

  /** Every robot that was ever seen, in order. */
  Set<RobotId> robots() {
    return seen;
  }

  boolean hasMajorityUp() {
    long up = ids.keySet().stream().filter(circumstances::isUp).count();
    return 2 * up > size;
  }

  Standing standing(RobotId robot) {
    if (!takers.contains(robot) || !circumstances.isUp(robot)) {
      return Standing.OUT;
    }
    String value = shown.getOrDefault(robot, Leader.NONE.toString());
    if (value.equals(Leader.NONE.toString())) {
      return Standing.WAITING;
    }
    if (value.equals(Leader.FAIL.toString())) {
      return Standing.FAILED;
    }
    return isLatestAndLive(value) ? Standing.SERVED : Standing.MISLED;
  }

  private boolean isLatestAndLive(String value) {
    First latest = leaders.get(latestTerm);
    return latest != null
        && value.equals(latestTerm + ":" + latest.leader())
        && circumstances.isUp(latest.leader().robot())
        && latest.leader().equals(ids.get(latest.leader().robot()));
  }
}
