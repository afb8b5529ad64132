package org.starl.sim.replay;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.platform.LogSink.Level;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Intervention;
import org.starl.trace.TraceHeader;

/**
 * All events of one run, recorded live or read from a trace, with marks and log lines. One thread
 * fills it, as an observer of the run; other threads may read it concurrently without blocking: the
 * events counted by {@link #size} do not change.
 */
public final class Recording implements SimObserver {

  /** The fraction of Java's memory for the recording; the rest is for the run and the viewers. */
  private static final double SHARE_OF_MEMORY = 0.6;

  private static final int ALL = Integer.MAX_VALUE;
  private static final long BYTES_IN_MB = 1 << 20;
  private static final long NS_PER_S = 1_000_000_000;

  private final Obstacles obstacles;
  private final Checkpoints checkpoints;
  private final long mostBytes;
  private final Compactor compactor = new Compactor();
  private final Chunks<TraceEvent> events = new Chunks<>();
  private final Chunks<Mark> marks = new Chunks<>();
  private final Chunks<LogLine> logs = new Chunks<>();
  private volatile @Nullable TraceHeader header;
  private volatile boolean isOver;
  private volatile long endNs;
  private volatile int checked = ALL;
  private volatile String failure = "";

  /**
   * @param obstacles of the world, hidden ones included
   * @param layer that has observed no event; owned by the recording
   */
  public Recording(Obstacles obstacles, Layer layer) {
    this(obstacles, layer, (long) (SHARE_OF_MEMORY * Runtime.getRuntime().maxMemory()));
  }

  /**
   * Creates a recording of bounded size.
   *
   * @param mostBytes approximate memory limit of its events
   */
  Recording(Obstacles obstacles, Layer layer, long mostBytes) {
    this.obstacles = obstacles;
    this.mostBytes = mostBytes;
    checkpoints = new Checkpoints(new Scene(obstacles), layer);
  }

  @Override
  public void started(TraceHeader newHeader) {
    header = newHeader;
  }

  /**
   * @throws BadInput if the events exceed the memory limit
   */
  @Override
  public void observed(TraceEvent event) {
    int index = events.size();
    events.add(compactor.compact(event));
    if (compactor.bytes() > mostBytes) {
      throw new BadInput(
          "the run has too many events to be kept: "
              + index
              + " by "
              + event.timeNs() / NS_PER_S
              + " s take "
              + mostBytes / BYTES_IN_MB
              + " MB; expected a shorter run, or more memory for Java (STARL_JAVA_OPTS=-Xmx8g)");
    }
    if (event.timeNs() > endNs) {
      endNs = event.timeNs();
    }
    if (event instanceof Fault fault) {
      marks.add(new Mark(fault.timeNs(), index, kind(fault), text(fault)));
    } else if (event instanceof Intervention done) {
      String whom = done.robot().equals(Fault.WORLD) ? "" : " to " + done.robot();
      String what = "a person: " + done.name() + " " + done.detail();
      marks.add(new Mark(done.timeNs(), index, Mark.Kind.INTERVENTION, what.strip() + whom));
    }
  }

  @Override
  public void violated(SpecReport.Violation violation) {
    violated(Math.max(0, events.size() - 1), violation);
  }

  /** Found at an event that may be long past. */
  void violated(int index, SpecReport.Violation violation) {
    marks.add(new Mark(violation.timeNs(), index, Mark.Kind.VIOLATION, violation.toString()));
  }

  @Override
  public void logged(long timeNs, RobotId robot, Level level, String tag, String line) {
    logs.add(new LogLine(timeNs, events.size(), robot, level, tag, line));
  }

  @Override
  public void finished(SimResult result) {
    over(result.endNs());
  }

  /** Advances the time to {@code timeNs} without an event. */
  public void reached(long timeNs) {
    if (timeNs > endNs) {
      endNs = timeNs;
    }
  }

  /** Ends the recording with the run's result. */
  public void over(long timeNs) {
    reached(timeNs);
    isOver = true;
  }

  /**
   * Ends the recording with an error of the run or of its reader.
   *
   * @param why one line
   */
  void failed(String why) {
    failure = why;
    over(endNs);
  }

  /** Declares that the events are checked later, as reported by {@link #checked}. */
  void toBeChecked() {
    checked = 0;
  }

  /** The specifications have looked at so many events. */
  void checked(int count) {
    checked = count;
  }

  /** The specifications have looked at everything, the end too. */
  void allChecked() {
    checked = ALL;
  }

  private static Mark.Kind kind(Fault fault) {
    return switch (fault.name()) {
      case Fault.CRASH -> Mark.Kind.CRASH;
      case Fault.RESTART -> Mark.Kind.RESTART;
      default -> Mark.Kind.FAULT;
    };
  }

  private static String text(Fault fault) {
    String whom = fault.robot().equals(Fault.WORLD) ? "" : fault.robot() + " ";
    String what = whom + fault.name();
    return fault.detail().isEmpty() ? what : what + ": " + fault.detail();
  }

  /**
   * The header of the run.
   *
   * @throws IllegalStateException if the run has not begun
   */
  public TraceHeader header() {
    TraceHeader known = header;
    if (known == null) {
      throw new IllegalStateException("the run has not begun");
    }
    return known;
  }

  /** Whether {@link #header} is known. */
  public boolean hasBegun() {
    return header != null;
  }

  /** The obstacles of the world, hidden ones included. */
  public Obstacles obstacles() {
    return obstacles;
  }

  /** The number of events so far. */
  public int size() {
    return events.size();
  }

  /** When the event of that number happened; never before the one of the number before. */
  public long timeNs(int index) {
    return events.get(index).timeNs();
  }

  public TraceEvent event(int index) {
    return events.get(index);
  }

  /** The number of the first event that is later; {@link #size} if there is none. */
  public int firstAfter(long timeNs) {
    int from = 0;
    int to = size();
    while (from < to) {
      int middle = (from + to) >>> 1;
      if (timeNs(middle) <= timeNs) {
        from = middle + 1;
      } else {
        to = middle;
      }
    }
    return from;
  }

  /** The time that the run has reached; its end, once it is over. */
  public long endNs() {
    return endNs;
  }

  /**
   * Whether all events are recorded; {@link #isChecked} tells whether more violations may be found.
   */
  public boolean isOver() {
    return isOver;
  }

  /** The error of the run or of the reader, in one line; empty if there is none. */
  public String failure() {
    return failure;
  }

  /**
   * Whether the specifications have checked all events so far; false only while a trace is checked,
   * after it was read.
   */
  public boolean isChecked() {
    return checked == ALL;
  }

  /** The number of events that the specifications have checked. */
  public int checked() {
    return Math.min(checked, size());
  }

  /** The marks of the timeline so far, in the order in which they were found. */
  public List<Mark> marks() {
    return marks.view();
  }

  /** The log lines so far, in order; none in a recording of a trace. */
  public List<LogLine> logs() {
    return logs.view();
  }

  Checkpoints checkpoints() {
    return checkpoints;
  }
}
