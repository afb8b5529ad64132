package org.starl.processes;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.processes.FleetResult.Death;
import org.starl.processes.Member.Complained;
import org.starl.processes.Member.Did;
import org.starl.processes.Member.Gone;
import org.starl.processes.Member.Signal;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.trace.Word;
import org.starl.sim.Blueprint;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.net.NetStatistics;
import org.starl.sim.world.Collisions;
import org.starl.spec.Bodies;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/**
 * Runs each robot of a blueprint as a process of its own, once. None of them outlives {@link #close},
 * nor this process.
 */
public final class Fleet implements AutoCloseable {

  private static final long LOOK_EVERY_MS = 20;
  private static final long START_LIMIT_NS = 120_000_000_000L;
  private static final long END_LIMIT_NS = 10_000_000_000L;
  // Between two bodies' middles, one of which has made room for the other: a radius to spare.
  private static final double ROOM_IN_RADII = 3;

  private final Blueprint blueprint;
  private final List<String> command;
  private final FleetSettings settings;
  private final Consumer<String> teller;
  private final Path folder;
  private final BlockingQueue<Signal> signals = new LinkedBlockingQueue<>();
  private final SortedMap<RobotId, Robot> robots = new TreeMap<>();
  private final Bodies bodies = new Bodies();
  private final Merged merged = new Merged();
  private final List<RobotId> wantPlace = new ArrayList<>();
  private final List<Death> deaths = new ArrayList<>();
  private final List<String> errors = new ArrayList<>();
  private final Map<Kill, Long> killsDue = new TreeMap<>(Comparator.comparing(Kill::toString));
  private final Thread hook = new Thread(this::bury, "fleet's end");
  private long originNs;
  private boolean isBegun;
  private boolean isRunning;
  private boolean isEnding;
  private long lastNewsNs;
  // What the robots have told since the last death.
  private final Set<String> news = new TreeSet<>();

  /** What the parent knows of a robot. */
  private static final class Robot {
    private final RobotSpec spec;
    private final Member member;
    private boolean isThere;
    private int port;
    private int rounds;
    private @Nullable List<Object> results;
    private boolean isGone;
    private long killedNs = -1;
    private long lastNs;
    private boolean isPromisedPlace;
    private long copies;
    private long lost;
    private long earlierCopies;
    private long earlierLost;
    private long longestSilenceNs;

    Robot(RobotSpec spec, Member member) {
      this.spec = spec;
      this.member = member;
    }
  }

  /**
   * Starts the processes.
   *
   * @param command starts a robot's process, with its name, folder and rounds appended; it runs {@link
   *     RobotProcess#run} over an equal blueprint
   * @param teller takes lines for people, as things happen
   * @throws IOException if no process can be started, or no folder made
   */
  public Fleet(
      Blueprint blueprint, List<String> command, FleetSettings settings, Consumer<String> teller)
      throws IOException {
    this.blueprint = blueprint;
    this.command = List.copyOf(command);
    this.settings = settings;
    this.teller = teller;
    folder = Files.createTempDirectory("starl-processes");
    Runtime.getRuntime().addShutdownHook(hook);
    try {
      for (RobotSpec spec : blueprint.robots()) {
        robots.put(spec.id(), new Robot(spec, start(spec.id())));
      }
    } catch (IOException e) {
      close();
      throw e;
    }
  }

  private Member start(RobotId id) throws IOException {
    List<String> words = new ArrayList<>(command);
    words.add(id.name());
    words.add(folder.resolve(id.name()).toString());
    words.add(Integer.toString(settings.rounds()));
    Member member = Member.start(id, words, signals);
    teller.accept(id + " is process " + member.pid());
    return member;
  }

  /**
   * Runs until every app has ended as often as it shall, or the time is over.
   *
   * @throws IllegalStateException if a process does not come up, or its clock is another
   */
  public FleetResult run() {
    long startNs = RealClock.machineNs();
    while (!isOver()) {
      Signal signal = await();
      if (signal != null) {
        take(signal);
      }
      if (isRunning) {
        givePlaces();
        kill();
      } else if (RealClock.machineNs() - startNs > START_LIMIT_NS) {
        throw new IllegalStateException("the processes did not come up in time: " + notThere());
      }
    }
    end();
    return result();
  }

  private List<RobotId> notThere() {
    return robots.values().stream()
        .filter(robot -> robot.port == 0)
        .map(robot -> robot.spec.id())
        .toList();
  }

