package org.starl.sim.replay;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.motion.MotionTask;
import org.starl.shape.Geometry;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.sim.SimObserver;
import org.starl.sim.check.MalformedBytes;
import org.starl.trace.Instance;
import org.starl.trace.Note;
import org.starl.trace.TraceCodec;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceReader;
import org.starl.trace.TraceWriter;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/**
 * Reads arbitrary bytes as a trace: they are refused with one line, or all events can be written
 * and read again unchanged. A truncated trace is always refused.
 */
public class TraceFuzzTest {

  private static final String FILE = "fuzz.trace";

  /** A fact of the known ones. */
  record Request(RobotId of, SortedSet<Long> numbers, Optional<Point> at) {
    static final RecordShape<Request> SHAPE =
        Shapes.of(
            Request.class,
            Shapes.part("of", Shapes.ROBOT, Request::of),
            Shapes.part("numbers", Shapes.set(Shapes.LONG, 9), Request::numbers),
            Shapes.part("at", Shapes.optional(Geometry.POINT), Request::at),
            Request::new);
  }

  private static final Var<MotionTask> POSITION = Var.of("mypos", MotionTask.SHAPE);
  private static final Instance TALK = Instance.of("talk", "1");
  private static final Vocabulary VOCABULARY =
      Vocabulary.NONE
          .facts("mutex", Request.SHAPE)
          .variables("gvh", POSITION)
          .messages("talk", Shapes.TEXT);

  public static void fuzzerTestOneInput(byte[] input) {
    List<TraceEvent> events = new ArrayList<>();
    TraceHeader header = show(input, events);
    if (header == null) {
      return;
    }
    byte[] again = written(header, events);
    List<TraceEvent> eventsAgain = new ArrayList<>();
    require(header.equals(show(again, eventsAgain)), "different header");
    // Two readers have shapes of their own for what is not in the vocabulary.
    require(Arrays.equals(again, written(header, eventsAgain)), "different events");
    byte[] cut = Arrays.copyOf(input, input.length - 1);
    require(show(cut, new ArrayList<>()) == null, "truncated trace accepted");
  }

  /** Adds the trace's events to {@code events}; returns its header, or null if it is refused. */
  private static @Nullable TraceHeader show(byte[] bytes, List<TraceEvent> events) {
    SimObserver observer =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            events.add(event);
          }
        };
    try (TraceReader reader = new TraceReader(FILE, new ByteArrayInputStream(bytes), VOCABULARY)) {
      TracePlayer.show(FILE, reader, List.of(), List.of(observer), List::of);
      return reader.header();
    } catch (IOException | BadInput refused) {
      String line = String.valueOf(refused.getMessage());
      require(line.startsWith(FILE + ":") && line.length() < 500, line);
      require(line.chars().noneMatch(Character::isISOControl), "control characters: " + line);
      return null;
    }
  }

  private static byte[] written(TraceHeader header, List<TraceEvent> events) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (TraceWriter writer = new TraceWriter(out, header)) {
      long lastNs = 0;
      for (TraceEvent event : events) {
        require(TraceCodec.rounded(event).equals(event), "not rounded: " + event);
        writer.record(event);
        lastNs = event.timeNs();
      }
      writer.end(lastNs);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    return out.toByteArray();
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  @Test
  void aTraceIsReadAsWrittenOrRefused() {
    RobotId bot = new RobotId("bot0");
    TraceHeader header =
        new TraceHeader("0.1.0", "walk", 7, -8, Map.of("loss", "0.1"), List.of(bot));
    Request request =
        new Request(bot, new TreeSet<>(List.of(-1L, 5L)), Optional.of(new Point(1.5, -2e-7)));
    MotionTask task =
        new MotionTask.GoTo(new ItemPosition("dock", 1, 2.5), new Circle(new Point(0, 1 / 3.0), 4));
    List<TraceEvent> events =
        List.of(
            new TraceEvent.Joined(0, bot, new Pose(1.5, -2, 0.25), 165),
            new TraceEvent.Moved(5, bot, new Pose(1e12, -2, -3), 250, -0.5),
            TraceEvent.Action.of(6, bot, Instance.of("mutex", "a"), Request.SHAPE, request),
            TraceEvent.Action.of(
                6, bot, Instance.APP, Note.SHAPE, new Note("said", List.of("\"\\\n\u2028"))),
            TraceEvent.Action.of(6, bot, Instance.of("other"), Request.SHAPE, request),
            new TraceEvent.Variable(7, bot, Instance.of("gvh"), POSITION, task),
            new TraceEvent.Variable(7, bot, Instance.APP, POSITION, task),
            new TraceEvent.Sent(8, bot, "bot1", TALK, 3, 40, Shapes.TEXT, "\u00e4\ud83d\ude00"),
            new TraceEvent.Delivered(9, bot, bot, TALK, 3, Shapes.TEXT, "hi"),
            new TraceEvent.Dropped(9, bot, "?", "loss"),
            new TraceEvent.Fault(9, bot, TraceEvent.Fault.CRASH, ""),
            new TraceEvent.Intervention(9, bot, 4, TraceEvent.Intervention.POINT, "1,2"),
            new TraceEvent.Left(10, bot));
    List<byte[]> samples = new ArrayList<>();
    samples.add(written(header, events));
    for (TraceEvent event : events.subList(2, events.size() - 1)) {
      samples.add(written(header, List.of(event)));
    }
    samples.add((TraceCodec.line(events.get(2)) + "\n").getBytes(StandardCharsets.UTF_8));

    MalformedBytes.feed(samples, TraceFuzzTest::fuzzerTestOneInput);
  }
}
