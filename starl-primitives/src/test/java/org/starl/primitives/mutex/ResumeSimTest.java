package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.registration.Registration;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.sim.world.Unsynced;

/** A program that restarts in the middle of its sequence, while another waits for its body. */
class ResumeSimTest {

  private static final long S = 1_000_000_000;
  private static final String XID = "crossing";
  private static final RobotId FIRST = new RobotId("first");
  private static final RobotId SECOND = new RobotId("second");
  private static final RobotId THIRD = new RobotId("third");
  private static final Participants ROADSIDE =
      Participants.of(new RobotId("post0"), new RobotId("post1"), new RobotId("post2"));

  @Test
  void theWayAheadOfARestartedRobotIsNotGivenToOneThatWaitsForItsBody() {
    finishes(
        new Plan(0, List.of("A", "B"), Set.of("A", "B"), "A"),
        new Plan(3_000, List.of("C", "B", "A"), Set.of("C", "B", "A"), "C"),
        control -> control.crash(FIRST, S, Unsynced.KEPT));
  }

  @Test
  void aRestartedRobotGivesTheWayAheadToOneThatStandsThere() {
    finishes(
        new Plan(3_000, List.of("A", "C"), Set.of("A"), "A"),
        new Plan(0, List.of("C", "D"), Set.of("C", "D"), "C"),
        control -> {
          control.crash(FIRST, S, Unsynced.KEPT);
          control.crash(SECOND, S, Unsynced.KEPT);
        });
  }

  @Test
  void aRestartedRobotLeavesWhereItStandsBeforeItHasItsWholeWay() {
    Plan first = new Plan(0, List.of("A", "B", "C"), Set.of("A"), "A");
    Plan second = new Plan(0, List.of("C", "A"), Set.of("C"), "C");
    finishes(
        Map.of(FIRST, gvh -> new Leaver(gvh, first), SECOND, gvh -> new Leaver(gvh, second)),
        control -> {
          control.crash(FIRST, S, Unsynced.KEPT);
          control.crash(SECOND, 10 * S, Unsynced.KEPT); // until then the first one holds no more
        });
  }

  @Test
  void aRestartedRobotThatWaitsForABodyLetsTheOnesAheadOfThatBodyGoFirst() {
    Plan first = new Plan(2_000, List.of("A", "B", "D"), Set.of("A"), "A");
    Plan second = new Plan(1_000, List.of("B", "C", "D"), Set.of("B"), "B");
    Plan third = new Plan(0, List.of("C", "D"), Set.of("C"), "C");
    finishes(
        Map.of(
            FIRST, gvh -> new Car(gvh, first),
            SECOND, gvh -> new Car(gvh, second),
            THIRD, gvh -> new Car(gvh, third)),
        control -> {
          control.crash(FIRST, S, Unsynced.KEPT);
          control.at(7 * S, () -> control.crash(SECOND, S, Unsynced.KEPT));
          control.at(9 * S, () -> control.crash(THIRD, S, Unsynced.KEPT));
        });
  }

  private static void finishes(Plan first, Plan second, Consumer<SimControl> fault) {
    finishes(Map.of(FIRST, gvh -> new Car(gvh, first), SECOND, gvh -> new Car(gvh, second)), fault);
  }

  private static void finishes(
      Map<RobotId, Function<GlobalVarHolder, LogicThread>> cars, Consumer<SimControl> fault) {
    Simulation.Builder builder = Simulation.builder().seed(1);
    for (RobotId post : ROADSIDE) {
      builder.robot(new RobotSpec(post, new Pose(0, 0, 0), false, Post::new));
    }
    new TreeMap<>(cars)
        .forEach((id, car) -> builder.robot(new RobotSpec(id, new Pose(0, 0, 0), false, car)));
    SimResult result =
        builder
            .monitor(() -> new MutexSpec(null).withSequences())
            .director(control -> control.at(5 * S, () -> fault.accept(control)))
            .build()
            .run();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    assertThat(result.unfinished()).isEmpty();
  }

  /**
   * What a car does.
   *
   * @param startMs when its first program asks
   * @param path the sections that it passes, in order
   * @param first those that its first program gets
   * @param stands where its body is when its program restarts
   */
  private record Plan(long startMs, List<String> path, Set<String> first, String stands) {}

  private static final class Post extends LogicThread {
    Post(GlobalVarHolder gvh) {
      super(gvh);
      new Registration(gvh, XID, ROADSIDE);
    }

    @Override
    public List<Object> callStarL() {
      sleep(120_000);
      return returnResults();
    }
  }

  /** Stands still with what its first program gets; the next one obtains the rest. */
  private static class Car extends LogicThread {
    private final Plan plan;
    private final Registration reg;
    protected final M_Mutex mux;

    Car(GlobalVarHolder gvh, Plan plan) {
      super(gvh);
      this.plan = plan;
      reg = new Registration(gvh, XID, ROADSIDE);
      mux = new M_Mutex(gvh, XID, reg);
      if (gvh.id.boot() > 1) {
        mux.resume(Set.of(plan.stands()), plan.path());
      }
    }

    @Override
    public List<Object> callStarL() {
      boolean isFirst = gvh.id.boot() == 1;
      sleep(isFirst ? plan.startMs() : 1_000); // the others learn first where a body is
      obtain(isFirst ? plan.first() : Set.copyOf(plan.path()));
      sleep(isFirst ? 10_000 : 0);
      obtain(Set.copyOf(plan.path()));
      mux.release(plan.path());
      return returnResults();
    }

    /** Asks until it holds {@code sections}, also after it was removed. */
    private void obtain(Set<String> sections) {
      obtain(sections, plan.path());
    }

    protected final void obtain(Set<String> sections, List<String> path) {
      while (!mux.held().containsAll(sections)) {
        while (!reg.mayRequest()) {
          reg.do_register();
          await(() -> reg.mayRequest() || reg.failed().get());
        }
        if (mux.failed().get() || mux.held().isEmpty()) {
          mux.doSequence(path);
        }
        await(() -> mux.held().containsAll(sections) || mux.failed().get());
      }
    }
  }

  /** Its next program asks for the way ahead only, and leaves where it stands with the first part of it. */
  private static final class Leaver extends Car {
    private final Plan plan;

    Leaver(GlobalVarHolder gvh, Plan plan) {
      super(gvh, plan);
      this.plan = plan;
    }

    @Override
    public List<Object> callStarL() {
      if (gvh.id.boot() == 1) {
        obtain(plan.first(), List.copyOf(plan.first()));
        sleep(120_000); // it crashes before
      }
      sleep(1_000);
      List<String> ahead = plan.path().subList(1, plan.path().size());
      obtain(Set.of(ahead.get(0)), ahead);
      mux.release(plan.stands());
      await(() -> mux.held().containsAll(ahead));
      mux.release(ahead);
      return returnResults();
    }
  }
}
