package org.starl.sim.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.IntFunction;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.shape.Shapes;
import org.starl.sim.SimObserver;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

class CursorTest {

  private static final long NS_PER_MS = 1_000_000;
  private static final Var<String> X = Var.of("x", Shapes.TEXT);

  /** Counts each robot's events. */
  private static final class Counting implements Layer {
    private final SortedMap<RobotId, Integer> counts = new TreeMap<>();

    @Override
    public Layer copy() {
      Counting copy = new Counting();
      copy.counts.putAll(counts);
      return copy;
    }

    @Override
    public void observe(TraceEvent event) {
      counts.merge(event.robot(), 1, Integer::sum);
    }

    @Override
    public String describe(RobotId robot, Scene scene) {
      return String.valueOf(counts.getOrDefault(robot, 0));
    }
  }

  private static Recording recorded(long seed) {
    Recording recording = new Recording(Obstacles.NONE, new Counting());
    Wander.simulation(seed).fault("crash(bot1,at=9s,restart=3s)").observer(recording).build().run();
    return recording;
  }

  /** The whole state of a scene and its layer, as text. */
  private static List<String> state(Scene scene, Layer layer) {
    List<String> lines = new ArrayList<>(List.of("at " + scene.nowNs()));
    for (RobotId robot : scene.robots()) {
      lines.add(robot + " " + scene.number(robot) + " " + scene.pose(robot));
      lines.add(scene.trail(robot).toString());
      lines.add(scene.text(robot, MotionFact.SOURCE, "motionflag"));
      lines.add(layer.describe(robot, scene));
    }
    return lines;
  }

  private static List<String> stateFromStart(Recording recording, int events, long timeNs) {
    Scene scene = new Scene(Obstacles.NONE);
    Layer layer = new Counting();
    for (int i = 0; i < events; i++) {
      scene.observe(recording.event(i));
      layer.observe(recording.event(i));
    }
    scene.advance(timeNs);
    return state(scene, layer);
  }

  @Property(tries = 20)
  void seekingGivesTheSameStateAsObservingFromTheStart(
      @ForAll @IntRange(max = 5) int seed,
      @ForAll @Size(min = 3, max = 12) List<@IntRange(max = 31_000) Integer> timesMs) {
    Recording recording = recorded(seed);
    Cursor cursor = new Cursor(recording);
    cursor.seek(Long.MAX_VALUE);
    assertThat(recording.checkpoints().size()).isGreaterThan(2);
    for (int timeMs : timesMs) {
      long timeNs = Math.min(timeMs * NS_PER_MS, recording.endNs());
      cursor.seek(timeNs);
      assertThat(cursor.index()).isEqualTo(recording.firstAfter(timeNs));
      assertThat(state(cursor.scene(), cursor.layer()))
          .as("seed %d, seeks to %s ms", seed, timesMs)
          .isEqualTo(stateFromStart(recording, cursor.index(), timeNs));
    }
  }

  @Property(tries = 20)
  void toEventGoesForwardsAndBackwards(
      @ForAll @IntRange(max = 5) int seed,
      @ForAll @Size(min = 3, max = 12) List<@IntRange(max = 1_000_000) Integer> places) {
    Recording recording = recorded(seed);
    Cursor cursor = new Cursor(recording);
    for (int place : places) {
      int number = place % recording.size();
      cursor.toEvent(number);
      assertThat(cursor.index()).isEqualTo(number + 1);
      assertThat(cursor.nowNs()).isEqualTo(recording.timeNs(number));
      assertThat(state(cursor.scene(), cursor.layer()))
          .as("seed %d, events %s", seed, places)
          .isEqualTo(stateFromStart(recording, number + 1, cursor.nowNs()));
    }
  }

  @Test
  void aLongRunHasFewCheckpoints() {
    Recording recording = new Recording(Obstacles.NONE, new Counting());
    RobotId robot = new RobotId("bot0");
    for (int i = 0; i < 500_000; i++) {
      recording.observed(new TraceEvent.Variable(i, robot, Instance.APP, X, "" + i % 7));
    }
    Cursor cursor = new Cursor(recording);
    cursor.seek(Long.MAX_VALUE);
    assertThat(recording.checkpoints().size()).isBetween(32, 96);
    assertThat(recording.checkpoints().before(400_000).events()).isGreaterThan(380_000);
    cursor.seek(123_456);
    assertThat(cursor.scene().variable(robot, X)).isEqualTo("" + 123_456 % 7);
  }

  @Test
  void shortWayBackInALongRunObservesFewEvents() {
    int[] observed = new int[1];
    Layer counting =
        new Layer() {
          @Override
          public Layer copy() {
            return this;
          }

          @Override
          public void observe(TraceEvent event) {
            observed[0]++;
          }
        };
    Recording recording = new Recording(Obstacles.NONE, counting);
    int robots = 10_000;
    for (int i = 0; i < robots; i++) {
      recording.observed(new TraceEvent.Joined(0, new RobotId("bot" + i), new Pose(i, 0, 0), 165));
    }
    for (int i = robots; i < 250_000; i++) {
      recording.observed(
          new TraceEvent.Variable(i, new RobotId("bot" + i % robots), Instance.APP, X, "" + i));
    }
    Cursor cursor = new Cursor(recording);
    cursor.toEvent(240_000);
    observed[0] = 0;
    for (int i = 1; i <= 10; i++) {
      cursor.toEvent(240_000 - i);
      String last = cursor.scene().variable(new RobotId("bot" + (240_000 - i) % robots), X);
      assertThat(last).isEqualTo("" + (240_000 - i));
    }
    assertThat(observed[0]).isLessThan(400_000);
  }

  @Test
  void faultsAndCrashesAreMarked() {
    Recording recording = recorded(1);
    assertThat(recording.marks())
        .extracting(Mark::kind)
        .containsSubsequence(Mark.Kind.FAULT, Mark.Kind.CRASH, Mark.Kind.RESTART, Mark.Kind.FAULT);
    assertThat(recording.marks())
        .allSatisfy(mark -> assertThat(recording.timeNs(mark.index())).isEqualTo(mark.timeNs()));
    assertThat(recording.logs()).isNotEmpty();
    assertThat(recording.isOver()).isTrue();
  }

  @Test
  void eventsBeyondTheMemoryAreReadFromAFile() {
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE, 400_000);
    RobotId robot = new RobotId("bot0");
    IntFunction<TraceEvent> event =
        i -> new TraceEvent.Variable(i / 3, robot, Instance.APP, X, "\"\n" + i % 999);
    int size = 200_000;
    for (int i = 0; i < size; i++) {
      recording.observed(event.apply(i));
    }
    assertThat(recording.size()).isEqualTo(size);
    for (int i = 0; i < size; i++) {
      assertThat(recording.event(i)).isEqualTo(event.apply(i));
    }
    for (int i = 0; i < 1000; i++) {
      int timeNs = i * 7919 % (size / 3);
      assertThat(recording.firstAfter(timeNs)).isEqualTo(3 * timeNs + 3);
    }
    assertThat(recording.firstAfter(-1)).isZero();
    assertThat(recording.firstAfter(size)).isEqualTo(size);
  }

  @Test
  void eventsInMemoryAreKeptUnchanged() {
    List<TraceEvent> events = new ArrayList<>();
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
    SimObserver all =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            events.add(event);
          }
        };
    Wander.simulation(1).observer(recording).observer(all).build().run();
    assertThat(recording.size()).isEqualTo(events.size());
    for (int i = 0; i < events.size(); i++) {
      assertThat(recording.event(i)).isEqualTo(events.get(i));
    }
  }
}
