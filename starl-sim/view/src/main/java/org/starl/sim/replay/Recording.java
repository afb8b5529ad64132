package org.starl.sim.replay;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.platform.LogSink.Level;
import org.starl.sim.Failure;
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
 * All events of one run, live or from a trace, with the marks on its timeline. One thread fills it
 * as an observer of the run. Other threads may read it meanwhile: the first {@link #size} events
 * never change, except that numbers of an event that goes to the temporary file are rounded as in a
 * trace, lengths to 0.001 mm and angles to 0.000001 rad.
 */
public final class Recording implements SimObserver {

  /** Share of Java's memory; the rest is for the run, the window and its checkpoints. */
  private static final double SHARE_OF_MEMORY = 0.3;

  private static final int ALL = Integer.MAX_VALUE;

  private final Obstacles obstacles;
  private final Checkpoints checkpoints;
  private final long mostBytes;
  private final EventInterner interner = new EventInterner();
  private final EventStore events = new EventStore();
  private final AppendOnlyList<Mark> marks = new AppendOnlyList<>();
  private final AppendOnlyList<LogLine> logs = new AppendOnlyList<>();
  private volatile @Nullable TraceHeader header;
  private volatile boolean isOver;
  private volatile long endNs;
  private volatile int checked = ALL;
  private volatile String failure = "";
  private volatile @Nullable Failure wentWrong;

  /**
   * @param obstacles obstacles of the world, hidden ones included
   * @param layer has observed no event; owned by the recording
   */
  public Recording(Obstacles obstacles, Layer layer) {
    this(obstacles, layer, (long) (SHARE_OF_MEMORY * Runtime.getRuntime().maxMemory()));
  }

  /**
   * Makes a recording of limited memory.
   *
   * @param mostBytes approximate limit for the memory of its events; more are in a temporary file
   */
  public Recording(Obstacles obstacles, Layer layer, long mostBytes) {
    this.obstacles = obstacles;
    this.mostBytes = mostBytes;
    checkpoints = new Checkpoints(new Scene(obstacles), layer);
  }

  @Override
  public void started(TraceHeader newHeader) {
    header = newHeader;
  }

  /**
   * @throws BadInput if the events need too much memory, and there is no place for temporary files
   */
  @Override
  public void observed(TraceEvent event) {
    int index = events.size();
    events.add(interner.intern(event), interner.bytes() <= mostBytes);
    if (event.timeNs() > endNs) {
      endNs = event.timeNs();
    }
    if (event instanceof Fault fault) {
      marks.add(new Mark(fault.timeNs(), index, kind(fault), text(fault)));
    } else if (event instanceof Intervention done) {
      String target = done.robot().equals(Fault.WORLD) ? "" : " to " + done.robot();
      String what = "intervention: " + done.name() + " " + done.detail();
      marks.add(new Mark(done.timeNs(), index, Mark.Kind.INTERVENTION, what.strip() + target));
    }
  }

  @Override
  public void violated(SpecReport.Violation violation) {
    violated(Math.max(0, events.size() - 1), violation);
  }

  /** Marks a violation at event {@code index}, which may be an earlier one. */
  void violated(int index, SpecReport.Violation violation) {
    marks.add(new Mark(violation.timeNs(), index, Mark.Kind.VIOLATION, violation.toString()));
  }

  @Override
  public void logged(long timeNs, RobotId robot, Level level, String tag, String line) {
    logs.add(new LogLine(timeNs, events.size(), robot, tag, line));
  }

  @Override
  public void finished(SimResult result) {
    over(result.endNs());
  }

  @Override
  public void wentWrong(Failure newFailure) {
    wentWrong = newFailure;
  }

  /** What went wrong first; null if nothing did, or if that is not known yet. */
  public @Nullable Failure wentWrong() {
    return wentWrong;
  }

  /** Advances {@link #endNs} to {@code timeNs} without an event. */
  public void reached(long timeNs) {
    if (timeNs > endNs) {
      endNs = timeNs;
    }
  }

  /** Marks the end of the run at {@code timeNs}: no more events follow. */
  public void over(long timeNs) {
    reached(timeNs);
    isOver = true;
  }

  /**
   * Marks the end of the run, or of its trace, by an error.
   *
   * @param why one line
   */
  public void failed(String why) {
    failure = why;
    if (wentWrong == null) {
      wentWrong = Failure.ofError(why, endNs);
    }
    over(endNs);
  }

  /** Declares that the specifications are checked later, and report with {@link #checked(int)}. */
  void toBeChecked() {
    checked = 0;
  }

  /** Sets the number of events that the specifications have checked. */
  void checked(int count) {
    checked = count;
  }

  /** Declares that the specifications have checked all events and the end. */
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
    String target = fault.robot().equals(Fault.WORLD) ? "" : fault.robot() + " ";
    String what = target + fault.name();
    return fault.detail().isEmpty() ? what : what + ": " + fault.detail();
  }

  /**
   * The header of the run's trace.
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

  /** Obstacles of the world, hidden ones included. */
  public Obstacles obstacles() {
    return obstacles;
  }

  /** Number of events so far. */
  public int size() {
    return events.size();
  }

  /** Time of an event; increases with {@code index}, or stays equal. */
  public long timeNs(int index) {
    return events.get(index).timeNs();
  }

  public TraceEvent event(int index) {
    return events.get(index);
  }

  /** Number of the first event after {@code timeNs}; {@link #size} if there is none. */
  public int firstAfter(long timeNs) {
    return events.firstAfter(timeNs);
  }

  /** Time that the run has reached; its end, once it is over. */
  public long endNs() {
    return endNs;
  }

  /** Whether no more events follow; violations may still be found until {@link #isChecked}. */
  public boolean isOver() {
    return isOver;
  }

  /** The error that ended the run, or its trace, in one line; empty if there is none. */
  public String failure() {
    return failure;
  }

  /**
   * Whether the specifications have checked all events so far. Always true for a live run; a trace
   * is first read and then checked.
   */
  public boolean isChecked() {
    return checked == ALL;
  }

  /** Number of events that the specifications have checked. */
  public int checked() {
    return Math.min(checked, size());
  }

  /** The marks on the timeline so far, in the order in which they were found. */
  public List<Mark> marks() {
    return marks.view();
  }

  /** Log lines so far, in order; none in a recording of a trace. */
  public List<LogLine> logs() {
    return logs.view();
  }

  Checkpoints checkpoints() {
    return checkpoints;
  }
}
