package org.starl.primitives.agreement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodRobot.Packet;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Model;
import org.starl.primitives.exhaustive.StateSearch.Steps;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.spec.Monitor.Report;
import org.starl.spec.SpecReport;

/**
 * The states of robots that run a protocol over a Synod. Nothing outside the robots has a state.
 *
 * @param <R> the robots
 */
public abstract class SynodModel<R extends SynodRobot<?>> implements Model<R, Packet, String> {

  private static final int MOST_ROBOTS = 5;

  private final int robots;
  private final int crashes;
  private final int timers;
  private final int callers;

  /**
   * @param bounds the number of each bound of the {@link #space}, by name
   */
  protected SynodModel(ToIntFunction<String> bounds) {
    robots = bounds.applyAsInt("robots");
    crashes = bounds.applyAsInt("crashes");
    timers = bounds.applyAsInt("timers");
    callers = bounds.applyAsInt("callers");
  }

  /** The states of one protocol, with {@code more} bounds beside those of all. */
  protected static StateSpace space(
      String name,
      String goal,
      Function<ToIntFunction<String>, SynodModel<?>> model,
      Bound... more) {
    List<Bound> bounds = new ArrayList<>();
    bounds.add(new Bound("robots", "robots", 1, 2, MOST_ROBOTS));
    bounds.add(new Bound("crashes", "crashes, each with a restart", 0, 0, MOST_ROBOTS));
    bounds.add(new Bound("timers", "times that timers of a robot are due", 0, 0, MOST_ROBOTS));
    bounds.add(new Bound("callers", "robots that call it; 0: all", 0, 0, MOST_ROBOTS));
    bounds.addAll(Arrays.asList(more));
    return new StateSpace(name, goal, bounds, given -> new StateSearch<>(model.apply(given)));
  }

  /** Robot {@code i}, not started. */
  protected abstract R create(int i, Consumer<Packet> net);

  /** Adds what the program of {@code robot} may call now. */
  protected abstract void addCalls(R robot, BiConsumer<String, Consumer<R>> calls);

  /** Reports which invariants are violated. */
  protected abstract void check(List<R> all, Report report);

  /** Whether a robot may crash, so that it makes a difference when a write is flushed. */
  protected final boolean mayCrash() {
    return crashes > 0;
  }

  /** The robots' names. */
  protected final Participants names() {
    return Participants.of(ProcessId.robots(first()));
  }

  /** The ids of the robots' first starts. */
  protected final SortedSet<ProcessId> first() {
    SortedSet<ProcessId> ids = new TreeSet<>();
    for (int i = 0; i < robots; i++) {
      ids.add(ProcessId.first(SynodRobot.robot(i), 1));
    }
    return ids;
  }

  @Override
  public final int size() {
    return robots;
  }

  @Override
  public final R make(int i, Consumer<Packet> net) {
    R robot = create(i, net);
    robot.start();
    return robot;
  }

  @Override
  public final String text(R robot) {
    return robot.text();
  }

  @Override
  public final int to(Packet packet) {
    return packet.to();
  }

  @Override
  public final void receive(R robot, Packet packet) {
    robot.receive(packet);
  }

  @Override
  public final boolean isSpent(R recipient, Packet packet) {
    return recipient.isSpent(packet.content());
  }

  @Override
  public final String begin() {
    return "";
  }

  @Override
  public final void addSteps(int i, List<R> all, String none, Steps<R, String> steps) {
    R robot = all.get(i);
    RobotId name = robot.name;
    if (callers == 0 || i < callers) {
      addCalls(
          robot,
          (call, action) ->
              steps.add(name + " " + call, r -> r.call(() -> action.accept(r)), none));
    }
    if (sum(all, SynodRobot::timers) < timers) {
      steps.add(name + "'s timers", r -> r.timer(false), none);
      if (robot.hasDeadline()) {
        steps.add(name + "'s deadline", r -> r.timer(true), none);
      }
    }
    if (robot.mayFlush()) {
      steps.add(name + " flushes", SynodRobot::flush, none);
    }
    if (sum(all, SynodRobot::starts) < robots + crashes) {
      steps.add(name + " restarts", SynodRobot::start, none);
    }
  }

  private static <R> int sum(List<R> all, ToIntFunction<R> count) {
    return all.stream().mapToInt(count).sum();
  }

  @Override
  public final Optional<String> violation(List<R> all, String none) {
    SpecReport report = new SpecReport();
    check(all, report);
    return report.violations().stream()
        .findFirst()
        .map(each -> each.lemma() + ": " + each.detail());
  }
}
