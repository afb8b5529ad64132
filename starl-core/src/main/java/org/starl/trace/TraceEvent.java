package org.starl.trace;

import java.util.List;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/** One thing that happened to one robot. Times are ns from the start of the run. */
public sealed interface TraceEvent {

  long timeNs();

  RobotId robot();

  /** The same at another time. */
  default TraceEvent at(long newTimeNs) {
    return switch (this) {
      case Action e -> new Action(newTimeNs, e.robot, e.source, e.name, e.args);
      case Variable e -> new Variable(newTimeNs, e.robot, e.source, e.name, e.value);
      case Sent e -> new Sent(newTimeNs, e.robot, e.to, e.channel, e.seq, e.bytes, e.message);
      case Delivered e -> new Delivered(newTimeNs, e.robot, e.from, e.channel, e.seq, e.message);
      case Dropped e -> new Dropped(newTimeNs, e.robot, e.from, e.why);
      case Moved e -> new Moved(newTimeNs, e.robot, e.pose, e.linearMmPerS, e.angularRadPerS);
      case Joined e -> new Joined(newTimeNs, e.robot, e.pose, e.radiusMm);
      case Left e -> new Left(newTimeNs, e.robot);
      case Fault e -> new Fault(newTimeNs, e.robot, e.name, e.detail);
      case Intervention e -> new Intervention(newTimeNs, e.robot, e.step, e.name, e.detail);
    };
  }

  /**
   * An atomic action under its name in the paper and in PVS: {@code do_mutex}, {@code od_mutex},
   * {@code release}, {@code do_register}.
   *
   * @param source {@code app}, or a primitive and its instance: {@code mutex/crossing}
   */
  record Action(long timeNs, RobotId robot, String source, String name, List<String> args)
      implements TraceEvent {}

  /** A variable of the gvh, or one that a specification needs to see, has a new value. */
  record Variable(long timeNs, RobotId robot, String source, String name, String value)
      implements TraceEvent {}

  /**
   * A message was handed to the radio.
   *
   * @param to a robot, or {@code *} for everyone
   * @param seq its number among this robot's datagrams of this incarnation
   * @param message the message as text, for people; never parsed
   */
  record Sent(
      long timeNs, RobotId robot, String to, String channel, long seq, int bytes, String message)
      implements TraceEvent {}

  /** A message was handed to its handler on {@code robot}. */
  record Delivered(
      long timeNs, RobotId robot, RobotId from, String channel, long seq, String message)
      implements TraceEvent {}

  /**
   * A datagram to {@code robot} came to nothing.
   *
   * @param from the sender's name as far as known, or {@code ?}
   * @param why {@code loss}, {@code malformed}, {@code duplicate}, {@code no-listener}, ...
   */
  record Dropped(long timeNs, RobotId robot, String from, String why) implements TraceEvent {}

  /**
   * From now on the robot's true body moves so: from this pose with constant forward and turning
   * speed, until its next {@code Moved}.
   */
  record Moved(long timeNs, RobotId robot, Pose pose, double linearMmPerS, double angularRadPerS)
      implements TraceEvent {}

  /** The robot's body, a disc, is on the floor from now on; it stands still. */
  record Joined(long timeNs, RobotId robot, Pose pose, double radiusMm) implements TraceEvent {}

  /** The robot's body is off the floor from now on. */
  record Left(long timeNs, RobotId robot) implements TraceEvent {}

  /**
   * Something goes wrong that is nobody's doing, or is well again.
   *
   * @param robot whom it befalls, or {@link #WORLD}
   * @param name {@link #CRASH}, {@link #RESTART}, {@link #BEGIN}, {@link #END} or {@link #HEALED}
   * @param detail the fault in the grammar of {@code --fault}; of a restart, what became of writes
   *     that were not flushed; else empty
   */
  record Fault(long timeNs, RobotId robot, String name, String detail) implements TraceEvent {

    /** Stands for everybody: no robot is called so. */
    public static final RobotId WORLD = new RobotId("world");

    /** The robot's program is gone from now on; its body stands where it is. */
    public static final String CRASH = "crash";

    /** The robot's program begins anew, as another incarnation. */
    public static final String RESTART = "restart";

    /** From now on the fault does harm. */
    public static final String BEGIN = "begin";

    /** The fault does no more harm. */
    public static final String END = "end";

    /** All faults have ended and none will begin: from now on progress is owed. */
    public static final String HEALED = "healed";

    /** The {@code detail} of a fault of the world: its robots are processes in real time. */
    public static final String REAL_TIME = "realtime";

    /** Whether it says that the run was in real time, which cannot be repeated. */
    public boolean isRealTime() {
      return name.equals(BEGIN) && detail.equals(REAL_TIME);
    }
  }

  /**
   * A person did something to the run while it ran. To do the same to the same run at the same place
   * is to run it again.
   *
   * @param robot to whom, or {@link Fault#WORLD}
   * @param step after so many steps of the simulator: of several at one time, it tells the place
   * @param name {@link #FAULT}, {@link #POINT} or {@link #STOP}
   * @param detail of a fault, its text in the grammar of {@code --fault}; of a point, {@code x,y} in
   *     mm; else empty
   */
  record Intervention(long timeNs, RobotId robot, long step, String name, String detail)
      implements TraceEvent {

    /** From now on this goes wrong as well; a fault's own events follow. */
    public static final String FAULT = "fault";

    /** The robot's app is shown a place. */
    public static final String POINT = "point";

    /** The run ends. */
    public static final String STOP = "stop";
  }
}
