package org.starl.sim;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import org.starl.gvh.Wait;
import org.starl.id.RobotId;
import org.starl.time.Time;

/**
 * Why a run has not finished, as far as its state at one moment shows.
 *
 * @param kind what the robots can still do
 * @param cause the likely cause, in one line; empty if the run has finished, or none was looked for
 * @param graph which robot waits for which
 * @param robots at most {@link #MAX_EXPLAINED} unfinished robots: the important ones, then others
 * @param others the number of the other unfinished robots
 * @param down robots that had crashed
 */
public record Diagnosis(
    Kind kind,
    String cause,
    WaitGraph graph,
    List<UnfinishedRobot> robots,
    int others,
    Set<RobotId> down) {

  /** The largest number of robots that a diagnosis explains. */
  public static final int MAX_EXPLAINED = 20;

  /** A run of which nothing is known, or that has finished. */
  public static final Diagnosis NONE =
      new Diagnosis(Kind.FINISHED, "", new WaitGraph(new TreeMap<>()), List.of(), 0, Set.of());

  /** Without a change for this long, a run counts as stuck. */
  private static final long STUCK_NS = 10_000_000_000L;

  private static final int MAX_NAMES = 10;

  /** What the robots can still do. */
  public enum Kind {
    /** Not asked: the robots of a violation, at that time. */
    VIOLATED,
    /** Every app has ended, or nothing is known. */
    FINISHED,
    /** No event is left: no robot can ever go on. */
    NO_EVENT_LEFT,
    /** Robots wait for each other in a circle. */
    CIRCLE,
    /** Events are left, but no variable of an unfinished robot has changed for 10 s. */
    STUCK,
    /** Variables still change: the run is slow, or repeats itself for ever. */
    ACTIVE
  }

  /**
   * The unfinished robots at one moment.
   *
   * @param isIdle whether no event is left
   * @param changedNs when a variable of one of them last changed; -1 if the run did not record it
   * @param waits what each of them waits for, or holds
   * @param down robots that have crashed
   * @param important robots to explain in any case, if they are unfinished
   * @param explain the state of an unfinished robot
   */
  public record Moment(
      long nowNs,
      boolean isIdle,
      long changedNs,
      SortedMap<RobotId, List<Wait>> waits,
      Set<RobotId> down,
      List<RobotId> important,
      Function<RobotId, UnfinishedRobot> explain) {
    /** Of a run with these robots, in the order in which they joined. */
    static Moment of(
        long nowNs, boolean isIdle, Map<RobotId, SimRobot> robots, List<RobotId> important) {
      SortedMap<RobotId, List<Wait>> waits = new TreeMap<>();
      Set<RobotId> down = new TreeSet<>();
      long changedNs = -1;
      for (Map.Entry<RobotId, SimRobot> entry : robots.entrySet()) {
        SimRobot robot = entry.getValue();
        if (robot.isDown()) {
          down.add(entry.getKey());
        } else if (robot.isAwaited()) {
          waits.put(entry.getKey(), robot.waits());
          changedNs = Math.max(changedNs, robot.changedNs());
        }
      }
      return new Moment(
          nowNs,
          isIdle,
          changedNs,
          waits,
          down,
          important,
          id -> Objects.requireNonNull(robots.get(id)).explain());
    }
  }

  public Diagnosis {
    robots = List.copyOf(robots);
    down = Set.copyOf(down);
  }

  /** Without a cause: the robots of a violation that is no missed deadline. */
  static Diagnosis ofViolation(List<UnfinishedRobot> robots) {
    List<UnfinishedRobot> explained = robots.subList(0, Math.min(robots.size(), MAX_EXPLAINED));
    int others = robots.size() - explained.size();
    return new Diagnosis(Kind.VIOLATED, "", NONE.graph(), explained, others, Set.of());
  }

  public static Diagnosis of(Moment moment) {
    if (moment.waits().isEmpty()) {
      return NONE;
    }
    WaitGraph graph = graph(moment.waits());
    List<RobotId> circle = graph.circle();
    SortedSet<RobotId> explained = new TreeSet<>(circle.subList(0, Math.min(circle.size(), 10)));
    Kind kind = kind(moment, circle);
    String cause;
    if (circle.isEmpty()) {
      RobotId bottleneck = graph.bottleneck(moment.waits().firstKey());
      explained.add(bottleneck);
      cause = opening(kind, moment) + "; " + state(bottleneck, graph, moment);
    } else {
      List<RobotId> closed = new ArrayList<>(circle);
      closed.add(circle.get(0));
      cause = "deadlock: robots wait in a circle: " + String.join(" -> ", names(closed));
    }
    if (!moment.down().isEmpty()
        && moment.down().stream().allMatch(robot -> graph.waiters(robot) == 0)) {
      cause += "; crashed: " + text(moment.down());
    }
    explained.addAll(moment.important());
    explained.retainAll(moment.waits().keySet());
    for (RobotId robot : moment.waits().keySet()) {
      if (explained.size() < MAX_EXPLAINED) {
        explained.add(robot);
      }
    }
    List<UnfinishedRobot> robots = new ArrayList<>();
    explained.stream()
        .limit(MAX_EXPLAINED)
        .forEach(robot -> robots.add(moment.explain().apply(robot)));
    int others = moment.waits().size() - robots.size();
    return new Diagnosis(kind, cause, graph, robots, others, moment.down());
  }

  private static WaitGraph graph(SortedMap<RobotId, List<Wait>> waits) {
    SortedMap<RobotId, Set<RobotId>> graph = new TreeMap<>();
    waits.forEach((robot, all) -> {
      Set<RobotId> on = new TreeSet<>();
      all.forEach(wait -> on.addAll(wait.on()));
      graph.put(robot, on);
    });
    return new WaitGraph(graph);
  }

  private static Kind kind(Moment moment, List<RobotId> circle) {
    if (moment.isIdle()) {
      return Kind.NO_EVENT_LEFT;
    }
    if (!circle.isEmpty()) {
      return Kind.CIRCLE;
    }
    boolean isStuck = moment.changedNs() >= 0 && moment.nowNs() - moment.changedNs() >= STUCK_NS;
    return isStuck ? Kind.STUCK : Kind.ACTIVE;
  }

  private static String opening(Kind kind, Moment moment) {
    String changed = Time.text(moment.changedNs(), 3);
    if (kind == Kind.NO_EVENT_LEFT) {
      return "deadlock: no event is left, so no robot can go on";
    }
    if (kind == Kind.STUCK) {
      return "stuck: nothing has changed since " + changed;
    }
    return "slow or a livelock"
        + (moment.changedNs() < 0 ? "" : ": variables still changed at " + changed);
  }

  private static String state(RobotId robot, WaitGraph graph, Moment moment) {
    if (moment.waits().containsKey(robot) && !moment.down().contains(robot)) {
      return moment.explain().apply(robot).brief();
    }
    long waiters = graph.waiters(robot);
    return (waiters == 1 ? "1 robot waits for " : waiters + " robots wait for ")
        + robot
        + (moment.down().contains(robot) ? ", which has crashed" : ", whose app has ended");
  }

  private static List<String> names(Collection<RobotId> robots) {
    return robots.stream().map(RobotId::name).toList();
  }

  /**
   * The robots that the others wait for: those of a circle, or the last of a chain; at most ten.
   * Empty if no robot waits for another.
   */
  List<RobotId> culprits() {
    List<RobotId> circle = graph.circle();
    if (!circle.isEmpty() || graph.waits().isEmpty()) {
      return circle.subList(0, Math.min(circle.size(), MAX_NAMES));
    }
    return List.of(graph.bottleneck(graph.waits().firstKey()));
  }

  /** The whole diagnosis for people: the cause, the graph, each explained robot. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    if (!robots.isEmpty() && !cause.isEmpty()) {
      lines.add("likely cause: " + cause);
    }
    lines.addAll(details());
    return lines;
  }

  /** The graph and each explained robot: the diagnosis without its cause. */
  public List<String> details() {
    List<String> lines = new ArrayList<>();
    if (!robots.isEmpty()) {
      for (UnfinishedRobot robot : robots) {
        Set<RobotId> on = graph.of(robot.robot());
        if (!on.isEmpty()) {
          lines.add("  " + robot.robot() + " waits for " + text(on));
        }
      }
      robots.forEach(robot -> robot.lines().forEach(line -> lines.add("  " + line)));
    }
    if (others > 0) {
      lines.add("  and " + others + " more unfinished robot" + (others == 1 ? "" : "s"));
    }
    return lines;
  }

  /** {@code [bot0, bot1]}; of many robots the first and the number of the others. */
  static String text(Collection<RobotId> robots) {
    List<String> names = names(robots);
    return names.size() <= MAX_NAMES
        ? names.toString()
        : names.subList(0, MAX_NAMES) + " and " + (names.size() - MAX_NAMES) + " more";
  }
}
