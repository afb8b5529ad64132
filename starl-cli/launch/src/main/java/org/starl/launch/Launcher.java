// Longer than 500 lines because the processes, their kills and the result of a run share its state.
package org.starl.launch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.gvh.Wait;
import org.starl.id.RobotId;
import org.starl.input.FailureText;
import org.starl.launch.LaunchResult.Death;
import org.starl.platform.LogSink.Level;
import org.starl.robot.DeployedRobot;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.trace.ProcessFact;
import org.starl.sim.Diagnosis;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimulationPlan;
import org.starl.sim.UnfinishedRobot;
import org.starl.sim.net.NetStatistics;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Vocabulary;

/** Runs each robot of a plan as a process, once. Every process ends with {@link #close} or the JVM. */
public final class Launcher implements AutoCloseable {

  /** Least distance of a new body from other centres, in radii: the gap is one radius. */
  static final double ROOM_IN_RADII = 3;

  private static final long POLL_MS = 20;
  private static final Duration START_LIMIT = Duration.ofMinutes(2);
  private static final Duration END_LIMIT = Duration.ofSeconds(10);

  private final SimulationPlan plan;
  private final LaunchSettings settings;
  private final Vocabulary vocabulary;
  private final Consumer<String> console;
  private final Path folder;
  private final BlockingQueue<Runnable> tasks = new LinkedBlockingQueue<>();
  private final SortedMap<RobotId, Robot> robots = new TreeMap<>();
  private final Bodies bodies = new Bodies();
  private final List<Robot> waitingForPlace = new ArrayList<>();
  private final List<Death> deaths = new ArrayList<>();
  private final List<String> errors = new ArrayList<>();
  private final Map<Kill, Long> killsDue = new TreeMap<>(Comparator.comparing(Kill::toString));
  private final Thread hook = new Thread(this::removeAll, "launcher's end");
  private long originNs;
  private boolean isRunning;
  private boolean isEnding;
  private Consumer<TraceEvent> live = event -> {};
  // The values and actions since the last death, and the time of the last new one.
  private final Set<String> progress = new TreeSet<>();
  private long lastProgressNs;

  /**
   * Starts the processes.
   *
   * @param command starts a robot's process when the robot's name, folder and rounds are appended;
   *     the process calls {@link RobotProcess#run} with an equal plan
   * @param vocabulary the shapes of the values in the robots' traces
   * @param console receives log lines
   * @throws IOException if a process cannot be started, or a folder cannot be made
   */
  public Launcher(
      SimulationPlan plan,
      List<String> command,
      Vocabulary vocabulary,
      LaunchSettings settings,
      Consumer<String> console)
      throws IOException {
    this.plan = plan;
    this.vocabulary = vocabulary.and(DeployedRobot.VOCABULARY);
    this.settings = settings;
    this.console = console;
    folder = Files.createTempDirectory("starl-processes");
    Runtime.getRuntime().addShutdownHook(hook);
    try {
      for (RobotSpec spec : plan.robots()) {
        robots.put(spec.id(), new Robot(spec, command));
      }
    } catch (IOException e) {
      close();
      throw e;
    }
  }

  /** Shows the robots' events while they come; to be called before {@link #run}. */
  public void show(Consumer<TraceEvent> observer) {
    live = observer;
  }

  /**
   * Runs until every app has come to its end in all rounds, or the time is over.
   *
   * @throws IllegalStateException if a process does not start in time, or has another clock
   */
  public LaunchResult run() {
    long startNs = RealClock.machineNs();
    while (!isOver()) {
      runNextTask();
      if (isRunning) {
        waitingForPlace.removeIf(Robot::placeIfFree);
        killWhenDue();
      } else if (RealClock.machineNs() - startNs > START_LIMIT.toNanos()) {
        throw new IllegalStateException(
            "processes did not start in time: "
                + robots.values().stream().filter(robot -> robot.port == 0).toList());
      }
    }
    end();
    return result();
  }

