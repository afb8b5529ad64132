package org.starl.ros2;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.starl.body.WheelCommand;
import org.starl.platform.Clock;
import org.starl.robot.file.RosTopic;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;
import org.starl.time.Time;

/**
 * The process of a {@link SpeedGuard}, the only publisher of a base's speeds. It reads them from its
 * standard input, answers each with a byte that tells whether a node receives them, and stops the wheels
 * when its input ends.
 */
public final class GuardMain {

  private static final long TICK_NS = 10 * Time.NS_PER_MS;

  /** The last stop must leave the machine before the process ends. */
  private static final long DRAIN_NS = 100 * Time.NS_PER_MS;

  private GuardMain() {}

  /** The arguments of {@link #main}. */
  static List<String> args(RosTopic command, long validMs) {
    return List.of(
        command.key(),
        command.name(),
        command.type(),
        Boolean.toString(command.isReliable()),
        Boolean.toString(command.isTransientLocal()),
        Long.toString(validMs));
  }

  /** Runs until its input ends. */
  public static void main(String[] args) throws IOException {
    RosTopic topic =
        new RosTopic(
            args[0],
            args[1],
            args[2],
            Boolean.parseBoolean(args[3]),
            Boolean.parseBoolean(args[4]));
    Clock clock = RealClock::machineNs;
    // The program's own node tells what is wrong with the topic.
    RosNode node = RosNode.open("starl_guard", clock, (timeNs, level, tag, line) -> {});
    RosNode.Output output = node.publish(topic, false);
    RosType type = RosType.of(topic.type());
    SpeedGuard guard =
        new SpeedGuard(
            speeds -> output.publish(Messages.twist(speeds, type, RosBase.unixNs())),
            Long.parseLong(args[5]));
    Runtime.getRuntime()
        .addShutdownHook(
            new Thread(
                () -> {
                  guard.halt();
                  LockSupport.parkNanos(DRAIN_NS);
                },
                "stop"));
    Daemons.of("watch", () -> watch(guard)).start();
    pass(guard, output);
    Runtime.getRuntime().exit(0);
  }

  private static void watch(SpeedGuard guard) {
    while (!Thread.currentThread().isInterrupted()) {
      LockSupport.parkNanos(TICK_NS);
      guard.advance(RealClock.machineNs());
    }
  }

  private static void pass(SpeedGuard guard, RosNode.Output output) {
    try (DataInputStream in =
            new DataInputStream(new BufferedInputStream(new FileInputStream(FileDescriptor.in)));
        OutputStream out = new FileOutputStream(FileDescriptor.out)) {
      while (true) {
        long sentNs = in.readLong();
        WheelCommand speeds = new WheelCommand(in.readDouble(), in.readDouble());
        guard.pass(sentNs, speeds, RealClock.machineNs());
        out.write(output.hasReceiver() ? 1 : 0);
        out.flush();
      }
    } catch (EOFException end) {
      return; // the program has ended
    } catch (IOException e) {
      return; // the program is gone
    }
  }
}
