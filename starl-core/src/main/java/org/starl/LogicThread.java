package org.starl;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
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
public abstract class LogicThread extends RobotApp {

  private final long stepPeriodMs;
  private final long stepPhaseNs;

  /** An app that overrides {@link #callStarL}. */
  protected LogicThread(GlobalVarHolder gvh) {
    super(gvh);
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
    super(gvh);
    if (stepPeriodMs <= 0 || stepPhaseNs < 0) {
      throw new IllegalArgumentException(
          String.format(
              "step period %s ms, phase %s ns: expected above 0, and at least 0",
              stepPeriodMs, stepPhaseNs));
    }
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

  @Override
  protected final void launch(Consumer<List<Object>> whenFinished) {
    if (stepPeriodMs > 0) {
      new Stepper(whenFinished).begin();
    } else {
      strand.start(() -> whenFinished.accept(run()));
    }
  }

  /** Runs {@link #callStarL}. In the stack of an exception its line is that of {@link #inSource()}. */
  private List<Object> run() {
    try {
      return callStarL();
    } catch (RuntimeException | Error e) {
      for (Throwable each = e; each != null; each = each.getCause()) {
        each.setStackTrace(inSource(each.getStackTrace()));
      }
      throw e;
    }
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

  /**
   * Waits until {@code condition} holds or {@code timeoutMs} have passed.
   *
   * @return whether the condition held
   */
  protected final boolean await(BooleanSupplier condition, long timeoutMs) {
    return strand.awaitUntil(condition, inMs(timeoutMs));
  }

  /** Calls {@link #step} at multiples of the period after the start, so that it does not drift. */
  private final class Stepper implements Runnable {
    private final Consumer<List<Object>> whenFinished;
    private final Timer timer = gvh.plat.timers.timer(this);
    private long dueNs;

    Stepper(Consumer<List<Object>> whenFinished) {
      this.whenFinished = whenFinished;
    }

    void begin() {
      dueNs = clock.nowNs() + stepPhaseNs;
      timer.set(dueNs);
    }

    @Override
    public void run() {
      if (step()) {
        dueNs += stepPeriodMs * Time.NS_PER_MS;
        timer.set(dueNs);
      } else {
        whenFinished.accept(returnResults());
      }
    }
  }
}
