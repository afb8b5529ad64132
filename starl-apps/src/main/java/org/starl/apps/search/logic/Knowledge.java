package org.starl.apps.search.logic;

import java.util.BitSet;
import java.util.Collections;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.RobotId;

/**
 * What one robot knows of the search: the latest report of each robot, itself included, and what
 * follows from all reports so far. A cell once seen stays seen and a room once searched stays
 * searched, even if the robot that reported it crashes. Pure. Strand only.
 */
final class Knowledge {

  private final House house;
  private final SortedMap<RobotId, Report> latest = new TreeMap<>();
  private final SortedMap<Integer, BitSet> seen = new TreeMap<>();
  private final SortedSet<Integer> swept = new TreeSet<>();
  private Optional<Report.Duty> duty = Optional.empty();
  private Optional<Answer> answer = Optional.empty();

  Knowledge(House house) {
    this.house = house;
  }

  /** Adds what a report says; of an old one only what never becomes untrue. */
  void hear(Report report) {
    swept.addAll(report.swept());
    report.answer().ifPresent(this::conclude);
    Report before = latest.get(report.from().robot());
    if (before != null && !report.isNewerThan(before)) {
      return;
    }
    latest.put(report.from().robot(), report);
    if (!report.isIdle() && (before == null || !before.seen().equals(report.seen()))) {
      saw(report.room(), RunLengths.cells(report.seen(), house.room(report.room())));
    }
    // One leader's last assignments count; of two leaders, those of the later term.
    long term = report.duty().map(Report.Duty::term).orElse(-1L);
    if (term >= 0 && (duty.isEmpty() || term >= duty.get().term())) {
      duty = report.duty();
    }
  }

  /** Some robot has seen these cells of a room for certain. */
  void saw(int room, BitSet cells) {
    seen.computeIfAbsent(room, any -> new BitSet()).or(cells);
  }

  /** The cells of a room that some robot has seen; the caller must not change the set. */
  BitSet seen(int room) {
    return seen.getOrDefault(room, new BitSet());
  }

  void addSwept(int room) {
    swept.add(room);
  }

  /** All rooms that were searched in full; read only. */
  SortedSet<Integer> swept() {
    return Collections.unmodifiableSortedSet(swept);
  }

  /** The latest report of each robot; read only. */
  SortedMap<RobotId, Report> latest() {
    return Collections.unmodifiableSortedMap(latest);
  }

  /** The assignments of the latest leader. */
  Optional<Report.Duty> duty() {
    return duty;
  }

  /** The first answer that this robot has heard or found. */
  Optional<Answer> answer() {
    return answer;
  }

  /** Notes an answer unless there is one already. */
  void conclude(Answer newAnswer) {
    if (answer.isEmpty()) {
      answer = Optional.of(newAnswer);
    }
  }
}
