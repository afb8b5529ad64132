package org.starl.sim.record;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFailure;
import org.starl.trace.Holding;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/**
 * What each robot did over time, in lanes: the variables of its app, what each primitive holds or
 * waits for, bumps and faults, and messages. Pass it every event. Windows, pages and pictures paint it
 * with {@link LanePainter}.
 */
public final class Lanes {

  /** Later changes of a lane are left out, so that the lanes of a long run need little memory. */
  static final int MOST_CHANGES = 20_000;

  private static final String EVENTS = "faults, bumps";
  private static final String MESSAGES = "messages";

  /** The rank of the lane of the body's motion, which is left out while there is none. */
  private static final int MOTION = 3;

  /** How a lane is painted. */
  enum Kind {
    /** Each change begins a state with a text. */
    STATES,
    /** Each change is a number. */
    CURVE,
    /** Each change is an instant. */
    INSTANTS
  }

  /** What an instant is. */
  enum Tone {
    PLAIN,
    GOOD,
    ALARM
  }

  /**
   * A change in a lane.
   *
   * @param text of the state that begins, or of the instant; empty for no state
   * @param value of a curve
   */
  record Change(long timeNs, String text, double value, Tone tone) {}

  /** One lane of a robot. */
  static final class Lane {
    private final Kind kind;
    private final int rank;
    private final List<Change> changes = new ArrayList<>();
    private boolean hasHoldings;

    Lane(Kind kind, int rank) {
      this.kind = kind;
      this.rank = rank;
    }

    Kind kind() {
      return kind;
    }

    List<Change> changes() {
      return Collections.unmodifiableList(changes);
    }

    private void add(long timeNs, String text, double value, Tone tone) {
      if (changes.size() < MOST_CHANGES) {
        changes.add(new Change(timeNs, text, value, tone));
      }
    }

    private void state(long timeNs, String text) {
      if (changes.isEmpty() || !changes.getLast().text().equals(text)) {
        add(timeNs, text, 0, Tone.PLAIN);
      }
    }
  }

  private final SortedMap<RobotId, Map<String, Lane>> robots = new TreeMap<>();
  private final Map<RobotId, Integer> numbers = new LinkedHashMap<>();
  private final Map<String, Integer> words = new LinkedHashMap<>();

  /** Adds the next event. */
  public void observe(TraceEvent event) {
    long timeNs = event.timeNs();
    RobotId robot = event.robot();
    switch (event) {
      case TraceEvent.Joined joined -> numbers.putIfAbsent(robot, numbers.size());
      case TraceEvent.Variable variable -> changed(variable);
      case TraceEvent.Action action -> acted(action);
      case TraceEvent.Sent sent ->
          instant(robot, MESSAGES, timeNs, sent.channel() + " to " + sent.to(), Tone.PLAIN);
      case TraceEvent.Delivered in ->
          instant(robot, MESSAGES, timeNs, in.channel() + " from " + in.from(), Tone.GOOD);
      case TraceEvent.Dropped lost ->
          instant(robot, MESSAGES, timeNs, lost.why() + ", from " + lost.from(), Tone.ALARM);
      case TraceEvent.Fault fault -> {
        if (!fault.robot().equals(TraceEvent.Fault.WORLD)) {
          instant(robot, EVENTS, timeNs, fault.name() + " " + fault.detail(), Tone.ALARM);
        }
      }
      default -> {
        // Bodies are on the floor, interventions on the timeline.
      }
    }
  }

  private void changed(TraceEvent.Variable variable) {
    Instance source = variable.source();
    Object value = variable.value();
    if (source.equals(Instance.APP)) {
      boolean isNumber = value instanceof Number;
      Kind kind = isNumber ? Kind.CURVE : Kind.STATES;
      Lane lane = lane(variable.robot(), variable.name(), kind, isNumber ? 1 : 0);
      if (value instanceof Number number && lane.kind == Kind.CURVE) {
        lane.add(variable.timeNs(), value.toString(), number.doubleValue(), Tone.PLAIN);
      } else {
        lane.state(variable.timeNs(), value.toString());
      }
    } else if (!(value instanceof Boolean) && !variable.name().equals(MotionFact.TASK.name())) {
      int rank = source.equals(MotionFact.SOURCE) ? MOTION : MOTION - 1;
      Lane lane = lane(variable.robot(), source.owner().name(), Kind.STATES, rank);
      if (!lane.hasHoldings) {
        lane.state(variable.timeNs(), variable.name() + " " + value);
      }
    }
  }

  private void acted(TraceEvent.Action action) {
    RobotId robot = action.robot();
    long timeNs = action.timeNs();
    if (action.fact() instanceof MotionFact motion) {
      if (motion instanceof MotionFact.failed end && end.reason() == MotionFailure.BUMPED) {
        instant(robot, EVENTS, timeNs, "bump", Tone.ALARM);
      }
    } else if (action.source().equals(Instance.APP)) {
      instant(robot, EVENTS, timeNs, text(action), Tone.PLAIN);
    } else {
      Lane lane = lane(robot, action.source().owner().name(), Kind.STATES, 2);
      if (action.fact() instanceof Holding fact) {
        lane.hasHoldings = true;
        lane.state(timeNs, fact.holding());
      } else if (!lane.hasHoldings) {
        lane.state(timeNs, text(action));
      }
    }
  }

  /** The name and what it is about, without the process that acted. */
  private static String text(TraceEvent.Action action) {
    StringBuilder text = new StringBuilder(action.name());
    for (Object argument : action.args()) {
      if (!(argument instanceof ProcessId)) {
        text.append(' ').append(argument);
      }
    }
    return text.toString();
  }

  private void instant(RobotId robot, String name, long timeNs, String text, Tone tone) {
    lane(robot, name, Kind.INSTANTS, 4).add(timeNs, text, 0, tone);
  }

  private Lane lane(RobotId robot, String name, Kind kind, int rank) {
    return robots
        .computeIfAbsent(robot, any -> new LinkedHashMap<>())
        .computeIfAbsent(name, any -> new Lane(kind, rank));
  }

  /** The robots that have a lane, sorted. */
  public List<RobotId> robots() {
    return List.copyOf(robots.keySet());
  }

  /** The number of robots that joined before this one; determines its colour. */
  int number(RobotId robot) {
    return numbers.getOrDefault(robot, 0);
  }

  /** The first words of the states painted so far, by the number of their colour. */
  List<String> words() {
    return List.copyOf(words.keySet());
  }

  /** The number of a state's colour: equal for texts with the same first word. */
  int colour(String text) {
    return words.computeIfAbsent(text.split(" ", 2)[0], any -> words.size());
  }

  /**
   * The lanes of a robot, by name: states and curves of its app, primitives, motion, and instants.
   */
  Map<String, Lane> of(RobotId robot) {
    Map<String, Lane> sorted = new LinkedHashMap<>();
    robots.getOrDefault(robot, Map.of()).entrySet().stream()
        .filter(entry -> entry.getValue().rank != MOTION || entry.getValue().changes.size() > 1)
        .sorted(Comparator.comparingInt(entry -> entry.getValue().rank))
        .forEach(entry -> sorted.put(entry.getKey(), entry.getValue()));
    return sorted;
  }
}
