package org.starl.processes;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.RobotRunner;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.platform.LogSink.Level;
import org.starl.platform.Platform;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.robot.realtime.RealBackground;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.realtime.RealStrand;
import org.starl.robot.trace.Outbox;
import org.starl.robot.trace.Word;
import org.starl.robot.udp.FileStable;
import org.starl.robot.udp.LossyRadio;
import org.starl.robot.udp.UdpRadio;
import org.starl.sim.Blueprint;
import org.starl.sim.RobotSpec;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import org.starl.sim.world.Body;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.SimPositioning;
import org.starl.sim.world.World;

/**
 * One run of a robot's app in its process, from start to end: the program on strand, radio and storage
 * of the real platform, its wheels and fixes on a simulated body.
 */
final class Incarnation implements SoloControl.Robot, BodyClock.Wheels, AutoCloseable {

  private static final long ALIVE_EVERY_NS = 50_000_000;

  /** What is told of it, on its strand. */
  interface Host {
    void finished();

    /** From any thread: it cannot go on. */
    void failed(Throwable error);
  }

  private final Blueprint blueprint;
  private final RobotSpec spec;
  private final Outbox outbox;
  private final Host host;
  private final RealStrand strand;
  private final BodyClock clock;
  private final UdpRadio udp;
  private final LossyRadio radio;
  private final FileStable stable;
  private final RealBackground background;
  private final World world;
  private final SimChassis chassis;
  private final SimPositioning positioning;
  private final RobotRunner runner;
  private final Timer alive;

  // Strand only.
  private @Nullable Body body;
  private boolean asked;
  private boolean mayStand;
  private boolean finished;

  /**
   * Opens everything; {@link #start} runs it.
   *
   * @param number of the start, from 1: each draws otherwise
   * @param port to listen at on the loopback interface, 0 for any free one
   */
  Incarnation(
      Blueprint blueprint,
      RobotSpec spec,
      int number,
      RealClock real,
      Path folder,
      int port,
      Outbox outbox,
      Host host)
      throws IOException {
    this.blueprint = blueprint;
    this.spec = spec;
    this.outbox = outbox;
    this.host = host;
    SimSettings settings = blueprint.settings();
    RobotId id = spec.id();
    Participants deployment = Participants.of(blueprint.header().robots());
    Rng robotRng = new Rng(blueprint.header().behaviourSeed()).fork(id.name());
    Rng rng = number == 1 ? robotRng : robotRng.fork("incarnation" + number);
    strand = new RealStrand(id.name(), real, host::failed);
    clock = new BodyClock(strand.pieceClock(), this);
    udp =
        UdpRadio.open(
            id,
            strand,
            new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
            host::failed);
    radio =
        new LossyRadio(
            udp, id, deployment, clock, strand, rng.fork("radio"), draw -> delayNs(settings, draw));
    stable = FileStable.open(folder, strand, host::failed);
    background = new RealBackground(id.name(), strand);
    world =
        new World(
            clock::shownNs,
            clock.reading(strand),
            outbox,
            settings.worldLimits(),
            blueprint.obstacles());
    chassis = new SimChassis(strand, rng.fork("chassis"), settings.speedError());
    long periodNs = settings.positionPeriodNs();
    positioning =
        new SimPositioning(
            clock,
            clock::shownNs,
            strand,
            rng.fork("positioning"),
            settings.positionNoise(),
            periodNs,
            settings.get(Setting.POSITION_IN_PHASE)
                ? 0
                : SimPositioning.drawnPhaseNs(robotRng.fork("positioning"), periodNs));
    Platform platform =
        new Platform(
            id,
            deployment,
            clock,
            strand,
            strand,
            radio,
            positioning,
            chassis,
            stable,
            rng::fork,
            background,
            this::log,
            outbox,
            blueprint.obstacles().known(),
            settings.motionParameters(blueprint.robots().indexOf(spec)),
            blueprint.key());
    runner = new RobotRunner(platform, spec.app(), this::appEnded);
    alive = strand.timer(this::tellAlive);
  }

