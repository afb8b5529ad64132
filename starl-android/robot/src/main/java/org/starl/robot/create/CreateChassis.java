package org.starl.robot.create;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.platform.Chassis;
import org.starl.platform.Clock;
import org.starl.platform.Strand;
import org.starl.robot.realtime.Daemons;

/**
 * The wheels and bump sensors of an iRobot Create. The safety stops of the package's contract run
 * here, on their own threads; {@link CreateHold} names each cause.
 *
 * <p>No call waits for the robot. {@link #drive} and {@link #bumps} belong to the strand; all others
 * may be called from any thread. While a piece of the strand runs {@link #bumps} does not change; it
 * shows each touch, however short.
 */
public final class CreateChassis implements Chassis, AutoCloseable {

  /** Receives the robot's state on a thread of the chassis; must not block. */
  public interface Listener {

    /** The reasons that hold the wheels have changed. */
    void changed(CreateStatus status);

    /** A link failed or could not be opened; the chassis tries again. */
    void linkFailed(IOException cause);

    /** A bug: the wheels are stopped as by {@link #emergencyStop}. */
    void failed(Throwable bug);
  }

  /** Capacity for a line that is stuck: a start, and then some speeds. */
  private static final int OUTBOX_BYTES = 256;

  private static final long CLOSE_MS = 1000;
  private static final long END_MS = 500;

  private final String name;
  private final CreateSettings settings;
  private final ByteLink.Source links;
  private final Strand strand;
  private final Clock clock;
  private final Listener listener;
  private final ReentrantLock lock = new ReentrantLock();

  // Guarded by the lock.
  private final Condition closing = lock.newCondition();
  private final Condition ending = lock.newCondition();
  private final CreateProtocol protocol;
  private WriteQueue outbox = new WriteQueue(OUTBOX_BYTES);
  private @Nullable ByteLink link;
  private @Nullable Thread writer;
  private boolean isTellPosted;
  private boolean isClosed;

  private final Thread reader;
  private final Thread watchdog;

  // Strand only.
  private Runnable receiver = () -> {};
  private Bumps seenBumps = Bumps.NONE;

  private CreateChassis(
      String name,
      CreateSettings settings,
      ByteLink.Source links,
      Strand strand,
      Clock clock,
      Listener listener) {
    this.name = name;
    this.settings = settings;
    this.links = links;
    this.strand = strand;
    this.clock = clock;
    this.listener = listener;
    protocol = new CreateProtocol(settings, bytes -> outbox.offer(bytes));
    reader = thread("reader", this::serveLinks);
    watchdog = thread("watchdog", this::watch);
  }

  /**
   * Drives the robot at the end of {@code links} until {@link #close}. Returns at once; the status
   * shows when the robot is there.
   *
   * @param name of the robot, for the threads' names
   * @param strand the robot's; bumps are reported there
   * @param clock the clock of the fixes' times
   */
  public static CreateChassis open(
      String name,
      CreateSettings settings,
      ByteLink.Source links,
      Strand strand,
      Clock clock,
      Listener listener) {
    CreateChassis chassis = new CreateChassis(name, settings, links, strand, clock, listener);
    chassis.reader.start();
    chassis.watchdog.start();
    return chassis;
  }

  /** {@inheritDoc} A command is valid for the command timeout: repeat it to keep driving. */
  @Override
  public void drive(WheelCommand command) {
    locked(() -> protocol.drive(command, clock.nowNs()));
  }

  @Override
  public Bumps bumps() {
    return seenBumps;
  }

  @Override
  public void onBump(Runnable newReceiver) {
    receiver = newReceiver;
  }

  /** Takes each fix of this robot; the wheels stop if they stop coming. */
  public void fixed(Fix fix) {
    locked(() -> protocol.fixed(fix.timeNs(), clock.nowNs()));
  }

  /** Stops the wheels at once, until {@link #release}, whatever the program commands. */
  public void emergencyStop() {
    locked(() -> protocol.emergencyStop(true));
  }

  /** Ends the emergency stop: the program's next command is obeyed. */
  public void release() {
    locked(() -> protocol.emergencyStop(false));
  }

