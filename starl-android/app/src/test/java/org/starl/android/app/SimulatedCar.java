package org.starl.android.app;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.CreateBody;
import org.starl.robot.create.CreateHost;
import org.starl.robot.create.CreateModel;
import org.starl.robot.optitrack.Axes;
import org.starl.robot.optitrack.NatNetServerSettings;
import org.starl.robot.optitrack.NatNetVersion;
import org.starl.robot.optitrack.PoseSource;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;

/** A simulated Create on an open floor, and where it is. From any thread. */
final class SimulatedCar implements CreateBody, AutoCloseable {

  /** Cameras that stream to each client of the loopback interface, from any free port. */
  static final NatNetServerSettings CAMERAS =
      new NatNetServerSettings(
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
          null,
          NatNetVersion.V4_1,
          Axes.DEFAULT,
          100);

  private static final CreateModel MODEL = CreateModel.CREATE_1;
  private static final long LIMIT_S = 120;

  private static final double RADIUS_MM = 165;

  private final String name;
  private final RobotId id;
  private final Clock clock;
  private final Consumer<TraceEvent> truth;
  private final CreateHost host;
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition ticked = lock.newCondition();

  // Guarded by the lock.
  private Pose pose;
  private long atNs;
  private double leftMmPerS;
  private double rightMmPerS;

  /**
   * @param truth receives the true motion of the body; from one thread at a time
   */
  SimulatedCar(String name, Pose start, Clock clock, Consumer<TraceEvent> truth) {
    this.name = name;
    this.clock = clock;
    this.truth = truth;
    id = new RobotId(name);
    pose = start;
    atNs = clock.nowNs();
    truth.accept(new Joined(atNs, id, pose, RADIUS_MM));
    host = CreateHost.start(name, MODEL, this, clock, ended -> {});
  }

  /** From now on the robot speaks over these; one link at a time. */
  void serve(InputStream fromDriver, OutputStream toDriver) {
    host.serve(
        new ByteLink() {
          @Override
          public InputStream input() {
            return fromDriver;
          }

          @Override
          public OutputStream output() {
            return toDriver;
          }

          @Override
          public void close() throws IOException {
            fromDriver.close();
            toDriver.close();
          }
        });
  }

  Pose pose() {
    lock.lock();
    try {
      advance(clock.nowNs());
      return pose;
    } finally {
      lock.unlock();
    }
  }

  PoseSource.Body asSeen() {
    return new PoseSource.Body(name, pose(), true, 0.5);
  }

  boolean turnsItsWheels() {
    lock.lock();
    try {
      return leftMmPerS != 0 || rightMmPerS != 0;
    } finally {
      lock.unlock();
    }
  }

  /** Waits until it is so, looking at each tick of the robot, which come 15 ms apart. */
  void until(BooleanSupplier isSo) throws InterruptedException {
    long leftNs = TimeUnit.SECONDS.toNanos(LIMIT_S);
    lock.lock();
    try {
      while (!isSo.getAsBoolean()) {
        leftNs = ticked.awaitNanos(leftNs);
        if (leftNs <= 0) {
          throw new AssertionError("not within " + LIMIT_S + " s; " + name + " is at " + pose());
        }
      }
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void drive(double newLeftMmPerS, double newRightMmPerS, long nowNs) {
    lock.lock();
    try {
      advance(nowNs);
      leftMmPerS = newLeftMmPerS;
      rightMmPerS = newRightMmPerS;
      truth.accept(new Moved(atNs, id, pose, linearMmPerS(), angularRadPerS()));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public Senses senses(long nowNs) {
    lock.lock();
    try {
      advance(nowNs);
      ticked.signalAll();
      return Senses.NOTHING;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    host.close();
  }

  private void advance(long nowNs) {
    if (nowNs > atNs) {
      pose = Kinematics.after(pose, linearMmPerS(), angularRadPerS(), (nowNs - atNs) / 1e9);
      atNs = nowNs;
    }
  }

  private double linearMmPerS() {
    return (leftMmPerS + rightMmPerS) / 2;
  }

  private double angularRadPerS() {
    return (rightMmPerS - leftMmPerS) / MODEL.axleMm();
  }
}