  private static long delayNs(SimSettings settings, Rng rng) {
    double loss = settings.messageLoss().probability();
    return loss > 0 && rng.nextBoolean(loss)
        ? LossyRadio.LOST
        : settings.messageDelay().drawNs(rng);
  }

  /** Where its radio listens. */
  int port() {
    return udp.address().getPort();
  }

  void setPeer(RobotId robot, int port) {
    udp.setPeer(robot, new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
  }

  void start() {
    strand.post(() -> {
      tellAlive();
      if (spec.onFloor()) {
        appearSoon();
      }
      if (blueprint.director() != null) {
        Rng scenarioRng = new Rng(blueprint.header().scenarioSeed());
        blueprint
            .director()
            .direct(new SoloControl(this, blueprint.header().robots(), scenarioRng));
      }
    });
    runner.start();
  }

  /** There is room for its body. */
  void place() {
    strand.post(() -> mayStand = true);
  }

  /** Takes its body off the floor, and ends it. */
  void leave() {
    CountDownLatch gone = new CountDownLatch(1);
    strand.post(() -> {
      takeOffFloor();
      strand.close();
      gone.countDown();
    });
    try {
      gone.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    close();
  }

  /** Ends it where it is: it says nothing more. */
  @Override
  public void close() {
    udp.close();
    strand.close();
    background.close();
    stable.close();
  }

  private void appearSoon() {
    if (!putOnFloor()) {
      at(clock.nowNs() + ALIVE_EVERY_NS, this::appearSoon);
    }
  }

  private void tellAlive() {
    outbox.say(clock, Word.ALIVE, radio.copies(), radio.lost(), clock.longestSilenceNs());
    alive.set(clock.nowNs() + ALIVE_EVERY_NS);
  }

  private void appEnded() {
    finished = true;
    List<Object> results = runner.results();
    outbox.say(clock, Word.FINISHED, results == null ? new Object[0] : results.toArray());
    host.finished();
  }

  private void log(long timeNs, Level level, String tag, String line) {
    if (level.compareTo(Level.INFO) >= 0) {
      outbox.say(clock, Word.LOG, level, tag, line);
    }
  }

  @Override
  public RobotId id() {
    return spec.id();
  }

  @Override
  public long nowNs() {
    return clock.nowNs();
  }

  @Override
  public void at(long atNs, Runnable action) {
    strand.timer(action).set(atNs);
  }

  @Override
  public boolean putOnFloor() {
    if (!asked) {
      asked = true;
      outbox.say(clock, Word.WANTS_PLACE);
    }
    clock.nowNs();
    double radiusMm = blueprint.settings().robotRadiusMm();
    if (!mayStand || !isFree(spec.start())) {
      return false;
    }
    body = world.add(spec.id(), spec.start(), radiusMm);
    chassis.mount(body);
    positioning.mount(body);
    return true;
  }

  @Override
  public boolean isFree(Pose place) {
    clock.nowNs();
    return !blueprint.settings().worldLimits().collisions()
        || world.isFree(place, blueprint.settings().robotRadiusMm());
  }

  @Override
  public void takeOffFloor() {
    if (body != null) {
      clock.nowNs();
      chassis.unmount();
      positioning.unmount();
      world.remove(body);
      body = null;
    }
  }

  @Override
  public boolean isOnFloor() {
    return body != null;
  }

  @Override
  public Pose truePose() {
    if (body == null) {
      throw new IllegalStateException(spec.id() + " is not on the floor");
    }
    clock.nowNs();
    return body.pose();
  }

  @Override
  public MotionFlag motionflag() {
    GlobalVarHolder gvh = runner.gvh();
    return gvh == null ? MotionFlag.IDLE : gvh.plat.moat.motionflag().get();
  }

  @Override
  public boolean isFinished() {
    return finished;
  }

  @Override
  public void hold() {
    chassis.impair(0, 0);
  }

  @Override
  public void letGo() {
    chassis.impair(1, 1);
  }
}
