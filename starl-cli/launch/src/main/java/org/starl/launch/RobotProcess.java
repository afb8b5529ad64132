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
import org.starl.platform.LogSink.Level;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.trace.ProcessFact;
import org.starl.robot.trace.ProcessTrace;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimulationPlan;

/**
 * The process of one robot of a {@link Launcher}, with a simulated body: obeys its parent's commands
 * until its input ends.
 */
public final class RobotProcess extends RobotMain {

  private final Path folder;
  private final ProcessTrace trace;
  private volatile RealClock clock = new RealClock();

  // The loop's thread only.
  private SortedMap<RobotId, Integer> ports = new TreeMap<>();
  private @Nullable SimulatedRobot robot;
  private int port;

  private RobotProcess(
      Supplier<SimulationPlan> plans, RobotId self, Path folder, int rounds, OutputStream out) {
    super(self, plans, rounds);
    this.folder = folder;
    trace = new ProcessTrace(self, plans.get().header(), out);
  }

  /**
   * Runs until {@code in} ends. A bug in the robot's program ends the whole process with status 1.
   *
   * @param plans makes equal plans, one for each round, because a director serves one run
   * @param folder for stable storage, this robot's alone
   * @param rounds number of runs of the app, from 1
   * @param in the parent's commands
   * @param out receives the trace
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
    process.trace.report(process.clock, new ProcessFact.Hello(ProcessHandle.current().pid()));
    process.loop();
    if (process.robot != null && !process.robot.reportWaits()) {
      process.trace.report(
          process.clock,
          new ProcessFact.Log(Level.WARN, "end", "the app does not release the strand"));
    }
    process.bringDown(false);
    process.trace.end(process.clock.nowNs());
  }

  private void read(InputStream in) {
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        ParentCommand command = ParentCommand.parse(line);
        post(() -> obey(command));
      }
    } catch (IOException e) {
      trace.report(clock, new ProcessFact.Log(Level.WARN, "commands", e.toString()));
    } finally {
      endLoop(() -> {});
    }
  }

  private void obey(ParentCommand command) throws IOException {
    switch (command) {
      case ParentCommand.Begin begin -> {
        clock = new RealClock(begin.originNs());
        startRound();
        trace.report(clock, new ProcessFact.Port(port));
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
    running().start(ports);
  }

  @Override
  void bringUp(SimulationPlan plan, RobotSpec spec, int number) throws IOException {
    robot = new SimulatedRobot(plan, spec, number, clock, folder, port, trace, this);
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
    trace.report(clock, new ProcessFact.Failed(StackTraces.of(error)));
    // The strand may be blocked by the error, so an orderly close may never end.
    Runtime.getRuntime().halt(1);
  }
}
