package org.starl;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.starl.platform.Clock;
import org.starl.platform.Strand;

/**
 * A robot's app. Override {@link #callStarL}, a blocking state machine as in the paper's Figure 4;
 * or pass a period and override {@link #step}, which is called once a period and never waits.
 *
 * <p>All of it runs on the robot's strand, as do message handlers and timers: what lies between two
 * waits is one atomic action, and nothing needs a lock. A wait is {@link #sleep}, {@link #await} and
 * nothing else: never {@code Thread.sleep}, a lock or input and output.
 */
public abstract class LogicThread {

  protected final GlobalVarHolder gvh;

  // As gvh.plat has them: what every wait needs lies at hand.
  private final Strand strand;
  private final Clock clock;
  private final long stepPeriodMs;
  private final long stepPhaseNs;

  /** An app that overrides {@link #callStarL}. */
  protected LogicThread(GlobalVarHolder gvh) {
    this.gvh = gvh;
    this.strand = gvh.plat.strand;
    this.clock = gvh.plat.clock;
    this.stepPeriodMs = 0;
    this.stepPhaseNs = 0;
  }

  /**
   * An app that overrides {@link #step}, the first time at once.
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
   * @param stepPhaseNs from the start of the robot to the first step, at least 0; robots of unequal
   *     phases do not all step at once
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

  /** The app. When it returns, the robot goes on answering messages until it leaves. */
  public List<Object> callStarL() {
    throw new IllegalStateException(
        getClass().getName() + " overrides neither callStarL() nor, with a period, step()");
  }

  /**
   * One round of an app that never waits.
   *
   * @return whether there is another round; where not, {@link #returnResults} are its results
   */
  protected boolean step() {
    throw new IllegalStateException(getClass().getName() + " has a period but no step()");
  }

  /** What the app has to say at its end; empty unless overridden. */
  protected List<Object> returnResults() {
    return List.of();
  }

  /**
   * A person points at a place, for this robot: does nothing unless overridden. Called on the robot's
   * strand between two of its actions, with {@link #callStarL} while that waits; not while the robot
   * is down, nor before it is up.
   *
   * @param xMm in the world's frame, as is {@code yMm}
   */
  public void receivedPointInput(int xMm, int yMm) {}

  /** The period of {@link #step}, or 0 for an app that overrides {@link #callStarL}. */
  public final long stepPeriodMs() {
    return stepPeriodMs;
  }

  /** From the start of the robot to the first {@link #step}. */
  public final long stepPhaseNs() {
    return stepPhaseNs;
  }

  /** Gives up the strand for {@code ms} milliseconds; messages and timers are handled meanwhile. */
  protected final void sleep(long ms) {
    strand.sleepUntil(inMs(ms));
  }

  /** Gives up the strand until {@code condition} holds. */
  protected final void await(BooleanSupplier condition) {
    strand.awaitUntil(condition, Long.MAX_VALUE);
  }

  /**
   * Gives up the strand until {@code condition} holds or {@code timeoutMs} have passed.
   *
   * @return whether the condition held
   */
  protected final boolean await(BooleanSupplier condition, long timeoutMs) {
    return strand.awaitUntil(condition, inMs(timeoutMs));
  }

  /** The time {@code ms} from now; never, if that is beyond what a clock can show. */
  private long inMs(long ms) {
    long nowNs = clock.nowNs();
    return ms > (Long.MAX_VALUE - nowNs) / NS_PER_MS ? Long.MAX_VALUE : nowNs + ms * NS_PER_MS;
  }
}
