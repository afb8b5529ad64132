package org.starl.trace;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.SumShape;

/** An event of one robot. Times are in ns from the start of the run. */
public sealed interface TraceEvent {

  long timeNs();

  RobotId robot();

  /** This event at another time. */
  default TraceEvent at(long newTimeNs) {
    return switch (this) {
      case Action e -> new Action(newTimeNs, e.robot, e.source, e.shape, e.fact);
      case Variable e -> new Variable(newTimeNs, e.robot, e.source, e.variable, e.value);
      case Sent e ->
          new Sent(newTimeNs, e.robot, e.to, e.channel, e.seq, e.bytes, e.shape, e.message);
      case Delivered e ->
          new Delivered(newTimeNs, e.robot, e.from, e.channel, e.seq, e.shape, e.message);
      case Dropped e -> new Dropped(newTimeNs, e.robot, e.from, e.why);
      case Moved e -> new Moved(newTimeNs, e.robot, e.pose, e.linearMmPerS, e.angularRadPerS);
      case Joined e -> new Joined(newTimeNs, e.robot, e.pose, e.radiusMm);
      case Left e -> new Left(newTimeNs, e.robot);
      case Fault e -> new Fault(newTimeNs, e.robot, e.name, e.effect, e.detail);
      case Intervention e -> new Intervention(newTimeNs, e.robot, e.step, e.name, e.detail);
    };
  }

  /**
   * An atomic action, under its name in the paper and in PVS: {@code do_mutex}, {@code od_mutex},
   * {@code release}, {@code do_register}.
   *
   * @param source the app, or an instance of a primitive
   * @param shape of the fact
   * @param fact what happened: a record. Monitors match its type
   */
  record Action(long timeNs, RobotId robot, Instance source, RecordShape<?> shape, Object fact)
      implements TraceEvent {

    /** An action of this shape. */
    public static <F> Action of(
        long timeNs, RobotId robot, Instance source, RecordShape<F> shape, F fact) {
      return new Action(timeNs, robot, source, shape, fact);
    }

    /** An action that is one of the records of a sum. */
    public static <F> Action of(
        long timeNs, RobotId robot, Instance source, SumShape<F> shape, F fact) {
      return new Action(timeNs, robot, source, shape.caseOf(fact), fact);
    }

    /** The fact's name: {@code do_mutex}. */
    public String name() {
      return fact instanceof Note note ? note.name() : shape.name();
    }

    /** The values of the fact's parts: for people. */
    public List<? extends Object> args() {
      return fact instanceof Note note ? note.texts() : shape.values(fact);
    }

    /** The process that acted: the fact's first part, if that is a process of this robot. */
    public @Nullable ProcessId process() {
      return shape.first(fact) instanceof ProcessId id && id.robot().equals(robot) ? id : null;
    }
  }

  /**
   * A variable of the gvh, or another one that a specification reads, has a new value.
   *
   * @param source the app, or an instance of a primitive
   */
  record Variable(long timeNs, RobotId robot, Instance source, Var<?> variable, Object value)
      implements TraceEvent {

    /** The variable's name: {@code crit}. */
    public String name() {
      return variable.name();
    }

    /** The new value, if this is a change of {@code wanted}; else null. */
    @SuppressWarnings("unchecked") // a variable has values of its type only
    public <T> @Nullable T of(Var<T> wanted) {
      return variable == wanted ? (T) value : null;
    }
  }

  /**
   * A message was passed to the radio.
   *
   * @param to a robot, or {@link #ALL} for a broadcast
   * @param seq its number among the datagrams of this robot's incarnation
   * @param shape of the message
   * @param message the message; monitors match its type
   */
  record Sent(
      long timeNs,
      RobotId robot,
      String to,
      Instance channel,
      long seq,
      int bytes,
      Shape<?> shape,
      Object message)
      implements TraceEvent {

    /** The receivers of a broadcast: all robots in range. */
    public static final String ALL = "*";
  }

