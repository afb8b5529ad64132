package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.body.WheelCommand;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.Strand;
import org.starl.platform.SuspendedApp;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.world.SimChassis;
import org.starl.sim.world.World;
import org.starl.sim.world.WorldLimits;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceSink;

/** Wheels of a body in the world server, without a Create. */
class SimulatedWheelsTest {

  private static final RobotId BOT0 = new RobotId("bot0");
  private static final WheelCommand AHEAD = new WheelCommand(200, 0);

  private final Queue strand = new Queue();
  private final List<Double> speeds = new ArrayList<>();
  private final World world =
      new World(() -> 0, action -> new Never(), new Speeds(), WorldLimits.CREATE, Obstacles.NONE);
  private final WorldBody body =
      new WorldBody(
          new RobotSpec(BOT0, new Pose(0, 0, 0), true, NoApp::new),
          "bot0",
          SimSettings.defaults(),
          258,
          world,
          strand,
          new SimChassis(strand, new Rng(1), 0));
  private final SimulatedWheels wheels = new SimulatedWheels(body, strand);

  @Test
  void commandsMoveTheBodyUntilAnEmergencyStopAndAfterItsRelease() {
    body.place(1000);
    wheels.drive(AHEAD);
    strand.drain();
    wheels.emergencyStop();
    wheels.drive(AHEAD);
    strand.drain();
    wheels.release();
    wheels.drive(AHEAD);
    strand.drain();

    assertThat(speeds).containsExactly(200.0, 0.0, 200.0);
  }

  @Test
  void aCommandOvertakenByAnEmergencyStopDoesNotUndoIt() {
    body.place(1000);
    strand.beforeNext = wheels::emergencyStop;

    wheels.drive(AHEAD);
    strand.drain();

    assertThat(speeds).allMatch(speed -> speed == 0);
  }

  private final class Speeds implements TraceSink {
    @Override
    public boolean isOn() {
      return true;
    }

    @Override
    public void record(TraceEvent event) {
      if (event instanceof Moved moved) {
        speeds.add(moved.linearMmPerS());
      }
    }
  }

  /** Posted actions, run on request; another thread may post before them. */
  private static final class Queue implements Strand {
    private final Deque<Runnable> posted = new ArrayDeque<>();
    private Runnable beforeNext = () -> {};

    void drain() {
      while (!posted.isEmpty()) {
        posted.remove().run();
      }
    }

    @Override
    public void post(Runnable action) {
      Runnable other = beforeNext;
      beforeNext = () -> {};
      other.run();
      posted.add(action);
    }

    @Override
    public boolean isCurrent() {
      return true;
    }

    @Override
    public void start(Runnable app) {
      throw new UnsupportedOperationException("no app");
    }

    @Override
    public void start(SuspendedApp app) {
      throw new UnsupportedOperationException("no app");
    }

    @Override
    public void sleepUntil(long atNs) {
      throw new UnsupportedOperationException("no app");
    }

    @Override
    public boolean awaitUntil(BooleanSupplier condition, long deadlineNs) {
      throw new UnsupportedOperationException("no app");
    }

    @Override
    public boolean suspendUntil(
        @Nullable BooleanSupplier condition, long deadlineNs, Object continuation) {
      throw new UnsupportedOperationException("no app");
    }
  }

  /** The body is driven without a program. */
  private static final class NoApp extends LogicThread {
    NoApp(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      return List.of();
    }
  }

  /** Time stands still. */
  private static final class Never implements Timer {
    @Override
    public void set(long atNs) {}

    @Override
    public void cancel() {}

    @Override
    public boolean isSet() {
      return false;
    }
  }
}
