package org.starl.sim.record;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.SumShape;

/**
 * A message in words: {@code Prepare} and {@code [number=1]}.
 *
 * @param name of the record; of another message its whole text
 * @param parts of the record
 */
public record MessageText(String name, String parts) {

  /**
   * @param shape of the message
   * @param without names of parts that are left out
   */
  public static MessageText of(Shape<?> shape, Object message, Set<String> without) {
    RecordShape<?> record = record(shape, message);
    if (record == null) {
      return new MessageText(message.toString(), "");
    }
    List<Object> values = record.values(message);
    return new MessageText(
        record.name(),
        IntStream.range(0, record.parts().size())
            .filter(i -> !without.contains(record.parts().get(i).name()))
            .mapToObj(i -> record.parts().get(i).name() + "=" + values.get(i))
            .collect(Collectors.joining(", ", "[", "]")));
  }

  /** The name alone, without the work for the parts: pictures have thousands of messages. */
  public static String name(Shape<?> shape, Object message) {
    RecordShape<?> record = record(shape, message);
    return record == null ? message.toString() : record.name();
  }

  private static @Nullable RecordShape<?> record(Shape<?> shape, Object message) {
    return shape instanceof SumShape<?> sum
        ? sum.caseOf(message)
        : shape instanceof RecordShape<?> one ? one : null;
  }

  @Override
  public String toString() {
    return name + parts;
  }
}
