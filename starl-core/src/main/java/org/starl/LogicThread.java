package org.starl;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.platform.Timer;
import org.starl.time.Time;

/**
 * A robot's app. Override {@link #callStarL}, a blocking state machine as in the paper's Figure 4;
 * or pass a period and override {@link #step}, which runs once per period and never waits.
 *
 * <p>The app, its message handlers and its timers run on the robot's strand, one at a time: the
 * code between two waits is one atomic action, and no lock is needed. Wait only with {@link #sleep}
 * or {@link #await}, never with {@code Thread.sleep}, a lock, or input and output.
 */
public abstract class LogicThread {

  protected final GlobalVarHolder gvh;

  // Copies of gvh.plat's, so that a wait reads one object less.
  private final Strand strand;
  private final Clock clock;
  private final long stepPeriodMs;
  private final long stepPhaseNs;
  private String awaited = "";

  /** An app that overrides {@link #callStarL}. */
  protected LogicThread(GlobalVarHolder gvh) {
    this.gvh = gvh;
    this.strand = gvh.plat.strand;
    this.clock = gvh.plat.clock;
    this.stepPeriodMs = 0;
    this.stepPhaseNs = 0;
  }

  /**
   * An app that overrides {@link #step}. The first step is at the start of the robot.
   *
   * @param stepPeriodMs above 0
   */
  protected LogicThread(GlobalVarHolder gvh, long stepPeriodMs) {
    this(gvh, stepPeriodMs, 0);
  }

  /**
   * An app that overrides {@link #step}.
   *
   * @param stepPeriodMs above 0
   * @param stepPhaseNs time from the start of the robot to the first step, at least 0; with
   *     different phases, robots do not all step at once
   */
  protected LogicThread(GlobalVarHolder gvh, long stepPeriodMs, long stepPhaseNs) {
    if (stepPeriodMs <= 0 || stepPhaseNs < 0) {
      throw new IllegalArgumentException(
          "step period "
              + stepPeriodMs
              + " ms, phase "
              + stepPhaseNs
              + " ns: expected above 0, and at least 0");
    }
    this.gvh = gvh;
    this.strand = gvh.plat.strand;
    this.clock = gvh.plat.clock;
    this.stepPeriodMs = stepPeriodMs;
    this.stepPhaseNs = stepPhaseNs;
  }

  /**
   * Runs the app. After it returns, the robot still answers messages until it leaves.
   *
   * @return the app's results
   */
  public List<Object> callStarL() {
    throw new IllegalStateException(
        getClass().getName() + " overrides neither callStarL() nor, with a period, step()");
  }

  /** Runs {@link #callStarL}. In the stack of an exception its line is that of {@link #inSource()}. */
  final List<Object> run() {
    try {
      return callStarL();
    } catch (RuntimeException | Error e) {
      for (Throwable each = e; each != null; each = each.getCause()) {
        each.setStackTrace(inSource(each.getStackTrace()));
      }
      throw e;
    }
  }

  /** {@code stack}, with the line of {@link #callStarL} that {@link #inSource()} tells. */
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
   * Where {@link #callStarL} is in a source that this class is generated from, for stacks; null if
   * the class itself is the source.
   */
  protected @Nullable StackTraceElement inSource() {
    return null;
  }

  /**
   * Runs one period of an app that never waits.
   *
   * @return whether there is another step; if not, {@link #returnResults} gives the results
   */
  protected boolean step() {
    throw new IllegalStateException(getClass().getName() + " has a period but no step()");
  }

  /** The results of an app that overrides {@link #step}; empty unless overridden. */
  protected List<Object> returnResults() {
    return List.of();
  }

  /**
   * A person shows this robot a point; does nothing unless overridden. Runs on the strand between
   * two actions, even while {@link #callStarL} waits; never while the robot is down or not started.
   *
   * @param xMm in the world frame, as is {@code yMm}
   */
  public void receivedPointInput(int xMm, int yMm) {}

  /** The period of {@link #step}, or 0 for an app that overrides {@link #callStarL}. */
  public final long stepPeriodMs() {
    return stepPeriodMs;
  }

  /** Time from the start of the robot to the first {@link #step}, in ns. */
  public final long stepPhaseNs() {
    return stepPhaseNs;
  }

  /**
   * Runs {@code action} every {@code periodMs}, also while {@link #callStarL} waits: a second flow of
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

  /**
   * Waits {@code ms} milliseconds. Messages and timers are handled meanwhile.
   *
   * @param ms above 0 in a loop: {@code sleep(0)} lets other events of this moment run, and no time
   *     passes
   */
  protected final void sleep(long ms) {
    strand.sleepUntil(inMs(ms));
  }

  /**
   * Waits until {@code condition} holds. Messages and timers are handled meanwhile. If it holds
   * already, {@code await} returns at once, within the same action, and no time passes: a loop whose
   * conditions always hold never ends. A simulation fails such a loop.
   */
  protected final void await(BooleanSupplier condition) {
    strand.awaitUntil(condition, Long.MAX_VALUE);
  }

  /**
   * Waits until {@code condition} holds, which {@code name} describes: it is shown if the run ends
   * meanwhile.
   */
  protected final void await(String name, BooleanSupplier condition) {
    awaited = name;
    await(condition);
    awaited = "";
  }

  /** Waits at most {@code timeoutMs}, with a name as above. */
  protected final boolean await(String name, BooleanSupplier condition, long timeoutMs) {
    awaited = name;
    boolean held = await(condition, timeoutMs);
    awaited = "";
    return held;
  }

  /** The name of the condition that the app waits for; empty if it has none. */
  public final String awaited() {
    return awaited;
  }

  /**
   * Waits until {@code condition} holds or {@code timeoutMs} have passed.
   *
   * @return whether the condition held
   */
  protected final boolean await(BooleanSupplier condition, long timeoutMs) {
    return strand.awaitUntil(condition, inMs(timeoutMs));
  }

  private long inMs(long ms) {
    return Time.afterMs(clock.nowNs(), ms);
  }
}
