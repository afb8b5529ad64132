package org.starl.primitives.agreement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodRobot.Packet;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSearch.Steps;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;

/**
 * The states of robots that run a protocol over a Synod.
 *
 * @param <R> the robots
 */
public abstract class SynodModel<R extends SynodRobot<?>> extends RobotModel<R> {

  private static final int MOST_ROBOTS = 5;

  /**
   * @param bounds the number of each bound of the {@link #space}, by name
   */
  protected SynodModel(ToIntFunction<String> bounds) {
    super(bounds);
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

  /** Whether a robot may crash, so that it makes a difference when a write is flushed. */
  protected final boolean mayCrash() {
    return bound("crashes") > 0;
  }

  /** The ids of the robots' first starts. */
  protected final SortedSet<ProcessId> first() {
    SortedSet<ProcessId> ids = new TreeSet<>();
    for (int i = 0; i < size(); i++) {
      ids.add(ProcessId.first(SynodRobot.robot(i), 1));
    }
    return ids;
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
  public final void receive(R robot, Packet packet) {
    robot.receive(packet);
  }

  @Override
  public final boolean isSpent(R recipient, Packet packet) {
    return recipient.isSpent(packet.content());
  }

  @Override
  public final void addSteps(int i, List<R> all, String none, Steps<R, String> steps) {
    R robot = all.get(i);
    RobotId name = robot.name;
    if (isCaller(i)) {
      addCalls(
          robot,
          (call, action) ->
              steps.add(name + " " + call, r -> r.call(() -> action.accept(r)), none));
    }
    if (sum(all, SynodRobot::timers) < bound("timers")) {
      steps.add(name + "'s timers", r -> r.timer(false), none);
      if (robot.hasDeadline()) {
        steps.add(name + "'s deadline", r -> r.timer(true), none);
      }
    }
    if (robot.mayFlush()) {
      steps.add(name + " flushes", SynodRobot::flush, none);
    }
    if (mayRestart(all, SynodRobot::starts)) {
      steps.add(name + " restarts", SynodRobot::start, none);
    }
  }
}
