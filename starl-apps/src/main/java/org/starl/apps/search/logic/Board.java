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
 * What one robot knows of the search: the latest report of everybody, itself included, and what
 * follows. What was seen stays seen, and what was swept swept, whoever
 * says so and whoever dies. Pure. Strand only.
 */
final class Board {

  private final House house;
  private final SortedMap<RobotId, Report> latest = new TreeMap<>();
  private final SortedMap<Integer, BitSet> seen = new TreeMap<>();
  private final SortedSet<Integer> swept = new TreeSet<>();
  private Optional<Report.Duty> duty = Optional.empty();
  private Optional<Answer> answer = Optional.empty();

  Board(House house) {
    this.house = house;
  }

  /**
   * Notes a report.
   *
   * @return whether it says more than the one of that robot before
   */
  boolean hear(Report report) {
    swept.addAll(report.swept());
    if (answer.isEmpty()) {
      answer = report.answer();
    }
    Report before = latest.get(report.from().robot());
    if (before != null && !report.isNewerThan(before)) {
      return false;
    }
    latest.put(report.from().robot(), report);
    if (!report.isIdle() && (before == null || !before.seen().equals(report.seen()))) {
      saw(report.room(), Runs.cells(report.seen(), house.room(report.room())));
    }
    // Of one leader's words the last one counts, of two leaders' the later term's.
    if (report.duty().isPresent()
        && (duty.isEmpty() || report.duty().get().term() >= duty.get().term())) {
      duty = report.duty();
    }
    return true;
  }

  /** Somebody has seen these cells of a room for certain. */
  void saw(int room, BitSet cells) {
    seen.computeIfAbsent(room, any -> new BitSet()).or(cells);
  }

  /** What is known to have been seen of a room; a set of the caller's own. */
  BitSet seen(int room) {
    BitSet cells = seen.get(room);
    return cells == null ? new BitSet() : (BitSet) cells.clone();
  }

  void swept(int room) {
    swept.add(room);
  }

  boolean isSwept(int room) {
    return swept.contains(room);
  }

  /** All that was swept; read only. */
  SortedSet<Integer> swept() {
    return Collections.unmodifiableSortedSet(swept);
  }

  /** The latest report of each robot that was heard; read only. */
  SortedMap<RobotId, Report> latest() {
    return Collections.unmodifiableSortedMap(latest);
  }

  /** What the latest leader wants of everybody. */
  Optional<Report.Duty> duty() {
    return duty;
  }

  /** The first answer that was told, or found out here. */
  Optional<Answer> answer() {
    return answer;
  }

  /** Notes what this robot has found out; an earlier answer stays. */
  void conclude(Answer newAnswer) {
    if (answer.isEmpty()) {
      answer = Optional.of(newAnswer);
    }
  }
}
