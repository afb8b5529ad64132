package org.starl;

import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.platform.Timer;
import org.starl.time.Time;

/**
 * A robot's app. Extend {@link LogicThread}, whose {@code callStarL} blocks; in Kotlin also {@code
 * SuspendedThread}, whose {@code callStarL} suspends and so needs no stack of its own.
 *
 * <p>The app, its message handlers and its timers run on the robot's strand, one at a time: the
 * code between two waits is one atomic action, and no lock is needed. Wait only with {@code sleep}
 * or {@code await}, never with {@code Thread.sleep}, a lock, or input and output.
 */
public abstract class RobotApp {

  protected final GlobalVarHolder gvh;

  // Copies of gvh.plat's, so that a wait reads one object less.
  final Strand strand;
  final Clock clock;
  String awaited = "";

  RobotApp(GlobalVarHolder gvh) {
    this.gvh = gvh;
    this.strand = gvh.plat.strand;
    this.clock = gvh.plat.clock;
  }

  /** Starts the app on the strand; {@code whenFinished} takes its results there. */
  protected abstract void launch(Consumer<List<Object>> whenFinished);

  /** {@code stack}, with the line of {@code callStarL} that {@link #inSource()} tells. */
  public final StackTraceElement[] inSource(StackTraceElement[] stack) {
    StackTraceElement source = inSource();
    if (source == null) {
      return stack;
    }
    StackTraceElement[] inSource = stack.clone();
    for (int i = 0; i < stack.length; i++) {
      boolean isApp = stack[i].getClassName().equals(source.getClassName());
      if (isApp && stack[i].getMethodName().equals(source.getMethodName())) {
        inSource[i] = source;
      }
    }
    return inSource;
  }

  /**
   * Where {@code callStarL} is in a source that this class is generated from, for stacks; null if
   * the class itself is the source.
   */
  protected @Nullable StackTraceElement inSource() {
    return null;
  }

  /**
   * A person shows this robot a point; does nothing unless overridden. Runs on the strand between
   * two actions, even while {@code callStarL} waits; never while the robot is down or not started.
   *
   * @param xMm in the world frame, as is {@code yMm}
   */
  public void receivedPointInput(int xMm, int yMm) {}

  /**
   * Runs {@code action} every {@code periodMs}, also while {@code callStarL} waits: a second flow of
   * the same program, such as a dispatcher beside the robot's own work. It runs on the strand between
   * two actions, so it needs no lock, and it must not wait. It ends with the program; periods that
   * have passed while the strand was busy are left out.
   *
   * @param periodMs above 0; the first time is one period from now
   * @return the timer, to cancel it; also from {@code action}
   */
  protected final Timer every(long periodMs, Runnable action) {
    if (periodMs <= 0) {
      throw new IllegalArgumentException("period " + periodMs + " ms: expected above 0");
    }
    long[] nextNs = {inMs(periodMs)};
    Timer[] timer = new Timer[1];
    timer[0] =
        gvh.plat.timers.timer(() -> {
          long lateMs = (clock.nowNs() - nextNs[0]) / Time.NS_PER_MS;
          nextNs[0] = Time.afterMs(nextNs[0], (lateMs / periodMs + 1) * periodMs);
          timer[0].set(nextNs[0]);
          action.run();
        });
    timer[0].set(nextNs[0]);
    return timer[0];
  }

  /** The name of the condition that the app waits for; empty if it has none. */
  public final String awaited() {
    return awaited;
  }

  /** The time in {@code ms} milliseconds, by the robot's clock. */
  final long inMs(long ms) {
    return Time.afterMs(clock.nowNs(), ms);
  }
}
