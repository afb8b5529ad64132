package org.starl.sim.view;

import java.util.List;
import java.util.Map;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;
import org.starl.sim.replay.Recording;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.Var;

/** Builds small recordings. */
final class Runs {

  static final long SECOND_NS = 1_000_000_000;
  static final RobotId A = new RobotId("bot0");
  static final RobotId B = new RobotId("bot1");

  static final Var<String> LOCATION = Var.of("location", Shapes.TEXT);

  private final Recording recording = new Recording(Obstacles.NONE, new Plain());

  /** Has two parts, and describes a robot by its location. */
  private static final class Plain implements Layer {
    @Override
    public Layer copy() {
      return this;
    }

    @Override
    public List<String> parts() {
      return List.of("zones", "routes");
    }

    @Override
    public String describe(RobotId robot, Scene scene) {
      return scene.text(robot, Instance.APP, "location");
    }
  }

  /** Two robots, 1 m apart, join at time 0. */
  Runs(Map<String, String> settings) {
    recording.started(new TraceHeader("0", "test", 7, 8, settings, List.of(A, B)));
    recording.observed(new TraceEvent.Joined(0, A, Pose.of(new Point(0, 0), 0), 100));
    recording.observed(new TraceEvent.Joined(0, B, Pose.of(new Point(1000, 0), 0), 100));
  }

  static Runs plain() {
    return new Runs(Map.of());
  }

  /** A finished run of {@code count} seconds with one event per second. */
  static Recording seconds(int count) {
    Runs run = plain();
    for (int i = 1; i <= count; i++) {
      run.says(i * SECOND_NS, A, Integer.toString(i));
    }
    return run.over(count * SECOND_NS);
  }

  Runs says(long atNs, RobotId robot, String location) {
    recording.observed(new TraceEvent.Variable(atNs, robot, Instance.APP, LOCATION, location));
    return this;
  }

  Runs happens(TraceEvent event) {
    recording.observed(event);
    return this;
  }

  Runs violates(long atNs, String lemma) {
    says(atNs, A, "wrong");
    recording.violated(new SpecReport.Violation(lemma, atNs, List.of(A), "seen"));
    return this;
  }

  Recording recording() {
    return recording;
  }

  Recording over(long atNs) {
    recording.over(atNs);
    return recording;
  }
}