  private void runNextTask() {
    try {
      Runnable task = tasks.poll(POLL_MS, TimeUnit.MILLISECONDS);
      if (task != null) {
        task.run();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted", e);
    }
  }

  private long nowNs() {
    return RealClock.machineNs() - originNs;
  }

  private boolean all(Predicate<Robot> condition) {
    return robots.values().stream().allMatch(condition);
  }

  private boolean isOver() {
    boolean isQuiet = !deaths.isEmpty() && nowNs() - lastProgressNs > settings.quiet().toNanos();
    return !errors.isEmpty()
        || all(robot -> robot.isGone || robot.hasFinished())
        || (isRunning && (isQuiet || nowNs() > settings.limit().toNanos()));
  }

  private void begin() {
    if (originNs == 0 && all(robot -> robot.isUp)) {
      originNs = RealClock.machineNs();
      robots.values().forEach(robot -> robot.process.send(new ParentCommand.Begin(originNs)));
    }
  }

  private void go() {
    if (!all(robot -> robot.port != 0)) {
      return;
    }
    SortedMap<RobotId, Integer> ports = new TreeMap<>();
    robots.forEach((id, robot) -> ports.put(id, robot.port));
    robots.values().forEach(robot -> robot.process.send(new ParentCommand.Go(ports)));
    isRunning = true;
    for (Kill kill : settings.kills()) {
      if (kill.variable() == null) {
        killsDue.put(kill, kill.afterNs());
      }
    }
  }

  private void killWhenDue() {
    long nowNs = nowNs();
    killsDue.forEach((kill, dueNs) -> {
      Robot robot = robots.get(kill.robot());
      if (robot != null && robot.killedNs < 0 && !robot.isGone && dueNs <= nowNs) {
        robot.killedNs = nowNs;
        robot.process.kill();
      }
    });
  }

  private void end() {
    isEnding = true;
    robots.values().forEach(robot -> robot.process.end());
    long startNs = RealClock.machineNs();
    while (!all(robot -> robot.isGone)) {
      runNextTask();
      if (RealClock.machineNs() - startNs > END_LIMIT.toNanos()) {
        robots.values().forEach(robot -> robot.process.kill());
      }
    }
  }

  private LaunchResult result() {
    List<RecordedTrace> traces = robots.values().stream().map(Robot::trace).toList();
    SortedMap<RobotId, Integer> rounds = new TreeMap<>();
    robots.forEach((id, robot) -> rounds.put(id, robot.rounds));
    TraceMerge.Result merged =
        new TraceMerge(traces, 0, 0).judge(plan, plan.observers(), this::complete);
    long pauseNs =
        robots.values().stream().mapToLong(robot -> robot.longestPauseNs).max().orElse(0);
    return new LaunchResult(merged.run(), rounds, deaths, errors, pauseNs);
  }

  private SimResult complete(SimResult run) {
    SortedMap<RobotId, List<Object>> results = new TreeMap<>();
    List<RobotId> unfinished = new ArrayList<>();
    robots.forEach((id, robot) -> {
      if (robot.hasFinished() && robot.results != null) {
        results.put(id, robot.results);
      } else if (deaths.stream().noneMatch(death -> death.robot().equals(id))) {
        unfinished.add(id);
      }
    });
    long copies =
        robots.values().stream().mapToLong(robot -> robot.earlierCopies + robot.copies).sum();
    long lost = robots.values().stream().mapToLong(robot -> robot.earlierLost + robot.lost).sum();
    return new SimResult(
        run.seed(),
        run.behaviourSeed(),
        run.endNs(),
        run.events(),
        results,
        unfinished,
        new NetStatistics(run.network().sent(), run.network().sentBytes(), copies - lost, lost),
        run.collisions(),
        run.spec(),
        diagnosis(unfinished, run.endNs()),
        run.diagnoses(),
        run.faults(),
        run.failure());
  }

  private Diagnosis diagnosis(List<RobotId> unfinished, long endNs) {
    SortedMap<RobotId, List<Wait>> waits = new TreeMap<>();
    long changedNs = -1;
    for (RobotId id : unfinished) {
      Robot robot = Objects.requireNonNull(robots.get(id));
      waits.put(id, robot.waits);
      changedNs = Math.max(changedNs, robot.changedNs);
    }
    Set<RobotId> down = new TreeSet<>();
    deaths.forEach(death -> down.add(death.robot()));
    return Diagnosis.of(
        new Diagnosis.Moment(
            endNs,
            false,
            changedNs,
            waits,
            down,
            List.of(),
            id -> Objects.requireNonNull(robots.get(id)).explain()));
  }

  /** Ends every process, and deletes their files. */
  @Override
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      console.accept("stopped"); // the JVM ends, and its hook does the work
      return;
    }
    removeAll();
  }

  private void removeAll() {
    robots.values().forEach(robot -> robot.process.kill());
    robots.values().forEach(robot -> robot.process.awaitEnd());
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(file);
      }
    } catch (IOException e) {
      console.accept(folder + " was not deleted: " + FailureText.of(e));
    }
  }

  /** A robot and its process, in the parent. */
  private final class Robot implements ChildProcess.Listener {
    private final RobotSpec spec;
    private final RobotId id;
    private final ChildProcess process;
    private final List<TraceEvent> events = new ArrayList<>();
    private boolean isUp;
    private int port;
    private int rounds;
    private @Nullable List<Object> results;
    private boolean isGone;
    private boolean isComplete;
    private long killedNs = -1;
    private long lastNs;
    private boolean isPlaceGranted;
    private long copies;
    private long lost;
    private long earlierCopies;
    private long earlierLost;
    private long longestPauseNs;

    // Of an app that has not ended.
    private String awaited = "";
    private final List<Wait> waits = new ArrayList<>();
    private long changedNs = -1;

    Robot(RobotSpec spec, List<String> command) throws IOException {
      this.spec = spec;
      id = spec.id();
      List<String> words = new ArrayList<>(command);
      words.add(id.name());
      words.add(folder.resolve(id.name()).toString());
      words.add(Integer.toString(settings.rounds()));
      process = new ChildProcess(id.name(), words, vocabulary, tasks::add, this);
      console.accept(id + " is process " + process.pid());
    }

    boolean hasFinished() {
      return rounds == settings.rounds();
    }

    @Override
    public void warned(String line) {
      console.accept(id + ": " + line);
    }

    @Override
    public void traced(TraceEvent event, long seenNs) {
      if (event instanceof Action action && action.fact() instanceof ProcessFact fact) {
        received(action, fact, seenNs);
        return;
      }
      lastNs = Math.max(lastNs, event.timeNs());
      add(event);
      if (event instanceof Variable) {
        changedNs = event.timeNs();
      }
      if (event instanceof Joined) {
        isPlaceGranted = false;
      }
      if (isProgress(event)) {
        lastProgressNs = nowNs();
      }
      for (Kill kill : settings.kills()) {
        if (!killsDue.containsKey(kill) && kill.isTriggeredBy(event)) {
          killsDue.put(kill, event.timeNs() + kill.afterNs());
        }
      }
    }

    private void add(TraceEvent event) {
      events.add(event);
      bodies.observe(event);
      live.accept(event);
    }

    /** A value or action that is new since the last death; repeated attempts are no progress. */
    private boolean isProgress(TraceEvent event) {
      return switch (event) {
        case Variable variable -> progress.add(variable.at(0).toString());
        case Action action when action.source().xid().isEmpty() ->
            progress.add(action.at(0).toString());
        default -> false;
      };
    }

    private void received(Action action, ProcessFact fact, long seenNs) {
      switch (fact) {
        case ProcessFact.Hello hello -> {
          isUp = true;
          begin();
        }
        case ProcessFact.Port its -> {
          checkClock(action.timeNs(), seenNs - originNs);
          port = its.port();
          go();
        }
        case ProcessFact.WantsPlace wish -> waitingForPlace.add(this);
        case ProcessFact.Alive alive -> {
          lastNs = Math.max(lastNs, action.timeNs());
          live.accept(action);
          count(alive.copies(), alive.lost());
          longestPauseNs = Math.max(longestPauseNs, alive.longestPauseNs());
        }
        case ProcessFact.Finished finished -> {
          rounds++;
          results = List.copyOf(finished.results());
        }
        case ProcessFact.Waits told -> {
          awaited = told.awaited();
          waits.clear();
          waits.addAll(told.waits());
        }
        case ProcessFact.Log log -> {
          if (log.level().compareTo(Level.WARN) >= 0) {
            warned(log.tag() + ": " + log.line());
          }
        }
        case ProcessFact.Failed error -> errors.add(id + ": " + error.stackTrace().strip());
        case ProcessFact.Clock clock -> {
          // All processes use this machine's clock; the port's message has checked that.
        }
      }
    }

    UnfinishedRobot explain() {
      return new UnfinishedRobot(
          id, "", false, 0, awaited, changedNs, List.of(), waits, "", List.of());
    }

    /** Each start of the program begins its counts at 0. */
    private void count(long newCopies, long newLost) {
      if (newCopies < copies) {
        earlierCopies += copies;
        earlierLost += lost;
      }
      copies = newCopies;
      lost = newLost;
    }

    /** The child's time must lie between the parent's command and the receipt of the answer. */
    private void checkClock(long childNs, long parentNs) {
      if (childNs < 0 || childNs > parentNs) {
        throw new IllegalStateException(
            id
                + "'s clock shows "
                + childNs
                + " ns where the parent's shows "
                + parentNs
                + ": expected one monotonic clock for all processes of this machine");
      }
    }

    boolean placeIfFree() {
      Point place = spec.start().at();
      double apartMm = ROOM_IN_RADII * plan.settings().robotRadiusMm();
      boolean isTaken =
          bodies.robots().stream()
                  .anyMatch(other -> bodies.poseAt(other, nowNs()).distanceMm(place) < apartMm)
              || robots.values().stream()
                  .anyMatch(other ->
                      other.isPlaceGranted && other.spec.start().distanceMm(place) < apartMm);
      if (!isTaken) {
        isPlaceGranted = true;
        process.send(new ParentCommand.Place());
      }
      return !isTaken;
    }

    @Override
    public void ended(boolean hasEnd, int status) {
      isGone = true;
      isPlaceGranted = false;
      waitingForPlace.remove(this);
      isComplete = isEnding && hasEnd;
      if (isComplete) {
        return;
      }
      lastNs = Math.max(lastNs, killedNs);
      Death death = new Death(id, process.pid(), lastNs, killedNs >= 0, status);
      deaths.add(death);
      live.accept(new TraceEvent.Fault(lastNs, id, TraceEvent.Fault.CRASH, ""));
      progress.clear();
      lastProgressNs = isRunning ? nowNs() : 0;
      if (bodies.isOnFloor(id)) {
        add(new Moved(lastNs, id, bodies.poseAt(id, lastNs), 0, 0));
      }
      if (!errors.isEmpty()) {
        return;
      }
      if (!death.isKill()) {
        errors.add(id + ": its process ended by itself, with status " + status);
      } else if (!isRunning) {
        errors.add(id + ": its process was killed before the run began");
      } else if (isEnding && !death.isPlanned()) {
        errors.add(id + ": its process did not end on request");
      }
    }

    /** All processes have the clock of this machine, from the same origin. */
    RecordedTrace trace() {
      return new RecordedTrace(
          id.name(), id, "this", 0, 0, plan.header(), events, lastNs, isComplete, true);
    }

    @Override
    public String toString() {
      return id.name();
    }
  }
}
