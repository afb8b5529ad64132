package org.starl.cli;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.starl.id.RobotId;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;
import org.starl.trace.TraceWriter;

/** Events of primitives, as a trace writes them. */
public final class TraceLines {

  private TraceLines() {}

  /**
   * An action.
   *
   * @param fact in JSON: <code>{"do_register": {"i": "b"}}</code>
   */
  public static TraceEvent action(long timeNs, RobotId robot, String source, String fact) {
    return read(
        "{\"kind\":\"action\",\"timeNs\":%d,\"robot\":\"%s\",\"source\":\"%s\",\"fact\":%s}"
            .formatted(timeNs, robot, source, fact));
  }

  /**
   * A change of a variable.
   *
   * @param value in JSON
   */
  public static TraceEvent variable(
      long timeNs, RobotId robot, String source, String name, String value) {
    return read(
        ("{\"kind\":\"variable\",\"timeNs\":%d,\"robot\":\"%s\",\"source\":\"%s\",\"name\":\"%s\","
                + "\"value\":%s}")
            .formatted(timeNs, robot, source, name, value));
  }

  /**
   * A delivery.
   *
   * @param message in JSON
   */
  public static TraceEvent delivered(
      long timeNs, RobotId robot, RobotId from, String channel, String message) {
    return read(
        ("{\"kind\":\"delivered\",\"timeNs\":%d,\"robot\":\"%s\",\"from\":\"%s\",\"channel\":\"%s\","
                + "\"seq\":1,\"message\":%s}")
            .formatted(timeNs, robot, from, channel, message));
  }

  private static TraceEvent read(String line) {
    ByteArrayOutputStream text = new ByteArrayOutputStream();
    try (TraceWriter header =
        new TraceWriter(text, new TraceHeader("test", "test", 1, 1, Map.of(), List.of()))) {
      header.flush();
    } catch (IOException e) {
      throw new IllegalArgumentException(line, e);
    }
    String first = text.toString(StandardCharsets.UTF_8).lines().findFirst().orElseThrow();
    byte[] trace = (first + "\n" + line + "\n").getBytes(StandardCharsets.UTF_8);
    try (InputStream in = new ByteArrayInputStream(trace);
        TraceReader reader = new TraceReader("test", in, PrimitiveVocabulary.ALL)) {
      TraceEvent event = reader.next();
      if (event == null) {
        throw new IllegalArgumentException(line);
      }
      return event;
    } catch (IOException e) {
      throw new IllegalArgumentException(line, e);
    }
  }
}
