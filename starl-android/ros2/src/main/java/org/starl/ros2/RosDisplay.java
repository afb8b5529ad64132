package org.starl.ros2;

import static org.starl.time.Time.NS_PER_MS;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.robot.Ros2;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.file.RosTopic;
import org.starl.robot.file.Wheels;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;
import org.starl.trace.TraceCodec;
import org.starl.trace.TraceEvent;

/**
 * A robot's events as topics for RViz and rosbag, under {@code starl} in its namespace: {@code events},
 * each a line of the trace; {@code path}, where it was measured; {@code markers}, its body with its
 * variables. If the network is slow, events are left out: the trace has them all.
 */
final class RosDisplay implements Ros2.Display {

  private static final int MOST_WAITING = 1000;
  private static final int MOST_POSES = 500;
  private static final long SHOW_NS = 100 * NS_PER_MS;
  private static final long CLOSE_MS = 500;
  private static final double MM_PER_M = 1000;
  private static final double HEIGHT_M = 0.1;
  private static final int CYLINDER = 3;
  private static final int TEXT = 9;

  private final String name;
  private final String frame;
  private final RosNode node;
  private final RosNode.Output events;
  private final RosNode.Output path;
  private final RosNode.Output markers;
  private final BlockingQueue<TraceEvent> waiting = new ArrayBlockingQueue<>(MOST_WAITING);
  private final Thread publisher;

  // The publisher's thread only.
  private final Deque<Pose> poses = new ArrayDeque<>();
  private final Map<String, String> variables = new TreeMap<>();
  private double radiusMm;
  private long shownNs = Long.MIN_VALUE;

  private RosDisplay(String name, String namespace, String frame, RosNode node) throws IOException {
    this.name = name;
    this.frame = frame;
    this.node = node;
    String prefix = namespace.equals("/") ? "/starl/" : namespace + "/starl/";
    events = output(prefix + "events", RosType.STRING);
    path = output(prefix + "path", RosType.PATH);
    markers = output(prefix + "markers", RosType.MARKER_ARRAY);
    publisher = Daemons.of(name + " ros2 display", this::publishAll);
    publisher.start();
  }

  private RosNode.Output output(String topic, RosType type) throws IOException {
    return node.publish(new RosTopic("", topic, type.shortName(), true, false), false);
  }

  static RosDisplay open(RobotEntry robot, Wheels.Ros2 base, Positions positions)
      throws IOException {
    String frame = positions instanceof Positions.Ros2 ros2 ? ros2.frame() : "map";
    RosNode node =
        RosNode.open("starl_display", RealClock::machineNs, (timeNs, level, tag, line) -> {});
    return new RosDisplay(robot.id().name(), base.namespace(), frame, node);
  }

  @Override
  public void accept(TraceEvent event) {
    if (!waiting.offer(event)) {
      return; // too many wait: the trace has it
    }
  }

  @Override
  public void close() {
    publisher.interrupt();
    Daemons.join(publisher, CLOSE_MS);
    node.close();
  }

  private void publishAll() {
    try {
      while (true) {
        show(waiting.take());
      }
    } catch (InterruptedException closed) {
      Thread.currentThread().interrupt();
    }
  }

  private void show(TraceEvent event) {
    events.publish(Cdr.empty().text(TraceCodec.line(event)));
    switch (event) {
      case TraceEvent.Joined joined -> {
        radiusMm = joined.radiusMm();
        at(joined.pose());
      }
      case TraceEvent.Moved moved -> at(moved.pose());
      case TraceEvent.Variable variable ->
          variables.put(
              variable.source() + "." + variable.name(), String.valueOf(variable.value()));
      default -> {}
    }
  }

  private void at(Pose pose) {
    poses.addLast(pose);
    if (poses.size() > MOST_POSES) {
      poses.removeFirst();
    }
    long nowNs = RealClock.machineNs();
    if (shownNs == Long.MIN_VALUE || nowNs - shownNs >= SHOW_NS) {
      shownNs = nowNs;
      long unixNs = RosBase.unixNs();
      path.publish(path(unixNs));
      markers.publish(markers(pose, unixNs));
    }
  }

  private Cdr path(long unixNs) {
    Cdr out = Cdr.empty().header(unixNs, frame).i32(poses.size());
    poses.forEach(pose -> put(out.header(unixNs, frame), pose, 0));
    return out;
  }

  private Cdr markers(Pose pose, long unixNs) {
    StringBuilder text = new StringBuilder(name);
    variables.forEach((variable, value) -> text.append('\n').append(variable + " = " + value));
    double metres = 2 * radiusMm / MM_PER_M;
    Cdr out = Cdr.empty().i32(2);
    marker(out, unixNs, 0, CYLINDER, pose, HEIGHT_M / 2, null);
    marker(out, unixNs, 1, TEXT, pose, metres + HEIGHT_M, text.toString());
    return out;
  }

  private void marker(
      Cdr out, long unixNs, int id, int type, Pose pose, double zM, @Nullable String text) {
    double metres = 2 * radiusMm / MM_PER_M;
    out.header(unixNs, frame).text(name).i32(id).i32(type).i32(0);
    put(out, pose, zM);
    out.f64(metres, metres, HEIGHT_M).f32(0.2, 0.5, 0.9, 1).i32(1).i32(0).u8(0);
    // No points, colours, texture (a compressed image), coordinates in it.
    out.i32(0).i32(0).text("").header(0, "").text("").i32(0).i32(0);
    // No mesh, its file, its materials.
    out.text(text == null ? "" : text).text("").text("").i32(0).u8(0);
  }

  private static void put(Cdr out, Pose pose, double zM) {
    double half = pose.headingRad() / 2;
    out.f64(pose.xMm() / MM_PER_M, pose.yMm() / MM_PER_M, zM);
    out.f64(0, 0, StrictMath.sin(half), StrictMath.cos(half));
  }
}
