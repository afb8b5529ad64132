package org.starl.deployment;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.platform.LogSink.Level;
import org.starl.robot.DeployedRobot;
import org.starl.robot.Wheelbase;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.HostPort;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.StrandUse;
import org.starl.robot.trace.LateTrace;
import org.starl.robot.trace.MachineClock;
import org.starl.robot.trace.Outbox;
import org.starl.robot.trace.Word;
import org.starl.robot.udp.UdpStatistics;
import org.starl.sim.Blueprint;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimObserver;
import org.starl.spec.SpecReport.Violation;

/**
 * One robot of a deployment in this process, in real time, until it is stopped: so many rounds of its
 * app, each another start of the program over the same storage; then it goes on answering the others.
 */
public final class RobotRun implements DeployedRobot.Host, AutoCloseable {

  /**
   * What is run.
   *
   * @param key null for none
   * @param blueprints make equal ones, one for each round: a director serves once
   * @param storage a folder, this robot's alone
   * @param rounds how often the app runs, from 1
   */
  public record Settings(
      Deployment deployment,
      RobotEntry entry,
      @Nullable DeploymentKey key,
      Supplier<Blueprint> blueprints,
      Wheelbase.Source wheels,
      Path storage,
      int rounds) {}

  private static final long CLOSE_LIMIT_S = 15;
  private static final double NS_PER_S = 1e9;
  private static final double NS_PER_MS = 1e6;

  private enum News {
    FINISHED,
    STOP
  }

  private final Settings settings;
  private final RobotId id;
  private final RealClock clock = RealClock.ofDate();
  private final long startNs = clock.nowNs();
  private final Outbox outbox;
  private final Consumer<String> teller;
  private final BlockingQueue<News> news = new LinkedBlockingQueue<>();
  private final CountDownLatch over = new CountDownLatch(1);
  private final AtomicReference<@Nullable Throwable> failure = new AtomicReference<>();

  // From any thread: who sets the first looks at the second, who sets the second at the first.
  private volatile boolean isToStop;
  private volatile @Nullable DeployedRobot robot;

  // The thread of run() only.
  private @Nullable Hands hands;

  /**
   * Opens nothing yet.
   *
   * @param trace takes the robot's trace, each event as it happens
   * @param teller takes lines for people, from any thread
   */
  public RobotRun(Settings settings, OutputStream trace, Consumer<String> teller) {
    this.settings = settings;
    this.id = settings.entry().id();
    this.teller = line -> teller.accept(id + ": " + line);
    outbox = new Outbox(id, settings.blueprints().get().header(), trace);
  }

  /**
   * Runs until {@link #stop}.
   *
   * @return the bug, or the violated specification, that ended it before; or null
   * @throws IOException if it cannot begin: one line for people
   */
  public @Nullable Throwable run() throws IOException {
    MachineClock.tell(outbox, clock, startNs);
    try {
      runRounds();
    } finally {
      bringDown(false);
      outbox.end(clock.nowNs() - startNs);
      over.countDown();
    }
    return failure.get();
  }

  private void runRounds() throws IOException {
    int round = 1;
    bringUp();
    for (News next = await(); next != News.STOP && !isToStop; next = await()) {
      teller.accept("came to the end of round " + round + " of " + settings.rounds());
      if (round < settings.rounds()) {
        round++;
        bringDown(true);
        bringUp();
      }
    }
  }

  /** Ends it from any thread: the wheels stop before this returns, and then {@link #run} does. */
  public void stop() {
    isToStop = true;
    DeployedRobot running = robot;
    if (running != null) {
      running.emergencyStop();
    }
    news.add(News.STOP);
  }

