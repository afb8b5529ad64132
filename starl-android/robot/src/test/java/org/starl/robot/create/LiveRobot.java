package org.starl.robot.create;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.platform.LogSink;
import org.starl.platform.Timer;
import org.starl.robot.contract.RealGround;

/** A driver on its threads, and a simulated robot on its own, over some line; and a program. */
final class LiveRobot implements AutoCloseable {

  /** Joins a driver with a robot. */
  interface Joint {
    /** Puts {@code host} at the far end; the answer leads to it. */
    ByteLink.Source join(CreateHost host);
  }

  private static final long LIMIT_S = 30;
  private static final long PERIOD_NS = 30_000_000;

  final FloorBody body = new FloorBody();
  final RealGround ground = new RealGround("robot");
  final CreateHost host;
  final CreateChassis chassis;
  final List<Bumps> heard = new CopyOnWriteArrayList<>();
  final List<String> troubles = new CopyOnWriteArrayList<>();

  volatile WheelCommand wanted = WheelCommand.STOP;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final Timer program;

  LiveRobot(CreateModel model, Joint line) {
    this(CreateSettings.of(model), line);
  }

  LiveRobot(CreateSettings settings, Joint line) {
    host =
        CreateHost.start(
            "robot",
            settings.model(),
            new Watched(),
            ground.clock(),
            e -> troubles.add("host: " + e));
    chassis =
        CreateChassis.open(
            "robot",
            settings,
            line.join(host),
            ground.strand(),
            ground.clock(),
            this::log,
            bug -> signal());
    chassis.onBump(() -> {
      heard.add(chassis.bumps());
      signal();
    });
    program = ground.timers().timer(this::run);
    ground.strand().post(this::run);
  }

  /** Waits until {@code condition} holds, which is looked at whenever something has changed. */
  void await(String what, BooleanSupplier condition) {
    lock.lock();
    try {
      long leftNs = TimeUnit.SECONDS.toNanos(LIMIT_S);
      while (!condition.getAsBoolean()) {
        if (leftNs <= 0) {
          throw new AssertionError(what + ": " + chassis.status() + ", " + troubles);
        }
        leftNs = changed.awaitNanos(leftNs);
      }
    } catch (InterruptedException e) {
      throw new IllegalStateException("interrupted", e);
    } finally {
      lock.unlock();
    }
  }

  void awaitHolds(CreateHold... holds) {
    await("holds " + List.of(holds), () -> chassis.status().holds().equals(List.of(holds)));
  }

  private void log(long timeNs, LogSink.Level level, String tag, String line) {
    if (level != LogSink.Level.DEBUG) {
      troubles.add(line);
    }
    signal();
  }

  @Override
  public void close() {
    chassis.close();
    host.close();
    ground.close();
  }

  // On the strand.
  private void run() {
    long nowNs = ground.clock().nowNs();
    chassis.drive(wanted);
    chassis.fixed(new Fix(new Pose(0, 0, 0), nowNs, 1, 0.01));
    program.set(nowNs + PERIOD_NS);
    signal();
  }

  private void signal() {
    lock.lock();
    try {
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** The body, with a word to those who wait. */
  private final class Watched implements CreateBody {
    @Override
    public void drive(double leftMmPerS, double rightMmPerS, long atNs) {
      body.drive(leftMmPerS, rightMmPerS, atNs);
      signal();
    }

    @Override
    public Senses senses(long atNs) {
      return body.senses(atNs);
    }
  }
}
