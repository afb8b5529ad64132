package org.starl.id;

import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A participant of a primitive: a robot and an incarnation number that this robot never uses twice.
 * A robot that restarts or registers again gets a new id; an old id never becomes valid again.
 *
 * @param inc incarnation number above 0; later ids of one robot have higher numbers
 */
public record ProcessId(RobotId robot, long inc) implements Comparable<ProcessId> {

  public ProcessId {
    if (inc <= 0) {
      throw new IllegalArgumentException("incarnation " + inc + ": expected above 0");
    }
  }

  /** The robots of {@code ids}, each once, in order. */
  public static List<RobotId> robots(Collection<ProcessId> ids) {
    return ids.stream().map(ProcessId::robot).distinct().sorted().collect(Collectors.toList());
  }

  @Override
  public int compareTo(ProcessId other) {
    int byRobot = robot.compareTo(other.robot);
    return byRobot != 0 ? byRobot : Long.compare(inc, other.inc);
  }

  /** {@code bot3#4294967297}: robot, then incarnation. */
  @Override
  public String toString() {
    return robot + "#" + inc;
  }

  /**
   * Parses the text of {@link #toString}.
   *
   * @throws IllegalArgumentException if {@code text} has another form
   */
  public static ProcessId parse(String text) {
    int hash = text.indexOf('#');
    if (hash < 0) {
      throw new IllegalArgumentException("process id '" + text + "': expected robot#incarnation");
    }
    return new ProcessId(
        new RobotId(text.substring(0, hash)), Long.parseLong(text.substring(hash + 1)));
  }
}