  /** Stops it, and waits until {@link #run}, which has begun, is over. */
  @Override
  public void close() {
    stop();
    try {
      if (!over.await(CLOSE_LIMIT_S, TimeUnit.SECONDS)) {
        teller.accept("did not end in time");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void finished(List<Object> results) {
    news.add(News.FINISHED);
  }

  @Override
  public void failed(Throwable error) {
    ends(error, error.toString());
  }

  private void violated(Violation violation) {
    SpecViolated error = new SpecViolated(violation);
    ends(error, String.valueOf(error.getMessage()));
  }

  private void ends(Throwable error, String line) {
    if (failure.compareAndSet(null, error)) {
      teller.accept("wheels stopped: " + line);
      stop();
    }
  }

  private News await() {
    try {
      return news.take();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return News.STOP;
    }
  }

  private void bringUp() throws IOException {
    if (isToStop) {
      return;
    }
    Blueprint blueprint = settings.blueprints().get();
    RobotSpec spec =
        blueprint.robots().stream()
            .filter(each -> each.id().equals(id))
            .findFirst()
            .orElseThrow(() -> new IllegalArgumentException("there is no robot " + id));
    DeployedRobot.Program program =
        new DeployedRobot.Program(
            spec.app(),
            blueprint.obstacles().known(),
            blueprint.settings().motionParameters(blueprint.robots().indexOf(spec)));
    List<SimObserver> observers = new ArrayList<>(blueprint.observers());
    observers.add(new OwnSpecs(blueprint, startNs, this::violated));
    observers.forEach(observer -> observer.started(blueprint.header()));
    DeployedRobot opened =
        DeployedRobot.open(
            settings.deployment(),
            settings.entry(),
            settings.key(),
            program,
            new DeployedRobot.Surroundings(
                settings.storage(),
                settings.wheels(),
                clock,
                this::log,
                new LateTrace(
                    outbox, startNs, event -> observers.forEach(each -> each.observed(event)))),
            this);
    robot = opened;
    // From here on stop() finds it; before, it has left word.
    if (!isToStop) {
      begin(spec, opened, blueprint);
    }
  }

  private void begin(RobotSpec spec, DeployedRobot opened, Blueprint blueprint) throws IOException {
    HostPort world = settings.deployment().world();
    if (world != null && settings.deployment().simulated().contains(settings.entry())) {
      place(world, spec, opened, blueprint);
    }
    opened.start();
  }

  private void place(HostPort world, RobotSpec spec, DeployedRobot opened, Blueprint blueprint)
      throws IOException {
    Hands connected = Hands.open(world.resolve(), id);
    hands = connected;
    Placing placing = new Placing(spec, opened, connected, opened.strand().pieceClock());
    connected.listen(placing::heard, lost -> teller.accept(String.valueOf(lost.getMessage())));
    placing.begin(blueprint, settings.deployment().participants().asList());
  }

  private void bringDown(boolean isLifted) throws IOException {
    DeployedRobot running = robot;
    robot = null;
    if (running != null) {
      running.close();
      tell(running.strandUse(), running.network());
    }
    Hands held = hands;
    hands = null;
    if (held != null) {
      try (held) {
        if (isLifted) {
          held.say(Hands.Word.LIFT);
        }
      }
    }
  }

  private void tell(StrandUse use, UdpStatistics network) {
    teller.accept(
        String.format(
            Locale.ROOT,
            "strand: %d pieces held it %.1f s, half of them up to %.3f ms, 99 %% up to %.1f ms, the"
                + " longest %.1f ms by %s; %d datagrams sent, %d received,"
                + " dropped %s",
            use.pieces(),
            use.heldNs() / NS_PER_S,
            use.medianNs() / NS_PER_MS,
            use.p99Ns() / NS_PER_MS,
            use.longestPieceNs() / NS_PER_MS,
            use.longestBy(),
            network.sent(),
            network.received(),
            network.dropped()));
  }

  private void log(long timeNs, Level level, String tag, String line) {
    if (level.compareTo(Level.INFO) >= 0) {
      outbox.say(() -> Math.max(0, timeNs - startNs), Word.LOG, level, tag, line);
      teller.accept(tag + ": " + line);
    }
  }
}
