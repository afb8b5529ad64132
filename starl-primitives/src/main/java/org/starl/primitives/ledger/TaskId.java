package org.starl.primitives.ledger;

import static org.starl.shape.Shapes.part;

import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The name of a task, the same on all robots, for ever: where it comes from, and its number there. The
 * tasks of one source are added in the order of their numbers, so that a ledger needs to remember only
 * the last one of each.
 *
 * @param source such as a list of orders or a robot, 1 to 31 characters
 * @param number 1, 2, 3, ...
 */
public record TaskId(String source, long number) implements Comparable<TaskId> {

  private static final int MAX_SOURCE = 31;

  /** Its shape. */
  public static final Shape<TaskId> SHAPE =
      Shapes.of(
          TaskId.class,
          part("source", Shapes.TEXT, TaskId::source),
          part("number", Shapes.LONG, TaskId::number),
          TaskId::new);

  public TaskId {
    if (source.isEmpty() || source.length() > MAX_SOURCE) {
      throw new IllegalArgumentException(
          "source of a task '" + source + "': expected 1 to " + MAX_SOURCE + " characters");
    }
    if (number < 1) {
      throw new IllegalArgumentException("number of a task " + number + ": expected at least 1");
    }
  }

  @Override
  public int compareTo(TaskId other) {
    int bySource = source.compareTo(other.source);
    return bySource != 0 ? bySource : Long.compare(number, other.number);
  }

  /** {@code orders/17}. */
  @Override
  public String toString() {
    return source + "/" + number;
  }
}
