package org.starl.sim.fault;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.BooleanSupplier;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.platform.Timer;
import org.starl.platform.Timers;
import org.starl.sim.kernel.SimStrand;

/**
 * A robot's strand on the robot's own clock. Actions can have a duration: each action (a message, a
 * timer, the app from one wait to the next) then occupies the strand for that time, and later
 * actions wait in order. Positioning and stable storage are not delayed.
 */
public final class ImpairedStrand implements Strand, Timers {

  private final SimStrand strand;
  private final RobotClock clock;
  private final Clock trueClock;
  private final Deque<Runnable> waiting = new ArrayDeque<>();
  private final Timer nextTurn;
  private long computeNs;
  private long busyUntilNs;
  // Whether the last event on the strand ran an action; otherwise it only queued one.
  private boolean wasAction;

  public ImpairedStrand(SimStrand strand, RobotClock clock, Clock trueClock) {
    this.strand = strand;
    this.clock = clock;
    this.trueClock = trueClock;
    nextTurn = strand.timer(this::turn);
  }

  /** Sets the impairment of the robot's time. */
  public void apply(Impairment impairment) {
    clock.set(impairment.driftPpm(), impairment.skewNs());
    computeNs = impairment.computeNs();
  }

  @Override
  public void post(Runnable action) {
    strand.post(() -> pass(action));
  }

  @Override
  public Timer timer(Runnable action) {
    return new ImpairedTimer(action);
  }

  @Override
  public void start(Runnable app) {
    strand.start(() -> {
      hold();
      app.run();
    });
  }

  @Override
  public boolean isCurrent() {
    return strand.isCurrent();
  }

  @Override
  public void sleepUntil(long atNs) {
    do {
      strand.sleepUntil(clock.trueNs(atNs));
    } while (clock.nowNs() < atNs);
    takeTurn();
  }

  @Override
  public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
    boolean isTimed = deadlineNs != Long.MAX_VALUE;
    int[] looks = {0};
    BooleanSupplier afterActions =
        () -> {
          looks[0]++;
          return wasAction && condition.getAsBoolean();
        };
    wasAction = true;
    while (!strand.awaitUntil(afterActions, isTimed ? clock.trueNs(deadlineNs) : deadlineNs)) {
      takeTurn();
      if (condition.getAsBoolean()) {
        return true;
      }
      if (clock.nowNs() >= deadlineNs) {
        return false;
      }
    }
    if (looks[0] > 1) {
      // The app resumes directly after the action that made the condition true.
      hold();
    }
    return true;
  }

  /** Queues {@code action}, as the robot's arrival gate. */
  public void pass(Runnable action) {
    if (isFree()) {
      act(action);
    } else {
      wasAction = false;
      queue(action);
    }
  }

  private void queue(Runnable action) {
    waiting.add(action);
    nextTurn.set(busyUntilNs);
  }

  private void turn() {
    wasAction = false;
    if (trueClock.nowNs() >= busyUntilNs && !waiting.isEmpty()) {
      act(waiting.remove());
    }
    if (!waiting.isEmpty()) {
      nextTurn.set(busyUntilNs);
    }
  }

  private void act(Runnable action) {
    hold();
    wasAction = true;
    action.run();
  }

  private void hold() {
    busyUntilNs = Math.max(busyUntilNs, trueClock.nowNs()) + computeNs;
  }

  private boolean isFree() {
    return waiting.isEmpty() && busyUntilNs <= trueClock.nowNs();
  }

  // The app waits in the queue like every other action.
  private void takeTurn() {
    if (isFree()) {
      hold();
    } else {
      boolean[] isTurn = {false};
      queue(() -> isTurn[0] = true);
      strand.awaitUntil(() -> isTurn[0], Long.MAX_VALUE);
    }
  }

  /** A timer on the robot's clock: its action is queued when it expires. */
  private final class ImpairedTimer implements Timer {
    private final Runnable action;
    private final Runnable turn = this::act;
    private final Timer timer = strand.timer(this::expired);
    private long atNs;
    private boolean isQueued;

    ImpairedTimer(Runnable action) {
      this.action = action;
    }

    @Override
    public void set(long newAtNs) {
      if (newAtNs == atNs && isSet()) {
        return;
      }
      cancel();
      atNs = newAtNs;
      if (newAtNs != NEVER) {
        timer.set(clock.trueNs(newAtNs));
      }
    }

    @Override
    public void cancel() {
      timer.cancel();
      if (isQueued) {
        waiting.remove(turn);
        isQueued = false;
      }
    }

    @Override
    public boolean isSet() {
      return timer.isSet() || (isQueued && !strand.isClosed());
    }

    private void expired() {
      if (clock.nowNs() < atNs) {
        // The clock runs slower than when the timer was set.
        timer.set(clock.trueNs(atNs));
      } else {
        isQueued = true;
        pass(turn);
      }
    }

    private void act() {
      isQueued = false;
      action.run();
    }
  }
}
