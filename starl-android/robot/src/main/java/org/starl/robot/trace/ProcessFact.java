package org.starl.robot.trace;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.TEXT;
import static org.starl.shape.Shapes.part;

import java.util.List;
import org.starl.gvh.Wait;
import org.starl.platform.LogSink;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Vocabulary;

/**
 * What a trace tells of a robot's process: for a child's parent, and for the merging of deployed robots'
 * traces.
 */
public sealed interface ProcessFact {

  /** The instance in the trace. */
  Instance SOURCE = Instance.of("process");

  /**
   * The process has started.
   *
   * @param pid its process id
   */
  record Hello(long pid) implements ProcessFact {}

  /** Its radio's port. */
  record Port(int port) implements ProcessFact {}

  /** Its body waits for room at its start position. */
  record WantsPlace() implements ProcessFact {}

  /**
   * It is alive.
   *
   * @param copies of datagrams so far
   * @param lost of these
   * @param longestPauseNs of its strand
   */
  record Alive(long copies, long lost, long longestPauseNs) implements ProcessFact {}

  /**
   * Its app has ended.
   *
   * @param results as text
   */
  record Finished(List<String> results) implements ProcessFact {

    public Finished {
      results = List.copyOf(results);
    }
  }

  /**
   * It ends before its app.
   *
   * @param awaited the condition that the app waits for
   */
  record Waits(String awaited, List<Wait> waits) implements ProcessFact {

    public Waits {
      waits = List.copyOf(waits);
    }
  }

  /** A line for people. */
  record Log(LogSink.Level level, String tag, String line) implements ProcessFact {}

  /** It ends because of a bug. */
  record Failed(String stackTrace) implements ProcessFact {}

  /**
   * Its clock. First in a deployed robot's trace.
   *
   * @param machine its name
   * @param machineNs the trace's time 0 on that machine's clock
   * @param dateNs the same in ns since 2020, by that machine's date
   */
  record Clock(String machine, long machineNs, long dateNs) implements ProcessFact {}

  /** The shape of a wait. */
  Shape<Wait> WAIT =
      Shapes.of(
          Wait.class,
          part("source", Shapes.text("instance", Instance::name, Instance::named), Wait::source),
          part("what", TEXT, Wait::what),
          part("on", Shapes.list(Shapes.ROBOT, 0xFFFF), Wait::on),
          Wait::new);

  /** The shapes of all facts. */
  SumShape<ProcessFact> SHAPE =
      Shapes.oneOf(
          ProcessFact.class,
          Shapes.of(Hello.class, part("pid", LONG, Hello::pid), Hello::new),
          Shapes.of(Port.class, part("port", Shapes.INT, Port::port), Port::new),
          Shapes.of(WantsPlace.class, WantsPlace::new),
          Shapes.of(
              Alive.class,
              part("copies", LONG, Alive::copies),
              part("lost", LONG, Alive::lost),
              part("longestPauseNs", LONG, Alive::longestPauseNs),
              Alive::new),
          Shapes.of(
              Finished.class,
              part("results", Shapes.list(TEXT, 0xFFFF), Finished::results),
              Finished::new),
          Shapes.of(
              Waits.class,
              part("awaited", TEXT, Waits::awaited),
              part("waits", Shapes.list(WAIT, 0xFFFF), Waits::waits),
              Waits::new),
          Shapes.of(
              Log.class,
              part("level", Shapes.constant(LogSink.Level.class), Log::level),
              part("tag", TEXT, Log::tag),
              part("line", TEXT, Log::line),
              Log::new),
          Shapes.of(Failed.class, part("stackTrace", TEXT, Failed::stackTrace), Failed::new),
          Shapes.of(
              Clock.class,
              part("machine", TEXT, Clock::machine),
              part("machineNs", LONG, Clock::machineNs),
              part("dateNs", LONG, Clock::dateNs),
              Clock::new));

  /** What a reader of traces needs. */
  Vocabulary VOCABULARY = Vocabulary.NONE.facts(SOURCE.primitive(), SHAPE);

  /** Whether an event is of the process, not of its robot: merged traces leave it out. */
  static boolean isProcessEvent(TraceEvent event) {
    return event instanceof TraceEvent.Action action && action.source().equals(SOURCE);
  }
}
