package org.starl.robot.create;

import static org.starl.time.Time.NS_PER_MS;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.LogSink.Level;
import org.starl.platform.Strand;
import org.starl.robot.realtime.Daemons;

/**
 * The wheels, the bump and proximity sensors and the power button's light of an iRobot Create. The
 * safety stops of the package's contract run here, on their own threads; {@link CreateHold} names
 * each cause.
 *
 * <p>No call waits for the robot. While a piece of the strand runs, {@link #bumps} does not change; it
 * reports each contact, however short. The log has a line for each change of the causes, and for each
 * new reason why a link fails; the chassis then opens another link.
 */
public final class CreateChassis implements Wheelbase {

  private static final String TAG = "create";

  /** Bytes that may wait while the line is stuck: a start, and then some speeds. */
  private static final int QUEUE_BYTES = 256;

  private static final long CLOSE_MS = 1000;
  private static final long END_MS = 500;

  private final String name;
  private final CreateSettings settings;
  private final ByteLink.Source links;
  private final Strand strand;
  private final Clock clock;
  private final LogSink log;
  private final Consumer<Throwable> onFailure;
  private final Guard guard = new Guard();
  private final HoldNews holdNews;

  // Guarded.
  private final CreateProtocol protocol;
  private WriteQueue toRobot = new WriteQueue(QUEUE_BYTES);
  private @Nullable ByteLink link;
  private @Nullable Thread writer;
  private boolean isInformPosted;
  private boolean isClosed;

  private final Thread reader;
  private final Thread watchdog;

  // The reader only.
  private String lastLinkFailure = "";

  // The watchdog only.
  private final BatteryWatch battery = new BatteryWatch();
  private long longestSilentNs;

  // Strand only.
  private Runnable receiver = () -> {};
  private Bumps seenBumps = Bumps.NONE;

  private CreateChassis(
      String name,
      CreateSettings settings,
      ByteLink.Source links,
      Strand strand,
      Clock clock,
      LogSink log,
      Consumer<Throwable> onFailure) {
    this.name = name;
    this.settings = settings;
    this.links = links;
    this.strand = strand;
    holdNews = new HoldNews(strand);
    this.clock = clock;
    this.log = log;
    this.onFailure = onFailure;
    protocol = new CreateProtocol(settings, this::send);
    reader = thread("reader", this::serveLinks);
    watchdog = thread("watchdog", this::watch);
  }

  /**
   * Drives the robot at the end of {@code links} until {@link #close}. Returns at once; the status
   * shows when the robot has answered.
   *
   * @param name of the robot, for the threads' names
   * @param strand the robot's; bumps are reported there
   * @param clock the clock of the fixes' times
   * @param log takes lines on threads of the chassis; must not block
   * @param onFailure takes a bug; the wheels are stopped as by {@link #emergencyStop}
   */
  public static CreateChassis open(
      String name,
      CreateSettings settings,
      ByteLink.Source links,
      Strand strand,
      Clock clock,
      LogSink log,
      Consumer<Throwable> onFailure) {
    CreateChassis chassis = new CreateChassis(name, settings, links, strand, clock, log, onFailure);
    chassis.reader.start();
    chassis.watchdog.start();
    return chassis;
  }

  /** {@inheritDoc} A command is valid for the command timeout: repeat it to keep driving. */
  @Override
  public void drive(WheelCommand command) {
    update(() -> protocol.drive(command, clock.nowNs()));
  }

  @Override
  public Bumps bumps() {
    return seenBumps;
  }

  @Override
  public void onBump(Runnable newReceiver) {
    receiver = newReceiver;
  }

  /** {@inheritDoc} The light is that of the power button. */
  @Override
  public void show(int rgb) {
    update(() -> protocol.light(rgb));
  }

  @Override
  public List<Double> nearRad() {
    return status().sensors().nearRad();
  }

  @Override
  public void fixed(Fix fix) {
    update(() -> protocol.fixed(fix.timeNs(), clock.nowNs()));
  }

  @Override
  public void doubted() {
    update(() -> protocol.doubted(clock.nowNs()));
  }

  @Override
  public void onTravel(TravelReceiver travelReceiver) {
    guard.run(() -> protocol.onTravel(travelReceiver));
  }

  @Override
  public void onHolds(Consumer<List<CreateHold>> newReceiver) {
    holdNews.onChange(newReceiver);
  }

  @Override
  public void emergencyStop() {
    update(() -> protocol.emergencyStop(true));
  }

  @Override
  public void release() {
    update(() -> protocol.emergencyStop(false));
  }

  public CreateStatus status() {
    return guard.get(protocol::status);
  }

  /**
   * Stops the wheels, puts the robot into passive mode and closes the link. Waits until the robot has
   * confirmed that, at most half a second.
   */
  @Override
  public void close() {
    update(() -> protocol.end(clock.nowNs()));
    guard.await(() -> isClosed || protocol.hasEnded(), END_MS * NS_PER_MS);
    guard.run(() -> {
      isClosed = true;
      toRobot.offer(Commands.pauseStream());
      toRobot.close();
      guard.signal();
    });
    // The writer ends when it has written the rest.
    Thread lastWriter = guard.get(() -> writer);
    if (lastWriter != null) {
      Daemons.join(lastWriter, CLOSE_MS);
    }
    WriteQueue.closeQuietly(guard.get(() -> link));
    Daemons.join(watchdog, CLOSE_MS);
    Daemons.join(reader, CLOSE_MS);
    log.log(clock.nowNs(), Level.INFO, TAG, guard.get(protocol::reaction));
  }

