package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.platform.LogSink.Level;
import org.starl.platform.Timer;
import org.starl.robot.CreateWheelbase;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.CreateBody;
import org.starl.robot.create.CreateHost;
import org.starl.robot.create.CreateModel;
import org.starl.robot.create.StreamLink;
import org.starl.robot.create.WheelGuard;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;

/**
 * A driver, its guard and a simulated Create in three places, with each stage between them held. A test
 * prints the time until the wheels stand.
 */
@Tag("realtime")
class StallTest {

  private static final Limits LIMITS = new Limits(300, 300, 500, 0.1, 200);

  @Test
  void theWheelsStandWhenNothingReachesTheGuard() throws Exception {
    try (Rig rig = new Rig()) {
      rig.drive(200);
      rig.toGuard.hold();
      rig.awaitStand("nothing reaches the guard");

      // The program drives on in vain; its last command is to stop.
      for (int speed = 90; speed > 0; speed -= 10) {
        rig.want(speed);
      }
      rig.want(0);
      int before = rig.driven.size();
      rig.toGuard.release();
      rig.drive(150);
      // The write that was held is over in a moment; none is executed that waited behind it.
      assertThat(rig.driven.subList(before, rig.driven.size())).isSubsetOf("200", "0", "150");
    }
  }

  @Test
  void theWheelsStandWhileTheGuardIsFrozen() throws Exception {
    try (Rig rig = new Rig()) {
      rig.drive(200);
      ProcessHandle guard = ProcessHandle.current().children().reduce((a, b) -> b).orElseThrow();
      new ProcessBuilder("kill", "-STOP", Long.toString(guard.pid())).start().waitFor();
      rig.awaitStand("the guard is frozen");
      assertThat(rig.lines).anyMatch(line -> line.startsWith("silent for over 200 ms"));
      rig.drive(100);
      rig.await("told", () -> rig.lines.stream().anyMatch(line -> line.startsWith("heard again")));
    }
  }

  @Test
  void theWheelsStandWhenTheRobotIsNotHeard() throws Exception {
    try (Rig rig = new Rig()) {
      rig.drive(200);
      rig.wire.toClient.hold();
      long ms = rig.awaitStand("the robot is not heard");
      // Else the driver has only replaced the link.
      assertThat(ms).isLessThan(WheelGuard.SILENT_MS);
      rig.wire.toClient.release();
      rig.drive(200);
    }
  }

  @Test
  void behindAHeldLinkTheRobotContinuesAndThenObeysTheNewestCommand() throws Exception {
    try (Rig rig = new Rig()) {
      rig.drive(200);
      rig.wire.toServer.hold();
      rig.want(0);
      assertThat(rig.speed()).as("a cut link stops no wheel").isEqualTo(200);
      int before = rig.driven.size();
      rig.wire.toServer.release();
      rig.awaitStand("the link is released");
      assertThat(rig.driven.subList(before, rig.driven.size())).containsOnly("0");
    }
  }

  /** A driver with its program, its guard in a process, and a simulated Create. */
  private static final class Rig implements AutoCloseable, CreateBody {
    private static final long LIMIT_S = 60;
    private static final long PERIOD_NS = 30_000_000;

    final List<String> lines = new CopyOnWriteArrayList<>();
    final List<String> driven = new CopyOnWriteArrayList<>();
    final HeldWire.Gate toGuard = new HeldWire.Gate();
    final HeldWire wire;
    private final RealClock clock = new RealClock();
    private final RealStrand strand = new RealStrand("bot0", clock, error -> lines.add("" + error));
    private final CreateHost host =
        CreateHost.start("bot0", CreateModel.CREATE_2, this, clock, e -> {});
    private final Wheelbase wheels;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private final Timer program = strand.timer(this::run);
    private volatile double wanted;
    private double speed;
    private int steps;

    Rig() throws IOException {
      ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
      host.listen(server);
      wire = new HeldWire(server.getLocalPort());
      Wheels.Port port = new Wheels.Tcp(new HostPort("127.0.0.1", wire.port()));
      Wheels.Create create = new Wheels.Create("create2", port, 115_200, null);
      ByteLink.Source guarded = GuardProcess.links(port, 115_200, LIMITS);
      wheels =
          CreateWheelbase.of("bot0", create, LIMITS, () -> held(guarded.open()))
              .open(
                  strand,
                  clock,
                  (timeNs, level, tag, line) -> {
                    if (level != Level.DEBUG) {
                      lines.add(line);
                    }
                  },
                  error -> lines.add("" + error));
      strand.post(this::run);
    }

    private ByteLink held(ByteLink link) throws IOException {
      OutputStream out =
          new FilterOutputStream(link.output()) {
            @Override
            public void write(byte[] bytes, int offset, int length) throws IOException {
              toGuard.await();
              out.write(bytes, offset, length);
            }
          };
      return new StreamLink("bot0", link.input(), out, link);
    }

    // On the strand.
    private void run() {
      wheels.drive(new WheelCommand(wanted, 0));
      wheels.fixed(new Fix(new Pose(0, 0, 0), clock.nowNs(), 1, 0.01));
      program.set(clock.nowNs() + PERIOD_NS);
      signal(() -> steps++);
    }

    /** The program commands this speed, several times. */
    void want(double newSpeed) {
      wanted = newSpeed;
      int[] from = new int[1];
      signal(() -> from[0] = steps);
      await("the program's step", () -> steps > from[0] + 2);
    }

    void drive(double newSpeed) {
      wanted = newSpeed;
      await("drives at " + newSpeed, () -> speed == newSpeed);
    }

    double speed() {
      double[] now = new double[1];
      signal(() -> now[0] = speed);
      return now[0];
    }

    /** The time in ms until the wheels stand. */
    long awaitStand(String cause) {
      long fromNs = clock.nowNs();
      await("stands: " + cause, () -> speed == 0);
      long ms = (clock.nowNs() - fromNs) / 1_000_000;
      System.out.printf(Locale.ROOT, "%s: wheels stand after %d ms%n", cause, ms);
      return ms;
    }

    void await(String what, BooleanSupplier condition) {
      lock.lock();
      try {
        long leftNs = TimeUnit.SECONDS.toNanos(LIMIT_S);
        while (!condition.getAsBoolean()) {
          assertThat(leftNs).as(what + ", " + lines + ", " + driven).isPositive();
          leftNs = changed.awaitNanos(leftNs);
        }
      } catch (InterruptedException e) {
        throw new IllegalStateException("interrupted", e);
      } finally {
        lock.unlock();
      }
    }

    private void signal(Runnable change) {
      lock.lock();
      try {
        change.run();
        changed.signalAll();
      } finally {
        lock.unlock();
      }
    }

    @Override
    public void drive(double leftMmPerS, double rightMmPerS, long atNs) {
      signal(() -> {
        if (speed != leftMmPerS) {
          speed = leftMmPerS;
          driven.add(Long.toString(Math.round(leftMmPerS)));
        }
      });
    }

    @Override
    public Senses senses(long atNs) {
      return Senses.NOTHING;
    }

    @Override
    public void close() throws IOException {
      wanted = 0;
      toGuard.release();
      wire.toServer.release();
      wire.toClient.release();
      wheels.close();
      host.close();
      strand.close();
      wire.close();
    }
  }
}
