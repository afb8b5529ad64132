package org.starl.testing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Obstacles;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.Chassis;
import org.starl.platform.DeploymentKey;
import org.starl.platform.Light;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Platform;
import org.starl.platform.Positioning;
import org.starl.platform.Radio;
import org.starl.platform.StableStorage;
import org.starl.platform.Strand;
import org.starl.platform.SuspendedApp;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.session.KnownStarts;
import org.starl.session.Sessions;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/** One robot's ports in a {@link FakeWorld}. Its strand's pieces are events of that world. */
public final class FakePlatform {

  private final Platform platform;

  /** Log lines, as {@code LEVEL tag: line}. */
  public final List<String> log = new ArrayList<>();

  /** What the wheels were told, in order. */
  public final List<WheelCommand> driven = new ArrayList<>();

  final Map<String, byte[]> stored;
  boolean isUp = true;

  private final FakeWorld world;
  private final RobotId id;
  private final Participants deployment;
  private boolean inPiece;
  private Bumps bumps = Bumps.NONE;
  private Runnable bumpReceiver = () -> {};
  private Positioning.@Nullable Receiver fixReceiver;
  private Radio.@Nullable Receiver radioReceiver;

  FakePlatform(FakeWorld world, RobotId id, Participants deployment, Map<String, byte[]> stored) {
    this.world = world;
    this.id = id;
    this.deployment = deployment;
    this.stored = stored;
    platform = platform(MotionParameters.DEFAULT);
  }

  /** The same ports, with a body of this kind. */
  public Platform platform(MotionParameters parameters) {
    return new Platform(
        id,
        deployment,
        world::nowNs,
        FakeTimer::new,
        new FakeStrand(),
        new FakeRadio(),
        receiver -> fixReceiver = receiver,
        new FakeChassis(),
        ObjectSensor.NONE,
        Light.SIMULATED,
        new FakeStable(),
        name -> new Rng(42).fork(id.name()).fork(name),
        this::compute,
        (timeNs, level, tag, line) -> log.add(level + " " + tag + ": " + line),
        new FakeTrace(),
        Obstacles.NONE,
        List.of(),
        parameters,
        sessions());
  }

  private @Nullable Sessions sessions() {
    DeploymentKey key = world.key;
    return key == null
        ? null
        : new KnownStarts(
            peer -> key.pairKey(id, peer),
            id,
            world.starts(id),
            world::starts,
            () -> deployment,
            null);
  }

  /** The bundle of ports. */
  public Platform platform() {
    return platform;
  }

  /** Lets the robot have this fix in its next piece. */
  public void fix(Fix fix) {
    post(() -> {
      if (fixReceiver != null) {
        fixReceiver.fixed(fix);
      }
    });
  }

  /** Presses or releases the bump sensors in the robot's next piece. */
  public void bump(Bumps now) {
    post(() -> {
      bumps = now;
      bumpReceiver.run();
    });
  }

  void arrive(byte[] buffer, int length) {
    if (radioReceiver != null) {
      Radio.Receiver receiver = radioReceiver;
      piece(() -> receiver.received(buffer, length));
    }
  }

  private void compute(Runnable task, Runnable done) {
    task.run();
    post(done);
  }

  private void post(Runnable action) {
    world.at(world.nowNs(), () -> piece(action));
  }

  private void piece(Runnable action) {
    if (isUp) {
      inPiece = true;
      action.run();
      inPiece = false;
    }
  }

  /** An app that waits runs the world meanwhile: of all robots of a world one may have an app. */
  private final class FakeStrand implements Strand {
    @Override
    public void start(Runnable app) {
      FakePlatform.this.post(app);
    }

    @Override
    public void start(SuspendedApp app) {
      throw new UnsupportedOperationException("blocking apps only");
    }

    @Override
    public boolean suspendUntil(
        @Nullable BooleanSupplier condition, long deadlineNs, Object continuation) {
      throw new UnsupportedOperationException("blocking apps only");
    }

    @Override
    public void post(Runnable action) {
      FakePlatform.this.post(action);
    }

    @Override
    public boolean isCurrent() {
      return inPiece;
    }

    @Override
    public void sleepUntil(long atNs) {
      awaitUntil(() -> false, Math.max(atNs, world.nowNs()));
    }

    @Override
    public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
      boolean holds = condition.getAsBoolean();
      while (!holds && world.step(deadlineNs)) {
        holds = condition.getAsBoolean();
      }
      inPiece = true;
      return holds;
    }
  }

  private final class FakeTimer implements Timer {
    private final Runnable action;
    private int setting;
    private long setForNs;
    private boolean isSet;

    FakeTimer(Runnable action) {
      this.action = action;
    }

    @Override
    public void set(long atNs) {
      if (isSet && atNs == setForNs) {
        return;
      }
      cancel();
      if (atNs == NEVER) {
        return;
      }
      isSet = true;
      setForNs = atNs;
      int mine = setting;
      world.at(atNs, () -> expire(mine));
    }

    @Override
    public void cancel() {
      setting++;
      isSet = false;
    }

    @Override
    public boolean isSet() {
      return isSet;
    }

    private void expire(int mine) {
      if (mine == setting) {
        isSet = false;
        piece(action);
      }
    }
  }

  private final class FakeRadio implements Radio {
    @Override
    public void send(RobotId to, byte[] buffer, int length) {
      world.transmit(id, to, Arrays.copyOf(buffer, length));
    }

    @Override
    public void broadcast(byte[] buffer, int length) {
      world.broadcast(id, Arrays.copyOf(buffer, length));
    }

    @Override
    public void onReceive(Receiver receiver) {
      radioReceiver = receiver;
    }
  }

  private final class FakeChassis implements Chassis {
    @Override
    public void drive(WheelCommand command) {
      driven.add(command);
    }

    @Override
    public Bumps bumps() {
      return bumps;
    }

    @Override
    public void onBump(Runnable receiver) {
      bumpReceiver = receiver;
    }
  }

  private final class FakeStable implements StableStorage {
    @Override
    public byte @Nullable [] get(String key) {
      byte[] value = stored.get(key);
      return value == null ? null : value.clone();
    }

    @Override
    public void put(String key, byte[] value, Runnable flushed) {
      stored.put(key, value.clone());
      FakePlatform.this.post(flushed);
    }

    @Override
    public void remove(String key) {
      stored.remove(key);
    }
  }

  private final class FakeTrace implements TraceSink {
    @Override
    public boolean isOn() {
      return world.tracing;
    }

    @Override
    public void record(TraceEvent event) {
      world.trace.add(event);
    }
  }
}