  @Override
  public String toString() {
    return name;
  }

  /** Changes the protocol's state, updates the wheels, and informs the strand if necessary. */
  private void update(Runnable change) {
    boolean mustPost =
        guard.get(() -> {
          if (isClosed) {
            return false;
          }
          change.run();
          protocol.advance(clock.nowNs());
          if (protocol.hasEnded()) {
            guard.signal();
          }
          boolean mustInform = protocol.mustInform() && !isInformPosted;
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
      seenBumps = protocol.inform();
      isInformPosted = false;
    });
    receiver.run();
    update(() -> {});
  }

  // The watchdog's thread.
  private void watch() {
    List<CreateHold> logged = List.of();
    while (pause(CreateProtocol.TICK_NS)) {
      ByteLink[] dead = new ByteLink[1];
      long[] silentNs = new long[1];
      update(() -> {
        protocol.advance(clock.nowNs());
        silentNs[0] = protocol.silentNs(clock.nowNs());
        dead[0] = protocol.isLinkDead(clock.nowNs()) ? link : null;
      });
      logSilence(silentNs[0]);
      WriteQueue.closeQuietly(dead[0]);
      CreateStatus now = status();
      holdNews.now(now.holds());
      if (!now.holds().equals(logged)) {
        logHolds(logged, now.holds());
        logged = now.holds();
      }
      String ofBattery = battery.update(now.sensors());
      if (ofBattery != null) {
        warn(ofBattery);
      }
    }
  }

  private void logHolds(List<CreateHold> before, List<CreateHold> holds) {
    boolean isLate =
        holds.contains(CreateHold.STALE_COMMAND) && !before.contains(CreateHold.STALE_COMMAND);
    if (isLate) {
      warn("no command for " + settings.commandTimeoutMs() + " ms: wheels stopped");
    }
    log.log(clock.nowNs(), Level.DEBUG, TAG, "held by " + holds);
  }

  /** Logs the beginning and the end of each silence, because no command is certain to act in it. */
  private void logSilence(long silentNs) {
    if (silentNs > settings.tellAfterMs() * NS_PER_MS) {
      if (longestSilentNs == 0) {
        warn(
            "silent for over "
                + settings.tellAfterMs()
                + " ms: the robot may continue its last command");
      }
      longestSilentNs = silentNs;
    } else if (longestSilentNs > 0) {
      warn("heard again after " + longestSilentNs / NS_PER_MS + " ms of silence");
      longestSilentNs = 0;
    }
  }

  /** Waits; false when the chassis is closed, or the thread is to end. */
  private boolean pause(long ns) {
    // StarL never interrupts this thread: another interrupt is a request to end it.
    return !guard.await(() -> isClosed, ns) && !Thread.currentThread().isInterrupted();
  }

  // The reader's thread.
  private void serveLinks() {
    boolean[] hadFrames = new boolean[1];
    do {
      hadFrames[0] = false;
      ByteLink opened = null;
      try {
        opened = links.open();
        serve(opened);
      } catch (IOException e) {
        logLinkFailure(String.valueOf(e.getMessage()));
      } finally {
        update(() -> {
          link = null;
          hadFrames[0] = protocol.linkLost(clock.nowNs());
        });
        WriteQueue.closeQuietly(opened);
      }
      // After a link that worked the wheels may still turn: only the next link can stop them.
    } while (pause(hadFrames[0] ? 0 : settings.retryMs() * NS_PER_MS));
  }

  // Links are opened again and again: a repeated cause is logged once.
  private void logLinkFailure(String cause) {
    if (!hasClosed() && !cause.equals(lastLinkFailure)) {
      lastLinkFailure = cause;
      warn("no link to the robot: " + cause);
    }
  }

  private void serve(ByteLink opened) throws IOException {
    OutputStream output = opened.output();
    WriteQueue queue = new WriteQueue(QUEUE_BYTES);
    Thread newWriter = thread("writer", () -> queue.writeTo(output, opened));
    update(() -> {
      toRobot = queue;
      link = opened;
      writer = newWriter;
      newWriter.start();
      protocol.linkOpened(clock.nowNs());
    });
    try {
      if (hasClosed()) {
        return;
      }
      byte[] buffer = new byte[256];
      for (int n = opened.input().read(buffer); n >= 0; n = opened.input().read(buffer)) {
        int length = n;
        update(() -> protocol.received(buffer, length, clock.nowNs()));
      }
      throw new IOException(opened + " was closed");
    } finally {
      queue.close();
    }
  }

  // With the guard held.
  private boolean send(byte[] command) {
    return Commands.areWheelSpeeds(command) ? toRobot.offerNewest(command) : toRobot.offer(command);
  }

  private void warn(String line) {
    log.log(clock.nowNs(), Level.WARN, TAG, line);
  }

  private boolean hasClosed() {
    return guard.get(() -> isClosed);
  }

  private Thread thread(String role, Runnable body) {
    return Daemons.of(
        name + " create " + role,
        () -> {
          try {
            body.run();
          } catch (Throwable bug) {
            emergencyStop();
            onFailure.accept(bug);
            log.log(
                clock.nowNs(), Level.ERROR, TAG, "the driver has failed, wheels stopped: " + bug);
          }
        });
  }
}
