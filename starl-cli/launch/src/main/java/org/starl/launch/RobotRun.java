package org.starl.launch;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.RobotRunner;
import org.starl.platform.LogSink.Level;
import org.starl.robot.DeployedRobot;
import org.starl.robot.DisownedException;
import org.starl.robot.LocalSpecs;
import org.starl.robot.Ros2;
import org.starl.robot.create.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.Wheels;
import org.starl.robot.optitrack.FeedStatistics;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.StrandUse;
import org.starl.robot.trace.LateTrace;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.ProcessFact;
import org.starl.robot.trace.ProcessTrace;
import org.starl.robot.udp.PeerKeys;
import org.starl.robot.udp.UdpStatistics;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimObserver;
import org.starl.sim.SimulationPlan;
import org.starl.sim.UnfinishedRobot;
import org.starl.spec.SpecReport.Violation;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/** One robot of a deployment in this process, in real time, until it is stopped. */
public final class RobotRun extends RobotMain implements AutoCloseable {

  /**
   * The robot and its run.
   *
   * @param keys null: datagrams are not sealed
   * @param plans makes equal plans, one for each round, because a director serves one run
   * @param storage a folder for this robot only
   * @param rounds number of runs of the app, from 1
   */
  public record Settings(
      Deployment deployment,
      RobotEntry entry,
      @Nullable PeerKeys keys,
      Supplier<SimulationPlan> plans,
      Wheelbase.Source wheels,
      Path storage,
      int rounds) {}

  private static final long CLOSE_LIMIT_S = 15;

  private final Settings settings;
  private final RealClock clock = RealClock.ofDate();
  private final long startNs = clock.nowNs();
  private final ProcessTrace sink;
  private final Consumer<String> console;
  private final CountDownLatch over = new CountDownLatch(1);
  private final AtomicReference<@Nullable Throwable> failure = new AtomicReference<>();

  // stop() sets isStopped, then reads this; bringUp() sets this, then reads isStopped: so at least
  // one of the two sees the change of the other.
  private volatile @Nullable DeployedRobot robot;

  // The loop's thread only.
  private @Nullable WorldClient world;
  private Ros2.@Nullable Display display;

  /**
   * Opens nothing yet.
   *
   * @param trace receives the robot's trace, event by event
   * @param console receives log lines, from any thread
   */
  public RobotRun(Settings settings, OutputStream trace, Consumer<String> console) {
    super(settings.entry().id(), settings.plans(), settings.rounds());
    this.settings = settings;
    this.console = line -> console.accept(id + ": " + line);
    sink = new ProcessTrace(id, settings.plans().get().header(), trace, this::failed);
  }

  /**
   * Runs until {@link #stop}.
   *
   * @return the bug or the violation that ended the run; null for none
   * @throws IOException if it cannot begin; its message is one line for people
   */
  public @Nullable Throwable run() throws IOException {
    MachineClock.tell(sink, clock, startNs);
    try {
      startRound();
      loop();
    } finally {
      try {
        bringDown(false);
        sink.end(clock.nowNs() - startNs);
      } catch (IOException e) {
        failed(e);
      }
      over.countDown();
    }
    return failure.get();
  }

  /** Ends it from any thread: the wheels stop before this returns, and then {@link #run} does. */
  public void stop() {
    endLoop(() -> {
      DeployedRobot running = robot;
      if (running != null) {
        running.emergencyStop();
      }
    });
  }