  private @Nullable Signal await() {
    try {
      return signals.poll(LOOK_EVERY_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted", e);
    }
  }

  private long nowNs() {
    return RealClock.machineNs() - originNs;
  }

  private boolean isOver() {
    if (robots.values().stream().allMatch(robot -> robot.isGone || isThrough(robot))) {
      return true;
    }
    boolean isQuiet = !deaths.isEmpty() && nowNs() - lastNewsNs > settings.quiet().toNanos();
    return !errors.isEmpty() || (isRunning && (isQuiet || nowNs() > settings.limit().toNanos()));
  }

  private boolean isThrough(Robot robot) {
    return robot.rounds == settings.rounds();
  }

  private void take(Signal signal) {
    Robot robot = robots.get(signal.robot());
    if (robot == null) {
      throw new IllegalStateException("a stranger: " + signal);
    }
    switch (signal) {
      case Did did when Word.isOne(did.event()) -> heard(robot, did);
      case Did did -> happened(robot, did.event());
      case Complained complaint -> teller.accept(complaint.robot() + ": " + complaint.line());
      case Gone gone -> gone(robot, gone);
    }
  }

  private void happened(Robot robot, TraceEvent event) {
    robot.lastNs = Math.max(robot.lastNs, event.timeNs());
    merged.add(event);
    bodies.observe(event);
    if (event instanceof Joined) {
      robot.isPromisedPlace = false;
    }
    if (isNews(event)) {
      lastNewsNs = nowNs();
    }
    for (Kill kill : settings.kills()) {
      if (!killsDue.containsKey(kill) && kill.isTriggeredBy(event)) {
        killsDue.put(kill, event.timeNs() + kill.afterNs());
      }
    }
  }

  /** Whether a robot has come where it was not before: who only tries again and again tells none. */
  private boolean isNews(TraceEvent event) {
    return switch (event) {
      case Variable variable ->
          news.add(
              variable.robot()
                  + " "
                  + variable.source()
                  + " "
                  + variable.name()
                  + " "
                  + variable.value());
      case Action action when action.source().indexOf('/') < 0 ->
          news.add(
              action.robot() + " " + action.source() + " " + action.name() + " " + action.args());
      default -> false;
    };
  }

  private void heard(Robot robot, Did did) {
    Action action = (Action) did.event();
    List<String> args = action.args();
    switch (Word.valueOf(action.name())) {
      case HELLO -> {
        robot.isThere = true;
        if (robots.values().stream().allMatch(each -> each.isThere)) {
          begin();
        }
      }
      case PORT -> {
        checkClock(robot, did);
        robot.port = Integer.parseInt(args.get(0));
        if (robots.values().stream().allMatch(each -> each.port != 0)) {
          go();
        }
      }
      case WANTS_PLACE -> wantPlace.add(robot.spec.id());
      case ALIVE -> {
        robot.lastNs = Math.max(robot.lastNs, action.timeNs());
        alive(robot, args);
      }
      case FINISHED -> {
        robot.rounds++;
        robot.results = List.copyOf(args);
      }
      case LOG -> {
        if (args.get(0).equals("WARN") || args.get(0).equals("ERROR")) {
          teller.accept(robot.spec.id() + ": " + args.get(1) + ": " + args.get(2));
        }
      }
      case ERROR -> errors.add(robot.spec.id() + ": " + args.get(0).strip());
      case CLOCK -> {
        // Here all have the clock of one machine, which they tell with their port.
      }
    }
  }

  // Each start of the program counts from 0.
  private static void alive(Robot robot, List<String> args) {
    long copies = Long.parseLong(args.get(0));
    if (copies < robot.copies) {
      robot.earlierCopies += robot.copies;
      robot.earlierLost += robot.lost;
    }
    robot.copies = copies;
    robot.lost = Long.parseLong(args.get(1));
    robot.longestSilenceNs = Math.max(robot.longestSilenceNs, Long.parseLong(args.get(2)));
  }

  private void begin() {
    if (!isBegun) {
      isBegun = true;
      originNs = RealClock.machineNs();
      robots.values().forEach(robot -> robot.member.tell(new Order.Begin(originNs)));
    }
  }

  // Between the parent's order and the parent's reading lies the child's own account of it.
  private void checkClock(Robot robot, Did did) {
    long atNs = did.event().timeNs();
    if (atNs < 0 || atNs > did.seenNs() - originNs) {
      throw new IllegalStateException(
          robot.spec.id()
              + "'s clock shows "
              + atNs
              + " ns where the parent's shows "
              + (did.seenNs() - originNs)
              + ": expected one monotonic clock for all processes of this machine");
    }
  }

  private void go() {
    for (Robot robot : robots.values()) {
      for (Robot other : robots.values()) {
        if (other != robot) {
          robot.member.tell(new Order.Peer(other.spec.id(), other.port));
        }
      }
      robot.member.tell(new Order.Go());
    }
    isRunning = true;
    for (Kill kill : settings.kills()) {
      if (kill.variable() == null) {
        killsDue.put(kill, kill.afterNs());
      }
    }
  }

  private void givePlaces() {
    wantPlace.removeIf(id -> {
      Robot robot = robots.get(id);
      if (robot == null || !hasRoom(robot.spec)) {
        return false;
      }
      robot.isPromisedPlace = true;
      robot.member.tell(new Order.Place());
      return true;
    });
  }

  private boolean hasRoom(RobotSpec spec) {
    Point place = spec.start().at();
    double apartMm = ROOM_IN_RADII * blueprint.settings().robotRadiusMm();
    for (RobotId other : bodies.robots()) {
      if (bodies.poseAt(other, nowNs()).distanceMm(place) < apartMm) {
        return false;
      }
    }
    return robots.values().stream()
        .noneMatch(
            other -> other.isPromisedPlace && other.spec.start().distanceMm(place) < apartMm);
  }

  private void kill() {
    long nowNs = nowNs();
    killsDue.forEach((kill, dueNs) -> {
      Robot robot = robots.get(kill.who());
      if (robot != null && robot.killedNs < 0 && !robot.isGone && dueNs <= nowNs) {
        robot.killedNs = nowNs;
        robot.member.kill();
      }
    });
  }

  private void gone(Robot robot, Gone gone) {
    robot.isGone = true;
    robot.isPromisedPlace = false;
    RobotId id = robot.spec.id();
    wantPlace.remove(id);
    if (isEnding && gone.isWhole()) {
      return;
    }
    boolean wasAsked = robot.killedNs >= 0;
    long atNs = Math.max(robot.lastNs, robot.killedNs);
    Death death = new Death(id, robot.member.pid(), atNs, wasAsked, gone.status());
    deaths.add(death);
    news.clear();
    lastNewsNs = isRunning ? nowNs() : 0;
    if (bodies.isOnFloor(id)) {
      Moved stop = new Moved(atNs, id, bodies.poseAt(id, atNs), 0, 0);
      merged.add(stop);
      bodies.observe(stop);
    }
    merged.add(new Fault(atNs, id, Fault.CRASH, ""));
    if (errors.isEmpty()) {
      if (!death.wasKilled()) {
        errors.add(id + ": its process ended by itself, with status " + gone.status());
      } else if (!isRunning) {
        errors.add(id + ": its process was killed before the run began");
      } else if (isEnding && !wasAsked) {
        errors.add(id + ": its process did not end when it was told to");
      }
    }
  }

  private void end() {
    isEnding = true;
    robots.values().forEach(robot -> robot.member.dismiss());
    long startNs = RealClock.machineNs();
    while (robots.values().stream().anyMatch(robot -> !robot.isGone)) {
      Signal signal = await();
      if (signal != null) {
        take(signal);
      }
      if (RealClock.machineNs() - startNs > END_LIMIT_NS) {
        killAll();
      }
    }
  }

  private FleetResult result() {
    long endNs = robots.values().stream().mapToLong(robot -> robot.lastNs).max().orElse(0);
    SpecReport spec = merged.show(blueprint, endNs);
    SortedMap<RobotId, List<Object>> results = new TreeMap<>();
    SortedMap<RobotId, Integer> rounds = new TreeMap<>();
    List<RobotId> unfinished = new ArrayList<>();
    long copies = 0;
    long lost = 0;
    long silenceNs = 0;
    for (Map.Entry<RobotId, Robot> entry : robots.entrySet()) {
      Robot robot = entry.getValue();
      rounds.put(entry.getKey(), robot.rounds);
      copies += robot.earlierCopies + robot.copies;
      lost += robot.earlierLost + robot.lost;
      silenceNs = Math.max(silenceNs, robot.longestSilenceNs);
      if (isThrough(robot) && robot.results != null) {
        results.put(entry.getKey(), robot.results);
      } else if (deaths.stream().noneMatch(death -> death.robot().equals(entry.getKey()))) {
        unfinished.add(entry.getKey());
      }
    }
    SimResult run =
        new SimResult(
            blueprint.header().scenarioSeed(),
            blueprint.header().behaviourSeed(),
            endNs,
            merged.size(),
            results,
            unfinished,
            new NetStatistics(merged.datagrams(), merged.bytes(), copies - lost, lost),
            // Each body is alone in its process.
            Collisions.NONE,
            spec);
    blueprint.observers().forEach(observer -> observer.finished(run));
    return new FleetResult(run, rounds, deaths, errors, silenceNs);
  }

  private void killAll() {
    robots.values().forEach(robot -> robot.member.kill());
  }

  /** Ends every process, and removes what they stored. */
  @Override
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      teller.accept("stopped"); // this process ends: the hook does the work
      return;
    }
    bury();
  }

  private void bury() {
    killAll();
    robots.values().forEach(robot -> robot.member.bury());
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(file);
      }
    } catch (IOException e) {
      teller.accept(folder + " is left: " + e);
    }
  }
}
