package org.starl.launch;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.trace.ProcessOutbox;
import org.starl.robot.trace.ProcessWord;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimulationPlan;

/**
 * The process of one robot that a {@link Launcher} started: runs as its parent commands, until its
 * input ends. Its body is simulated here.
 */
public final class RobotProcess extends RobotMain {

  private final Path folder;
  private final ProcessOutbox outbox;
  private volatile RealClock clock = new RealClock();

  // The loop's thread only.
  private SortedMap<RobotId, Integer> ports = new TreeMap<>();
  private @Nullable SimulatedRobot robot;
  private int port;

  private RobotProcess(
      Supplier<SimulationPlan> plans, RobotId self, Path folder, int rounds, OutputStream out) {
    super(self, plans, rounds);
    this.folder = folder;
    outbox = new ProcessOutbox(self, plans.get().header(), out);
  }

  /**
   * Runs until {@code in} ends. A bug in the robot's program ends the whole process with status 1.
   *
   * @param plans makes equal ones, one for each round: a director serves one run
   * @param folder for stable storage, this robot's alone
   * @param rounds how many times the app runs, from 1
   * @param in the parent's commands
   * @param out takes the trace
   * @throws IOException if radio or storage cannot be opened
   */
  public static void run(
      Supplier<SimulationPlan> plans,
      RobotId self,
      Path folder,
      int rounds,
      InputStream in,
      OutputStream out)
      throws IOException {
    RobotProcess process = new RobotProcess(plans, self, folder, rounds, out);
    Daemons.of(self + " commands", () -> process.read(in)).start();
    process.outbox.report(process.clock, ProcessWord.HELLO, ProcessHandle.current().pid());
    process.loop();
    process.bringDown(false);
    process.outbox.end(process.clock.nowNs());
  }

  private void read(InputStream in) {
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        ParentCommand command = ParentCommand.parse(line);
        post(() -> obey(command));
      }
    } catch (IOException e) {
      outbox.report(clock, ProcessWord.LOG, "WARN", "commands", e);
    } finally {
      endLoop(() -> {});
    }
  }

  private void obey(ParentCommand command) throws IOException {
    switch (command) {
      case ParentCommand.Begin begin -> {
        clock = new RealClock(begin.originNs());
        startRound();
        outbox.report(clock, ProcessWord.PORT, port);
      }
      case ParentCommand.Go go -> {
        ports = go.ports();
        start();
      }
      case ParentCommand.Place place -> running().allowPlace();
    }
  }

  private SimulatedRobot running() {
    if (robot == null) {
      throw new IllegalStateException(id + " has not begun");
    }
    return robot;
  }

  private void start() {
    ports.forEach((peer, at) -> {
      if (!peer.equals(id)) {
        running().setPeer(peer, at);
      }
    });
    running().start();
  }

  @Override
  void bringUp(SimulationPlan plan, RobotSpec spec, int number) throws IOException {
    robot = new SimulatedRobot(plan, spec, number, clock, folder, port, outbox, this);
    port = robot.port();
    if (number > 1) {
      start();
    }
  }

  @Override
  void bringDown(boolean isLifted) {
    if (robot != null) {
      if (isLifted) {
        robot.leaveFloor();
      }
      robot.close();
    }
  }

  @Override
  public void failed(Throwable error) {
    outbox.report(clock, ProcessWord.ERROR, StackTraces.of(error));
    // The strand may be stuck in the error itself: nothing can be closed in order.
    Runtime.getRuntime().halt(1);
  }
}