  /** A message was passed to its handler on {@code robot}. */
  record Delivered(
      long timeNs,
      RobotId robot,
      RobotId from,
      Instance channel,
      long seq,
      Shape<?> shape,
      Object message)
      implements TraceEvent {}

  /**
   * A datagram to {@code robot} was lost or dropped.
   *
   * @param from the sender's name if known, else {@code ?}
   * @param why {@code loss}, {@code malformed}, {@code duplicate}, {@code no-listener}, ...
   */
  record Dropped(long timeNs, RobotId robot, String from, String why) implements TraceEvent {}

  /**
   * From now on the robot's true body moves from this pose with constant forward and turning speed,
   * until its next {@code Moved}.
   */
  record Moved(long timeNs, RobotId robot, Pose pose, double linearMmPerS, double angularRadPerS)
      implements TraceEvent {}

  /** The robot's body, a disc, is put on the floor and stands still. */
  record Joined(long timeNs, RobotId robot, Pose pose, double radiusMm) implements TraceEvent {}

  /** The robot's body is taken off the floor. */
  record Left(long timeNs, RobotId robot) implements TraceEvent {}

  /**
   * A fault, or the end of one.
   *
   * @param robot the affected robot, or {@link #WORLD}
   * @param name {@link #CRASH}, {@link #RESTART}, {@link #BEGIN}, {@link #END} or {@link #HEALED}
   * @param effect of a fault that begins or ends: the first word of its text, as {@code jump}; else
   *     empty
   * @param detail of a fault that begins or ends: its text in the grammar of {@code --fault}; for a
   *     restart, what happened to writes that were not flushed; else empty
   */
  record Fault(long timeNs, RobotId robot, String name, String effect, String detail)
      implements TraceEvent {

    /** Means all robots; no robot has this name. */
    public static final RobotId WORLD = new RobotId("world");

    /** The robot's program has crashed; its body stays where it is. */
    public static final String CRASH = "crash";

    /** The robot's program starts again, as another incarnation. */
    public static final String RESTART = "restart";

    /** The fault takes effect. */
    public static final String BEGIN = "begin";

    /** The fault ends. */
    public static final String END = "end";

    /** All faults have ended and none will begin: progress is required from now on. */
    public static final String HEALED = "healed";

    /** The effect of a fault of the world: robots are processes in real time. */
    public static final String REAL_TIME = "realtime";

    /** A fault without an effect: a crash, a restart or the end of all faults. */
    public Fault(long timeNs, RobotId robot, String name, String detail) {
      this(timeNs, robot, name, "", detail);
    }

    /** The beginning of a run in real time. */
    public static Fault realTime(long timeNs) {
      return new Fault(timeNs, WORLD, BEGIN, REAL_TIME, REAL_TIME);
    }

    /** Whether this event says that the run was in real time, which cannot be repeated. */
    public boolean isRealTime() {
      return name.equals(BEGIN) && effect.equals(REAL_TIME);
    }

    /**
     * Whether it begins or ends a fault that crashes robots. It is no fault beside these: each crash
     * and restart has its own event.
     */
    public boolean isOfCrashes() {
      return effect.equals(CRASH);
    }
  }

  /**
   * A person changed the run while it was going on. Repeating the same change at the same step
   * repeats the run.
   *
   * @param robot the affected robot, or {@link Fault#WORLD}
   * @param step number of simulator steps before the change; unlike the time, it is unique
   * @param name {@link #FAULT}, {@link #POINT} or {@link #STOP}
   * @param detail for a fault, its text in the grammar of {@code --fault}; for a point, {@code x,y}
   *     in mm; else empty
   */
  record Intervention(long timeNs, RobotId robot, long step, String name, String detail)
      implements TraceEvent {

    /** A fault was added; the fault's own events follow. */
    public static final String FAULT = "fault";

    /** The robot's app was shown a point. */
    public static final String POINT = "point";

    /** The run was stopped. */
    public static final String STOP = "stop";
  }
}
