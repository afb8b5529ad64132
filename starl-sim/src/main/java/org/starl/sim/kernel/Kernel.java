package org.starl.sim.kernel;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.Timer;

/**
 * Runs events in the order of their virtual time, and events of equal time in scheduling order. An
 * event belongs to a robot's {@link SimStrand} or, if it is scheduled here, to the world. All
 * methods must be called from the thread that calls {@link #run}: before it, after it, or from
 * inside an event.
 */
public final class Kernel implements Clock, AutoCloseable {

  /** The time limit for an app that blocks outside the kernel, in real time. */
  public static final Duration FOREIGN_WAIT_LIMIT = Duration.ofSeconds(10);

  final EventQueue queue = new EventQueue();

  private final CarrierKind carrierKind;
  private final Duration foreignWaitLimit;
  private final Set<SimStrand> strandsWithApps = new LinkedHashSet<>();
  private final List<SimStrand> strandsToUnwind = new ArrayList<>();
  private @Nullable SimStrand current;
  private @Nullable PinWatch pinWatch;
  private @Nullable InstantGuard guard;
  private @Nullable Thread thread;
  private long nowNs;
  private long events;
  private int eventsNow;
  private boolean isRunning;
  private boolean isClosed;
  private volatile boolean isAbandoned;

  public Kernel(CarrierKind carrierKind) {
    this(carrierKind, FOREIGN_WAIT_LIMIT);
  }

  /**
   * @param foreignWaitLimit how long, in real time, an app may block outside the kernel ({@code
   *     Thread.sleep}, a lock, input) before the run fails; above 0
   */
  public Kernel(CarrierKind carrierKind, Duration foreignWaitLimit) {
    if (foreignWaitLimit.isNegative() || foreignWaitLimit.isZero()) {
      throw new IllegalArgumentException("limit " + foreignWaitLimit + ": expected above 0");
    }
    this.carrierKind = carrierKind;
    this.foreignWaitLimit = foreignWaitLimit;
  }

  /** Virtual time of the current or last event, in ns from the start of the run. */
  @Override
  public long nowNs() {
    return nowNs;
  }

  /** Whether no event is left. */
  public boolean isIdle() {
    return queue.size() == 0;
  }

  /** Ends the run after the current event; called from another thread. */
  public void abandon() {
    isAbandoned = true;
  }

  /** The number of events run so far. */
  public long events() {
    return events;
  }

  /**
   * Schedules an event of the world.
   *
   * @throws IllegalArgumentException if {@code atNs} is in the past
   */
  public void schedule(long atNs, Runnable event) {
    add(atNs, null, event);
  }

  /**
   * Runs {@code piece} on {@code strand} at {@code atNs}, or drops it if the strand is closed by
   * then. Allocates nothing, so that the caller can schedule the same piece repeatedly.
   *
   * @throws IllegalArgumentException if {@code atNs} is in the past
   */
  public void schedule(long atNs, SimStrand strand, Runnable piece) {
    add(atNs, strand, piece);
  }

  /**
   * Runs {@code piece} on {@code strand} inside the running event of the world, unless the strand is
   * closed: for an event that happens to several robots at once.
   */
  public void runNow(SimStrand strand, Runnable piece) {
    if (current != null) {
      throw new IllegalStateException(current + " runs: only an event of the world may do this");
    }
    if (!strand.isClosed()) {
      strand.run(piece);
    }
  }

  /**
   * Prefetches what pieces of {@code strand} use ({@link Cache}), for events of the world that run
   * pieces on several strands.
   */
  public static int prefetch(SimStrand strand) {
    return strand.touch();
  }

  /** The name of the strand of the last event; empty for an event of the world. */
  public String lastStrand() {
    SimStrand strand = queue.strand();
    return strand == null ? "" : strand.name();
  }

  /** Creates a timer of the world, not yet set. */
  public Timer timer(Runnable action) {
    return new KernelTimer(this, null, action);
  }

  /** Creates a strand; its name appears in messages. */
  public SimStrand strand(String name) {
    return new SimStrand(this, name);
  }

