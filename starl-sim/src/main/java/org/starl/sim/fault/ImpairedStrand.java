package org.starl.sim.fault;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.platform.StrandClosed;
import org.starl.platform.SuspendedApp;
import org.starl.platform.Timer;
import org.starl.platform.Timers;
import org.starl.platform.Waits;
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
  // The wait of an app without a thread.
  private @Nullable Waits<Boolean> suspended;
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
  public void start(SuspendedApp app) {
    strand.start(new Suspended(app));
  }

  @Override
  public void sleepUntil(long atNs) {
    wait(null, atNs).block(strand);
  }

  @Override
  public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
    return wait(condition, deadlineNs).block(strand);
  }

  @Override
  public boolean suspendUntil(
      @Nullable BooleanSupplier condition, long deadlineNs, Object continuation) {
    Waits<Boolean> begun = wait(condition, deadlineNs);
    boolean isOver = hasEnded(begun, false, continuation);
    suspended = isOver ? null : begun;
    return isOver;
  }

  private boolean hasEnded(Waits<Boolean> waits, boolean held, Object continuation) {
    boolean last = held;
    while (!waits.goOn(last)) {
      if (!strand.suspendUntil(waits.condition(), waits.untilNs(), continuation)) {
        return false;
      }
      last = true;
    }
    return true;
  }

  /** One wait of the app, which may be several of the strand; whether the condition held. */
  private Waits<Boolean> wait(@Nullable BooleanSupplier condition, long deadlineNs) {
    return new Waits<>(waits -> {
      if (condition == null) {
        sleep(waits, deadlineNs);
      } else {
        wasAction = true;
        await(waits, new AfterActions(condition), deadlineNs);
      }
    });
  }

  private void sleep(Waits<Boolean> waits, long atNs) {
    waits.until(
        null,
        clock.trueNs(atNs),
        held -> {
          if (clock.nowNs() < atNs) {
            sleep(waits, atNs);
          } else {
            takeTurn(waits, () -> waits.end(false));
          }
        });
  }

  private void await(Waits<Boolean> waits, AfterActions condition, long deadlineNs) {
    boolean isTimed = deadlineNs != Long.MAX_VALUE;
    waits.until(
        condition,
        isTimed ? clock.trueNs(deadlineNs) : deadlineNs,
        held -> {
          if (!held) {
            takeTurn(waits, () -> lookAgain(waits, condition, deadlineNs));
            return;
          }
          if (condition.looks > 1) {
            // The app resumes directly after the action that made the condition true.
            hold();
          }
          waits.end(true);
        });
  }

  private void lookAgain(Waits<Boolean> waits, AfterActions condition, long deadlineNs) {
    if (condition.awaited.getAsBoolean()) {
      waits.end(true);
    } else if (clock.nowNs() >= deadlineNs) {
      waits.end(false);
    } else {
      await(waits, condition, deadlineNs);
    }
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
  private void takeTurn(Waits<?> waits, Runnable then) {
    if (isFree()) {
      hold();
      then.run();
    } else {
      boolean[] isTurn = {false};
      queue(() -> isTurn[0] = true);
      waits.until(() -> isTurn[0], Long.MAX_VALUE, held -> then.run());
    }
  }

  /** An awaited condition, evaluated after actions only. */
  private final class AfterActions implements BooleanSupplier {
    private final BooleanSupplier awaited;
    private int looks;

    AfterActions(BooleanSupplier awaited) {
      this.awaited = awaited;
    }

    @Override
    public boolean getAsBoolean() {
      looks++;
      return wasAction && awaited.getAsBoolean();
    }
  }

  /** The app, resumed at the end of a wait of its own; the strand may resume it more often. */
  private final class Suspended implements SuspendedApp {
    private final SuspendedApp app;

    Suspended(SuspendedApp app) {
      this.app = app;
    }

    @Override
    public boolean resume(
        @Nullable Object continuation, boolean held, @Nullable StrandClosed closed) {
      Waits<Boolean> begun = suspended;
      if (closed != null) {
        return app.resume(continuation, false, closed);
      }
      if (continuation == null || begun == null) {
        hold();
        return app.resume(null, false, null);
      }
      return hasEnded(begun, held, continuation) && app.resume(continuation, begun.result(), null);
    }

    @Override
    public StackTraceElement[] stack(Object continuation) {
      return app.stack(continuation);
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