  /** Stops it, and waits until {@link #run}, which has begun, is over. */
  @Override
  public void close() {
    stop();
    try {
      if (!over.await(CLOSE_LIMIT_S, TimeUnit.SECONDS)) {
        console.accept("did not end in time");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void finished(List<Object> results) {
    post(() -> console.accept("came to the end of round " + progress()));
    super.finished(results);
  }

  @Override
  public void failed(Throwable error) {
    boolean isForPeople = error instanceof IOException || error instanceof DisownedException;
    end(error, isForPeople ? String.valueOf(error.getMessage()) : error.toString());
  }

  private void violated(Violation violation) {
    String line = "VIOLATED: " + violation;
    end(new IllegalStateException(line), line);
  }

  private void end(Throwable error, String line) {
    if (failure.compareAndSet(null, error)) {
      console.accept("wheels stopped: " + line);
      stop();
    }
  }

  @Override
  void bringUp(SimulationPlan plan, RobotSpec spec, int number) throws IOException {
    DeployedRobot.Program program =
        new DeployedRobot.Program(
            spec.app(),
            plan.obstacles().known(),
            plan.waypoints(),
            plan.settings().motionParameters(plan.robots().indexOf(spec), plan.robots().size()));
    RobotEntry entry = settings.entry();
    if (entry.wheels() instanceof Wheels.Ros2 base) {
      Deployment deployment = settings.deployment();
      display = Ros2.of(deployment).display(entry, base, deployment.positions());
    }
    Consumer<TraceEvent> shown = display == null ? event -> {} : display;
    List<SimObserver> observers = plan.observers();
    observers.forEach(observer -> observer.started(plan.header()));
    LocalSpecs specs = new LocalSpecs(plan.monitors(), startNs, this::violated);
    LateTrace trace =
        new LateTrace(
            sink,
            startNs,
            event -> {
              observers.forEach(observer -> observer.observed(event));
              shown.accept(event);
              specs.observed(event);
            });
    DeployedRobot opened =
        DeployedRobot.open(
            settings.deployment(),
            settings.entry(),
            settings.keys(),
            program,
            new DeployedRobot.Surroundings(
                settings.storage(),
                settings.wheels(),
                DeploymentFile.linesKey(settings.deployment()),
                clock,
                this::log,
                trace,
                null),
            this);
    robot = opened;
    if (isStopped()) {
      return;
    }
    HostPort worldAt = settings.deployment().world();
    if (worldAt != null && settings.deployment().simulated().contains(settings.entry())) {
      world =
          WorldClient.open(
              worldAt.resolve(),
              spec,
              opened.strand(),
              opened.runner(),
              lost -> console.accept(String.valueOf(lost.getMessage())));
      new OneRobotControl(
              plan, spec, world, opened.strand(), opened.strand().pieceClock(), opened.runner())
          .begin();
    }
    opened.start();
  }

  @Override
  void bringDown(boolean isLifted) throws IOException {
    DeployedRobot running = robot;
    robot = null;
    if (running != null) {
      explain(running);
      running.close();
      report(running.strandUse(), running.network(), running.positions());
    }
    if (display != null) {
      display.close();
      display = null;
    }
    if (world != null) {
      if (isLifted) {
        world.send(WorldClient.Word.LIFT);
      }
      world.close();
      world = null;
    }
  }

  /** Prints what an app that has not ended waits for, as of an unfinished simulated run. */
  private void explain(DeployedRobot running) {
    List<String> lines = new ArrayList<>();
    runOn(
        running.strand(),
        () -> {
          RobotRunner runner = running.runner();
          if (runner.app() != null && !runner.isFinished()) {
            StackTraceElement[] stack = running.strand().appStack();
            lines.addAll(UnfinishedRobot.of(id, runner, stack, false, -1, -1, List.of()).lines());
          }
        });
    for (int i = 0; i < lines.size(); i++) {
      console.accept((i == 0 ? "not finished: " : "") + lines.get(i));
    }
  }

  private void report(StrandUse use, UdpStatistics network, FeedStatistics positions) {
    console.accept(
        "positions: %d messages received, %d fixes, dropped %s"
            .formatted(positions.received(), positions.fixes(), positions.dropped()));
    console.accept(
        String.format(
            Locale.ROOT,
            "strand: %d pieces held it %s, half of them up to %.3f ms, 99 %% up to %.1f ms, the"
                + " longest %.1f ms by %s; %d datagrams sent, %d received,"
                + " dropped %s",
            use.pieces(),
            Time.text(use.heldNs(), 1),
            Time.ms(use.medianNs()),
            Time.ms(use.p99Ns()),
            Time.ms(use.longestPieceNs()),
            use.longestBy(),
            network.sent(),
            network.received(),
            network.dropped()));
  }

  private void log(long timeNs, Level level, String tag, String line) {
    if (level.compareTo(Level.INFO) >= 0) {
      sink.report(() -> Math.max(0, timeNs - startNs), new ProcessFact.Log(level, tag, line));
      console.accept(tag + ": " + line);
    }
  }
}