  /**
   * Runs events until the queue is empty, or the next event is later than {@code untilNs} (the time
   * is then {@code untilNs}), or {@code finished} holds, which is evaluated after each event.
   *
   * @throws RobotError if a strand's piece or app throws; an exception of an event of the world is
   *     rethrown unchanged. In both cases the kernel must be closed next.
   */
  public void run(long untilNs, BooleanSupplier finished) {
    begin();
    try {
      while (queue.poll(untilNs)) {
        SimStrand strand = queue.strand();
        if (strand != null && strand.isClosed()) {
          continue;
        }
        events++;
        if (queue.atNs() == nowNs) {
          eventsNow++;
          if (eventsNow > InstantGuard.SUSPICIOUS) {
            guard().count(nowNs, strand);
          }
        } else {
          nowNs = queue.atNs();
          eventsNow = 0;
        }
        if (strand == null) {
          queue.piece().run();
        } else {
          strand.run(queue.piece());
        }
        if (isAbandoned) {
          throw new IllegalStateException("the run was given up during this action");
        }
        if (!strandsToUnwind.isEmpty()) {
          unwindClosedStrands();
        }
        if (finished.getAsBoolean()) {
          return;
        }
      }
      if (queue.size() > 0) {
        nowNs = Math.max(nowNs, untilNs);
      }
    } finally {
      isRunning = false;
      thread = null;
    }
  }

  /**
   * Ends the run: closes every strand whose app still waits, in the order in which the apps
   * started.
   *
   * @throws RobotError if an app failed while it was unwound, or did not end; the other apps are
   *     unwound nevertheless
   */
  @Override
  public void close() {
    if (isRunning) {
      throw new IllegalStateException("a kernel cannot be closed by one of its events");
    }
    isClosed = true;
    RobotError failure = null;
    for (SimStrand strand : new ArrayList<>(strandsWithApps)) {
      try {
        strand.close();
        strand.unwindApp();
      } catch (RobotError e) {
        if (failure == null) {
          failure = e;
        } else {
          failure.addSuppressed(e);
        }
      }
    }
    strandsWithApps.clear();
    if (pinWatch != null) {
      pinWatch.close();
    }
    if (failure != null) {
      throw failure;
    }
  }

  /** Adds an event, and returns its slot. */
  int add(long atNs, @Nullable SimStrand strand, Runnable piece) {
    if (atNs < nowNs) {
      throw new IllegalArgumentException(
          "scheduled at " + atNs + " ns, which is before now, " + nowNs + " ns");
    }
    if (guard != null && atNs == nowNs) {
      guard.checkAdd(nowNs, current);
    }
    return queue.add(atNs, strand, piece);
  }

  /**
   * The action that runs now, for a watch on another thread. A watch sees the values of different
   * moments while the kernel goes on, and consistent ones while one action does not end.
   */
  public Activity activity() {
    SimStrand strand = current;
    Thread app = strand == null ? null : strand.runningAppThread();
    return new Activity(events, nowNs, strand == null ? "" : strand.name(), thread, app);
  }

  /** The strand that runs now, or null while an event of the world runs. */
  @Nullable SimStrand current() {
    return current;
  }

  void setCurrent(@Nullable SimStrand strand) {
    current = strand;
  }

  /** An app without a carrier starts. */
  void appBegins(SimStrand strand) {
    strandsWithApps.add(strand);
  }

  Carrier carry(SimStrand strand, Runnable app) {
    appBegins(strand);
    if (carrierKind == CarrierKind.PLATFORM) {
      return new PlatformCarrier(strand.name(), app, foreignWaitLimit);
    }
    if (pinWatch == null) {
      pinWatch = new PinWatch(foreignWaitLimit);
    }
    return new VirtualCarrier(strand.name(), app, foreignWaitLimit, pinWatch);
  }

  void appIsOver(SimStrand strand) {
    strandsWithApps.remove(strand);
  }

  /** Unwinds a closed strand's app: at once or, if a strand runs now, after its piece. */
  void unwind(SimStrand strand) {
    if (current == null) {
      strand.unwindApp();
    } else {
      strandsToUnwind.add(strand);
    }
  }

  private InstantGuard guard() {
    if (guard == null) {
      guard = new InstantGuard();
    }
    return guard;
  }

  private void begin() {
    if (isRunning || isClosed) {
      throw new IllegalStateException(
          isClosed ? "the kernel is closed" : "the kernel runs already");
    }
    if (carrierKind == CarrierKind.VIRTUAL && Thread.currentThread().isVirtual()) {
      throw new IllegalStateException("a kernel with virtual carriers needs a platform thread");
    }
    thread = Thread.currentThread();
    isRunning = true;
  }

  // Unwinding runs finally blocks, which may close more strands.
  private void unwindClosedStrands() {
    for (int i = 0; i < strandsToUnwind.size(); i++) {
      strandsToUnwind.get(i).unwindApp();
    }
    strandsToUnwind.clear();
  }
}
