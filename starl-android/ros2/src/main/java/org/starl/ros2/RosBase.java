package org.starl.ros2;

import static org.starl.time.Time.NS_PER_MS;

import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.LogSink.Level;
import org.starl.platform.Strand;
import org.starl.robot.create.CreateHold;
import org.starl.robot.create.Guard;
import org.starl.robot.create.HoldNews;
import org.starl.robot.create.ReactionMeter;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Limits;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;

/**
 * The wheels of a base that is a ROS 2 node. The safety stops of the package's contract run here and in
 * the guard, never on the strand.
 */
final class RosBase implements Wheelbase {

  private static final String TAG = "ros2";
  private static final long TICK_NS = 10 * NS_PER_MS;

  /** Period of repeated speeds; bases stop by themselves when they are silent. */
  private static final long HEARTBEAT_NS = 50 * NS_PER_MS;

  private static final long CLOSE_MS = 1000;

  private final String odometryTopic;
  private final SpeedLink.Source links;
  private final Runnable stopDirectly;
  private final Strand strand;
  private final Clock clock;
  private final LogSink log;
  private final Consumer<Throwable> onFailure;
  private final AutoCloseable node;
  private final Guard guard = new Guard();
  private final HoldNews holdNews;
  private final Thread watchdog;

  // Guarded.
  private final BaseState state;
  private final ReactionMeter meter;
  private final OdometryWay way;
  private final double axleMm;
  private @Nullable TravelReceiver odometer;
  private @Nullable SpeedLink link;
  private WheelCommand sent = WheelCommand.STOP;
  private long sentNs = Long.MIN_VALUE;
  private boolean isInformPosted;
  private boolean isClosed;

  // Strand only.
  private Runnable receiver = () -> {};
  private Bumps seenBumps = Bumps.NONE;

  /**
   * @param odometryTopic for messages
   * @param links each through a guard of its own
   * @param stopDirectly stops the wheels while there is no guard
   * @param node is closed at the end
   */
  RosBase(
      String name,
      String odometryTopic,
      double axleMm,
      Limits limits,
      SpeedLink.Source links,
      Runnable stopDirectly,
      Strand strand,
      Clock clock,
      LogSink log,
      Consumer<Throwable> onFailure,
      AutoCloseable node) {
    this.odometryTopic = odometryTopic;
    this.links = links;
    this.stopDirectly = stopDirectly;
    this.strand = strand;
    holdNews = new HoldNews(strand);
    this.clock = clock;
    this.log = log;
    this.onFailure = onFailure;
    this.node = node;
    state = new BaseState(limits, axleMm);
    meter = new ReactionMeter(limits.reactionMs());
    way = new OdometryWay(limits);
    this.axleMm = axleMm;
    watchdog = Daemons.of(name + " ros2 watchdog", this::watch);
  }

  void start() {
    watchdog.start();
  }

  /** The date in ns since 1970, for stamps. */
  static long unixNs() {
    return RealClock.ofDate().nowNs() + RealClock.DATE_ORIGIN_UNIX_NS;
  }

  /** From a thread of the library. */
  void odometry(Messages.Odometry odometry) {
    String[] lines = new String[2];
    update(() -> {
      lines[0] = state.odometry(odometry, clock.nowNs());
      lines[1] = meter.odometry(odometry.linearMmPerS(), clock.nowNs());
      travel(odometry);
    });
    for (String line : lines) {
      if (line != null) {
        warn(line);
      }
    }
  }

  // With the guard held.
  private void travel(Messages.Odometry odometry) {
    boolean isContinued = way.add(odometry);
    if (odometer != null) {
      if (!isContinued) {
        odometer.lost();
      }
      odometer.lifted(state.isLifted());
      odometer.travelled(
          clock.nowNs(), way.travel(), sent.fastestMmPerS(axleMm), state.bumps().any());
    }
  }

  /** From a thread of the library. */
  void contacts(Contacts contacts) {
    update(() -> state.contacts(contacts));
  }

  /** {@inheritDoc} A command is valid for the watchdog's time: repeat it to keep driving. */
  @Override
  public void drive(WheelCommand command) {
    update(() -> state.gate().drive(command, clock.nowNs()));
  }

  @Override
  public Bumps bumps() {
    return seenBumps;
  }

