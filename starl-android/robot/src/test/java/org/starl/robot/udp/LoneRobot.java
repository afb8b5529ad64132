package org.starl.robot.udp;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Comms;
import org.starl.comms.DropReason;
import org.starl.comms.Endpoint;
import org.starl.geometry.Obstacles;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Chassis;
import org.starl.platform.DeploymentKey;
import org.starl.platform.Light;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Platform;
import org.starl.platform.Radio;
import org.starl.platform.StableStorage;
import org.starl.platform.Strand;
import org.starl.platform.SuspendedApp;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.session.KnownStarts;
import org.starl.session.Sessions;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/**
 * A robot whose messages are real and all else is not: its strand runs what is posted at once, and what
 * it sends is kept. It listens to the channel {@code talk/1}, whose messages are strings.
 */
final class LoneRobot {

  static final Channel<String> TALK = new Channel<>("talk", "1", new StringCodec());

  /** What its handler was given. */
  final List<String> heard = new ArrayList<>();

  /** What its radio sent. */
  final List<byte[]> sent = new ArrayList<>();

  final Comms comms;
  final Endpoint<String> talk;
  final PromptStrand strand = new PromptStrand();
  private Radio.@Nullable Receiver receiver;

  private static final class StringCodec implements Codec<String> {
    @Override
    public void write(String message, WireWriter out) {
      out.string(message);
    }

    @Override
    public String read(WireReader in) {
      return in.string();
    }
  }

  /** One with a radio of its own, which {@link #arrive} makes hear. */
  LoneRobot(RobotId self, Participants deployment, @Nullable DeploymentKey key) {
    this(self, deployment, sessions(self, deployment, key));
  }

  private static @Nullable Sessions sessions(
      RobotId self, Participants deployment, @Nullable DeploymentKey key) {
    return key == null
        ? null
        : new KnownStarts(
            peer -> key.pairKey(self, peer), self, 1, peer -> 1, () -> deployment, null);
  }

  /** The same with these sessions. */
  LoneRobot(RobotId self, Participants deployment, @Nullable Sessions sessions) {
    Radio radio =
        new Radio() {
          @Override
          public void send(RobotId to, byte[] buffer, int length) {
            sent.add(Arrays.copyOf(buffer, length));
          }

          @Override
          public void broadcast(byte[] buffer, int length) {
            sent.add(Arrays.copyOf(buffer, length));
          }

          @Override
          public void onReceive(Receiver newReceiver) {
            receiver = newReceiver;
          }
        };
    comms = new Comms(platform(self, deployment, radio, strand, sessions), 1);
    talk = comms.open(TALK, (from, message) -> heard.add(message));
  }

  void arrive(byte[] datagram) {
    if (receiver == null) {
      throw new IllegalStateException("nobody listens");
    }
    receiver.received(datagram.clone(), datagram.length);
    strand.run();
  }

  /** How many datagrams were dropped, for whatever reason. */
  static long dropped(Comms comms) {
    long dropped = 0;
    for (DropReason reason : DropReason.values()) {
      dropped += comms.dropped(reason);
    }
    return dropped;
  }

  /** A platform of which only messages work. */
  static Platform platform(
      RobotId self,
      Participants deployment,
      Radio radio,
      Strand strand,
      @Nullable Sessions sessions) {
    return new Platform(
        self,
        deployment,
        () -> 0,
        action -> new NoTimer(),
        strand,
        radio,
        receiver -> {},
        new NoChassis(),
        ObjectSensor.NONE,
        Light.SIMULATED,
        new PromptStable(strand),
        name -> new Rng(1).fork(name),
        (task, done) -> task.run(),
        (timeNs, level, tag, line) -> {
          if (!line.matches("\\P{Cntrl}{1,500}")) {
            throw new AssertionError("a log line: " + line);
          }
        },
        new NoTrace(),
        Obstacles.NONE,
        List.of(),
        MotionParameters.DEFAULT,
        sessions);
  }

  /** Runs what is posted in its order, when it is told to. */
  static final class PromptStrand implements Strand {
    private final Deque<Runnable> posted = new ArrayDeque<>();

    void run() {
      for (Runnable action = posted.poll(); action != null; action = posted.poll()) {
        action.run();
      }
    }

    @Override
    public void start(Runnable app) {
      throw new UnsupportedOperationException("no app here");
    }

    @Override
    public void start(SuspendedApp app) {
      throw new UnsupportedOperationException("no app here");
    }

    @Override
    public void post(Runnable action) {
      posted.add(action);
    }

    @Override
    public boolean isCurrent() {
      return true;
    }

    @Override
    public void sleepUntil(long atNs) {
      throw new UnsupportedOperationException("no app here");
    }

    @Override
    public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
      throw new UnsupportedOperationException("no app here");
    }

    @Override
    public boolean suspendUntil(
        @Nullable BooleanSupplier condition, long deadlineNs, Object continuation) {
      throw new UnsupportedOperationException("no app here");
    }
  }

  private static final class NoTimer implements Timer {
    @Override
    public void set(long atNs) {}

    @Override
    public void cancel() {}

    @Override
    public boolean isSet() {
      return false;
    }
  }

  private static final class NoChassis implements Chassis {
    @Override
    public void drive(WheelCommand command) {}

    @Override
    public Bumps bumps() {
      return Bumps.NONE;
    }

    @Override
    public void onBump(Runnable receiver) {}
  }

  /** A disk that writes at once. */
  static final class PromptStable implements StableStorage {
    private final Map<String, byte[]> written = new TreeMap<>();
    private final Strand strand;

    PromptStable(Strand strand) {
      this.strand = strand;
    }

    /** The disk of an earlier start. */
    PromptStable(Strand strand, PromptStable kept) {
      this.strand = strand;
      written.putAll(kept.written);
    }

    @Override
    public byte @Nullable [] get(String key) {
      return written.get(key);
    }

    @Override
    public void put(String key, byte[] value, Runnable flushed) {
      written.put(key, value.clone());
      strand.post(flushed);
    }

    @Override
    public void remove(String key) {
      written.remove(key);
    }
  }

  private static final class NoTrace implements TraceSink {
    @Override
    public boolean isOn() {
      return false;
    }

    @Override
    public void record(TraceEvent event) {}
  }
}