  public CreateStatus status() {
    lock.lock();
    try {
      return protocol.status();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Sets the lights, until the robot changes its mode.
   *
   * @param bits Create 1: 2 play, 8 advance; Create 2: 1 debris, 2 spot, 4 dock, 8 check
   * @param powerColour 0 green to 255 red
   * @param powerIntensity 0 off to 255
   * @return false if there is no robot now
   */
  public boolean leds(int bits, int powerColour, int powerIntensity) {
    range("light bits", bits, 0, 15);
    range("colour", powerColour, 0, 255);
    range("intensity", powerIntensity, 0, 255);
    return send(Commands.leds(bits, powerColour, powerIntensity));
  }

  /**
   * Stores a song in the robot.
   *
   * @param number 0 to 15 on a Create 1, to 4 on a Create 2
   * @param notesAndDurations 1 to 16 times a MIDI note (31 to 127, else a rest) and its length in
   *     1/64 s
   * @return false if there is no robot now
   */
  public boolean song(int number, int... notesAndDurations) {
    range("song", number, 0, settings.model().songs() - 1);
    if (notesAndDurations.length % 2 != 0) {
      throw new IllegalArgumentException("a note without length");
    }
    range("notes", notesAndDurations.length / 2, 1, 16);
    for (int value : notesAndDurations) {
      range("note or length", value, 0, 255);
    }
    return send(Commands.song(number, notesAndDurations));
  }

  /** Plays a stored song. False if there is no robot now. */
  public boolean play(int number) {
    range("song", number, 0, settings.model().songs() - 1);
    return send(Commands.play(number));
  }

  /**
   * Stops the wheels, puts the robot into passive mode and closes the link. Waits until the robot has
   * confirmed that, at most half a second.
   */
  @Override
  public void close() {
    locked(() -> protocol.end(clock.nowNs()));
    awaitEnd();
    Thread lastWriter;
    ByteLink lastLink;
    lock.lock();
    try {
      isClosed = true;
      outbox.offer(Commands.pauseStream());
      outbox.close();
      closing.signalAll();
      lastWriter = writer;
      lastLink = link;
    } finally {
      lock.unlock();
    }
    // The writer ends when it has written the rest.
    if (lastWriter != null) {
      Daemons.join(lastWriter, CLOSE_MS);
    }
    WriteQueue.closeQuietly(lastLink);
    Daemons.join(watchdog, CLOSE_MS);
    Daemons.join(reader, CLOSE_MS);
  }

  @Override
  public String toString() {
    return name;
  }

  private static void range(String what, int value, int least, int most) {
    if (value < least || value > most) {
      throw new IllegalArgumentException(
          what + " " + value + ": expected " + least + " to " + most);
    }
  }

  private boolean send(byte[] command) {
    lock.lock();
    try {
      return !isClosed && protocol.send(command);
    } finally {
      lock.unlock();
    }
  }

  /** Changes the protocol's state, updates the wheels, and informs the strand if need be. */
  private void locked(Runnable change) {
    boolean mustTell;
    lock.lock();
    try {
      if (isClosed) {
        return;
      }
      change.run();
      protocol.advance(clock.nowNs());
      mustTell = protocol.hasNews() && !isTellPosted;
      isTellPosted |= mustTell;
      if (protocol.hasEnded()) {
        ending.signalAll();
      }
    } finally {
      lock.unlock();
    }
    if (mustTell) {
      strand.post(this::tell);
    }
  }

  // On the strand.
  private void tell() {
    lock.lock();
    try {
      seenBumps = protocol.tell();
      isTellPosted = false;
    } finally {
      lock.unlock();
    }
    receiver.run();
    locked(() -> {});
  }

  // The watchdog's thread.
  private void watch() {
    List<CreateHold> told = List.of();
    while (pause(CreateProtocol.TICK_NS)) {
      ByteLink[] dead = new ByteLink[1];
      CreateStatus[] status = new CreateStatus[1];
      locked(() -> {
        protocol.advance(clock.nowNs());
        dead[0] = protocol.isLinkDead(clock.nowNs()) ? link : null;
        status[0] = protocol.status();
      });
      WriteQueue.closeQuietly(dead[0]);
      if (status[0] != null && !status[0].holds().equals(told)) {
        told = status[0].holds();
        listener.changed(status[0]);
      }
    }
  }

  private void awaitEnd() {
    lock.lock();
    try {
      long leftNs = END_MS * CreateProtocol.NS_PER_MS;
      while (!isClosed && !protocol.hasEnded() && leftNs > 0) {
        leftNs = ending.awaitNanos(leftNs);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      lock.unlock();
    }
  }

  /** Waits; false when the chassis is closed. */
  private boolean pause(long ns) {
    lock.lock();
    try {
      long leftNs = ns;
      while (!isClosed && leftNs > 0) {
        leftNs = closing.awaitNanos(leftNs);
      }
      return !isClosed;
    } catch (InterruptedException e) {
      // StarL never interrupts this thread: another interrupt is a request to end it.
      Thread.currentThread().interrupt();
      return false;
    } finally {
      lock.unlock();
    }
  }

  // The reader's thread.
  private void serveLinks() {
    boolean[] wasHeard = new boolean[1];
    do {
      wasHeard[0] = false;
      ByteLink opened = null;
      try {
        opened = links.open();
        serve(opened);
      } catch (IOException e) {
        if (!hasEnded()) {
          listener.linkFailed(e);
        }
      } finally {
        locked(() -> {
          link = null;
          wasHeard[0] = protocol.linkLost(clock.nowNs());
        });
        WriteQueue.closeQuietly(opened);
      }
      // After a link that worked the wheels may still turn: only the next link can stop them.
    } while (pause(wasHeard[0] ? 0 : settings.retryMs() * CreateProtocol.NS_PER_MS));
  }

  private void serve(ByteLink opened) throws IOException {
    OutputStream output = opened.output();
    WriteQueue mine = new WriteQueue(OUTBOX_BYTES);
    Thread newWriter = thread("writer", () -> mine.writeTo(output, opened));
    locked(() -> {
      outbox = mine;
      link = opened;
      writer = newWriter;
      newWriter.start();
      protocol.linkOpened(clock.nowNs());
    });
    try {
      if (hasEnded()) {
        return;
      }
      byte[] buffer = new byte[256];
      for (int n = opened.input().read(buffer); n >= 0; n = opened.input().read(buffer)) {
        int length = n;
        locked(() -> protocol.received(buffer, length, clock.nowNs()));
      }
      throw new IOException(opened + " was closed");
    } finally {
      mine.close();
    }
  }

  private boolean hasEnded() {
    lock.lock();
    try {
      return isClosed;
    } finally {
      lock.unlock();
    }
  }

  private Thread thread(String role, Runnable body) {
    return Daemons.of(
        name + " create " + role,
        () -> {
          try {
            body.run();
          } catch (Throwable bug) {
            emergencyStop();
            listener.failed(bug);
          }
        });
  }
}
