package org.starl.robot.create;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.platform.Chassis;
import org.starl.platform.Clock;
import org.starl.platform.Strand;

/**
 * The wheels and bump sensors of an iRobot Create. What stops the wheels when nobody else does runs
 * here, on threads of its own: the package says what, {@link CreateHold} names each cause.
 *
 * <p>No call waits for the robot. {@link #drive} and {@link #bumps} are the strand's; all others may
 * be called from any thread. Between two pieces of the strand {@link #bumps} does not change, and it
 * shows each touch, however short.
 */
public final class CreateChassis implements Chassis, AutoCloseable {

  /** Is told how the robot fares, on a thread of the chassis: it must not wait. */
  public interface Listener {

    /** Other causes hold the wheels than before. */
    void changed(CreateStatus status);

    /** There is no link, or none any more; it is tried again until there is one. */
    void linkFailed(IOException cause);

    /** A bug: the wheels are stopped as by {@link #emergencyStop}. */
    void failed(Throwable bug);
  }

  /** What may wait for a line that is stuck: a start, and then some speeds. */
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
  private Outbox outbox = new Outbox(OUTBOX_BYTES);
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
    protocol = new CreateProtocol(settings, bytes -> outbox.offer(bytes, bytes.length));
    reader = thread("reader", this::serveLinks);
    watchdog = thread("watchdog", this::watch);
  }

  /**
   * Drives the robot that {@code links} lead to, from now on until {@link #close}. It returns at
   * once; the status tells when there is a robot.
   *
   * @param name of the robot; the threads bear it
   * @param strand the robot's; bumps are told there
   * @param clock the clock by which fixes bear their times
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

  /** {@inheritDoc} It holds for the command timeout: who wants to go on says so again. */
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

  /** There is a fix of this robot's: to be called with each, for without them the wheels stop. */
  public void fixed(Fix fix) {
    locked(() -> protocol.fixed(fix.timeNs(), clock.nowNs()));
  }

  /** Stops the wheels at once, and until {@link #release}, whatever the program wants. */
  public void emergencyStop() {
    locked(() -> protocol.emergencyStop(true));
  }

  /** Takes the emergency stop back: the program's next command counts. */
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
   * @return false where there is no robot now
   */
  public boolean leds(int bits, int powerColour, int powerIntensity) {
    range("light bits", bits, 0, 15);
    range("colour", powerColour, 0, 255);
    range("intensity", powerIntensity, 0, 255);
    return send(Commands.leds(bits, powerColour, powerIntensity));
  }

  /**
   * Keeps a song in the robot.
   *
   * @param number 0 to 15 on a Create 1, to 4 on a Create 2
   * @param notesAndDurations 1 to 16 times a MIDI note (31 to 127, else a rest) and its length in
   *     1/64 s
   * @return false where there is no robot now
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

  /** Plays a song that it was given. False where there is no robot now. */
  public boolean play(int number) {
    range("song", number, 0, settings.model().songs() - 1);
    return send(Commands.play(number));
  }

  /**
   * Stops the wheels, leaves the robot in passive mode, and ends the link; it waits until the robot
   * has said that it is so, or half a second.
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
      byte[] pause = Commands.pauseStream();
      outbox.offer(pause, pause.length);
      outbox.close();
      closing.signalAll();
      lastWriter = writer;
      lastLink = link;
    } finally {
      lock.unlock();
    }
    // The writer ends when it has written what was left.
    join(lastWriter);
    closeQuietly(lastLink);
    join(watchdog);
    join(reader);
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

  /** Does it, and what follows from it for the wheels; then tells the strand. */
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
      closeQuietly(dead[0]);
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
      // Nobody but a stranger interrupts this thread, and means that it shall end.
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
        closeQuietly(opened);
      }
      // Where there was a robot its wheels may turn, and nobody stops them before the next link.
    } while (pause(wasHeard[0] ? 0 : settings.retryMs() * CreateProtocol.NS_PER_MS));
  }

  private void serve(ByteLink opened) throws IOException {
    OutputStream output = opened.output();
    Outbox mine = new Outbox(OUTBOX_BYTES);
    Thread newWriter = thread("writer", () -> write(mine, output, opened));
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

  // The writer's thread: ends with its link.
  private void write(Outbox mine, OutputStream output, ByteLink opened) {
    byte[] buffer = new byte[OUTBOX_BYTES];
    try {
      for (int n = mine.take(buffer); n > 0; n = mine.take(buffer)) {
        output.write(buffer, 0, n);
        output.flush();
      }
    } catch (IOException e) {
      // The reader finds its link closed, and tells.
      closeQuietly(opened);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      closeQuietly(opened);
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
    Thread thread =
        new Thread(
            () -> {
              try {
                body.run();
              } catch (Throwable bug) {
                emergencyStop();
                listener.failed(bug);
              }
            },
            name + " create " + role);
    thread.setDaemon(true);
    return thread;
  }

  // What cannot be closed is as good as closed: nobody uses it any more.
  private static void closeQuietly(@Nullable ByteLink link) {
    if (link != null) {
      try {
        link.close();
      } catch (IOException ignored) {
        return;
      }
    }
  }

  private static void join(@Nullable Thread thread) {
    if (thread == null || thread == Thread.currentThread()) {
      return;
    }
    try {
      TimeUnit.MILLISECONDS.timedJoin(thread, CLOSE_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