  @Override
  public void onBump(Runnable newReceiver) {
    receiver = newReceiver;
  }

  @Override
  public void fixed(Fix fix) {
    update(() -> state.gate().fixed(fix.timeNs(), clock.nowNs()));
  }

  @Override
  public void doubted() {
    update(() -> state.gate().doubted(clock.nowNs()));
  }

  @Override
  public void onTravel(TravelReceiver newOdometer) {
    guard.run(() -> odometer = newOdometer);
  }

  @Override
  public void onHolds(Consumer<List<CreateHold>> newReceiver) {
    holdNews.onChange(newReceiver);
  }

  @Override
  public void emergencyStop() {
    update(() -> state.gate().emergencyStop(true));
  }

  @Override
  public void release() {
    update(() -> state.gate().emergencyStop(false));
  }

  /** What holds the wheels now. */
  Set<CreateHold> holds() {
    return guard.get(() -> state.holds(clock.nowNs()));
  }

  @Override
  public void close() {
    emergencyStop();
    SpeedLink last =
        guard.get(() -> {
          isClosed = true;
          guard.signal();
          return link;
        });
    if (last == null) {
      stopDirectly.run();
    } else {
      last.close();
    }
    Daemons.join(watchdog, CLOSE_MS);
    try {
      node.close();
    } catch (Exception e) {
      throw new IllegalStateException("the node of " + odometryTopic + " cannot be closed", e);
    }
    log.log(clock.nowNs(), Level.INFO, TAG, guard.get(meter::summary));
  }

  private void update(Runnable change) {
    boolean mustPost =
        guard.get(() -> {
          if (isClosed) {
            return false;
          }
          change.run();
          send();
          boolean mustInform = state.gate().mustInform() && !isInformPosted;
          isInformPosted |= mustInform;
          return mustInform;
        });
    if (mustPost) {
      strand.post(this::inform);
    }
  }

  // On the strand.
  private void inform() {
    guard.run(() -> {
      seenBumps = state.gate().inform();
      isInformPosted = false;
    });
    receiver.run();
    update(() -> {});
  }

  /** Sends the speeds if they have changed or are due, and there is a link. With the guard held. */
  private void send() {
    long nowNs = clock.nowNs();
    state.received(link != null && link.isReceived());
    WheelCommand speeds = state.speeds(nowNs);
    boolean isDue =
        !speeds.equals(sent) || sentNs == Long.MIN_VALUE || nowNs - sentNs >= HEARTBEAT_NS;
    if (link == null || !isDue) {
      return;
    }
    link.send(speeds);
    meter.sent(speeds.linearMmPerS(), nowNs);
    sent = speeds;
    sentNs = nowNs;
  }

  // The watchdog's thread.
  private void watch() {
    Set<CreateHold> before = EnumSet.noneOf(CreateHold.class);
    try {
      while (!guard.await(() -> isClosed, TICK_NS) && !Thread.currentThread().isInterrupted()) {
        replaceLink();
        update(() -> {});
        Set<CreateHold> last = before;
        guard.get(() -> state.news(last, clock.nowNs(), odometryTopic)).forEach(this::warn);
        before = holds();
        holdNews.now(List.copyOf(before));
      }
    } catch (Throwable bug) {
      emergencyStop();
      onFailure.accept(bug);
    }
  }

  /** Opens a link where there is none; one whose guard is dead or frozen is closed before. */
  private void replaceLink() throws IOException {
    SpeedLink now = guard.get(() -> link);
    if (now != null && now.isAlive()) {
      return;
    }
    if (now != null) {
      guard.run(() -> {
        link = null;
        sent = WheelCommand.STOP;
        sentNs = Long.MIN_VALUE;
      });
      // Without the guard: if the network blocks, the strand goes on.
      stopDirectly.run();
      now.close();
      stopDirectly.run();
      warn("the guard of the wheels has ended: wheels stopped; another one is started");
    }
    SpeedLink opened = links.open();
    boolean isLate =
        guard.get(() -> {
          link = isClosed ? null : opened;
          return isClosed;
        });
    if (isLate) {
      opened.close();
    }
  }

  private void warn(String line) {
    log.log(clock.nowNs(), Level.WARN, TAG, line);
  }
}
