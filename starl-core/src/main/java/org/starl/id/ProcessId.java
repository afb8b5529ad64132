package org.starl.id;

import java.util.Collection;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * A participant of a primitive: a robot and an incarnation number that this robot never uses twice.
 * A robot that restarts or registers again gets a new id; an old id never becomes valid again.
 *
 * <p>Its text has no more than tells it from the robot's other ids: {@code bot0} is the first id of the
 * first boot, {@code bot0.2} the first id of the second boot, {@code bot0.2.7} the seventh one of that
 * boot. No robot's name ends so.
 *
 * @param inc incarnation number above 0; later ids of one robot have higher numbers. Its upper half
 *     is the boot number, its lower half the id's number in that boot
 */
public record ProcessId(RobotId robot, long inc) implements Comparable<ProcessId> {

  private static final Pattern TEXT =
      Pattern.compile("(.*?)(?:\\.(\\d{1,10}))?(?:\\.(\\d{1,10}))?");

  public ProcessId {
    if (inc <= 0) {
      throw new IllegalArgumentException("incarnation " + inc + ": expected above 0");
    }
  }

  /** The first id of the robot's program in its start {@code boot}. */
  public static ProcessId first(RobotId robot, long boot) {
    return new ProcessId(robot, (boot << Integer.SIZE) + 1);
  }

  /** The robots of {@code ids}, each once, in order. */
  public static List<RobotId> robots(Collection<ProcessId> ids) {
    return ids.stream().map(ProcessId::robot).distinct().sorted().collect(Collectors.toList());
  }

  /** The number of the start of the robot's program that has this id, from 1. */
  public long boot() {
    return inc >>> Integer.SIZE;
  }

  @Override
  public int compareTo(ProcessId other) {
    int byRobot = robot.compareTo(other.robot);
    return byRobot != 0 ? byRobot : Long.compare(inc, other.inc);
  }

  @Override
  public String toString() {
    long number = inc & 0xffff_ffffL;
    if (number != 1) {
      return robot + "." + boot() + "." + number;
    }
    return boot() == 1 ? robot.name() : robot + "." + boot();
  }

  /**
   * Parses the text of {@link #toString}.
   *
   * @throws IllegalArgumentException if {@code text} has another form
   */
  public static ProcessId parse(String text) {
    Matcher parts = TEXT.matcher(text);
    if (parts.matches() && RobotId.isValid(parts.group(1))) {
      long inc = (number(parts.group(2)) << Integer.SIZE) + number(parts.group(3));
      ProcessId id = new ProcessId(new RobotId(parts.group(1)), inc);
      // Each id has one text.
      if (id.toString().equals(text)) {
        return id;
      }
    }
    throw new IllegalArgumentException(
        "process id '"
            + text
            + "': expected a robot, such as bot0, or robot.boot or robot.boot.number");
  }

  private static long number(@Nullable String digits) {
    return digits == null ? 1 : Long.parseLong(digits);
  }
}
