package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.barrier.BarrierAutomaton.Outcome;
import org.starl.primitives.barrier.BarrierAutomaton.States;
import org.starl.primitives.barrier.BarrierAutomaton.Told;
import org.starl.primitives.conformance.RandomRun;
import org.starl.random.Rng;

/** The executable form of {@code Barrier_decls} by itself. */
class BarrierAutomatonTest {

  private static final ProcessId A = id("a", 1);
  private static final ProcessId B = id("b", 1);
  private static final ProcessId C = id("c", 1);
  private static final List<ProcessId> PIDS = List.of(A, B, C, id("a", 2));
  private static final int GENERATIONS = 6;

  private final BarrierAutomaton automaton = new BarrierAutomaton(new TreeSet<>(List.of(A, B, C)));

  private static ProcessId id(String robot, long boot) {
    return ProcessId.first(new RobotId(robot), boot);
  }

  @Property(tries = 100)
  void randomRunsKeepWhatIsProved(@ForAll long seed) {
    new RandomRun<>(automaton, this::any, this::broken)
        .check(seed, action -> action instanceof BarrierAction.tell, 1);
  }

  private String broken(States before, BarrierAction action, States s) {
    return isKept(before, s) ? broken(s) : "kept";
  }

  private String broken(States s) {
    for (ProcessId i : PIDS) {
      Told told = s.told().at(i);
      SortedSet<ProcessId> arrived = s.arrived().at(told.gen());
      if (told.out() instanceof Outcome.passed
          && !arrived.containsAll(automaton.members(told.gen(), s))) {
        return "NoEarly";
      }
      for (ProcessId j : PIDS) {
        Told other = s.told().at(j);
        boolean areBoth = !(told.out() instanceof Outcome.open);
        areBoth &= !(other.out() instanceof Outcome.open) && told.gen() == other.gen();
        if (areBoth && !told.equals(other)) {
          return "Uniform";
        }
      }
    }
    List<ProcessId> out = new ArrayList<>();
    s.outcome()
        .forEach((g, outcome) -> {
          if (outcome instanceof Outcome.failed failed) {
            out.addAll(failed.missing());
          }
        });
    return new TreeSet<>(out).size() == out.size() ? "" : "OutOnce";
  }

  /** A generation keeps its outcome and its members. */
  private boolean isKept(States before, States after) {
    return before
        .outcome()
        .allMatch((g, outcome) ->
            after.outcome().at(g).equals(outcome)
                && automaton.members(g, after).equals(automaton.members(g, before)));
  }

  private BarrierAction any(Rng rng, States s) {
    ProcessId i = PIDS.get(rng.nextInt(PIDS.size()));
    long g = rng.nextInt(GENERATIONS);
    return switch (rng.nextInt(10)) {
      case 0, 1, 2, 3 -> new BarrierAction.arrive(i, g);
      case 4 -> new BarrierAction.decide(g, new Outcome.open());
      case 5, 6 -> new BarrierAction.decide(g, new Outcome.passed());
      case 7 -> new BarrierAction.decide(g, new Outcome.failed(some(rng)));
      default -> new BarrierAction.tell(i, g);
    };
  }

  private static SortedSet<ProcessId> some(Rng rng) {
    List<ProcessId> some = new ArrayList<>(PIDS);
    some.removeIf(id -> rng.nextBoolean(0.7));
    return Collections.unmodifiableSortedSet(new TreeSet<>(some));
  }

  @Test
  void everyFalseConjunctIsNamedWithItsValues() {
    States s = automaton.start();
    Outcome passed = new Outcome.passed();
    assertThat(obstacle(s, new BarrierAction.tell(A, 1)))
        .isEqualTo("not outcome(g) is open is false: outcome(1) = open");
    assertThat(obstacle(s, new BarrierAction.decide(0, passed)))
        .isEqualTo("right?(g, o) is false: g = 0");
    assertThat(obstacle(s, new BarrierAction.decide(2, passed)))
        .isEqualTo("right?(g, o) is false: outcome(1) = open");
    assertThat(obstacle(s, new BarrierAction.decide(1, new Outcome.open())))
        .isEqualTo("right?(g, o) is false: o = open");
    s = automaton.trans(new BarrierAction.arrive(B, 1), s);
    assertThat(obstacle(s, new BarrierAction.decide(1, passed)))
        .isEqualTo("right?(g, o) is false: members(1) = [a, b, c], arrived(1) = [b]");
    assertThat(obstacle(s, new BarrierAction.decide(1, failed())))
        .isEqualTo("right?(g, o) is false: M = []");
    s = after(s, new BarrierAction.decide(1, failed(A)));
    assertThat(obstacle(s, new BarrierAction.decide(1, passed)))
        .isEqualTo("outcome(g) is open is false: outcome(1) = failed([a])");
    assertThat(obstacle(s, new BarrierAction.decide(2, failed(A))))
        .isEqualTo("right?(g, o) is false: members(2) = [b, c]");
  }

  @Test
  void anExcludedMemberIsNotWaitedFor() {
    States s = after(automaton.start(), new BarrierAction.decide(1, failed(A)));
    s = after(s, new BarrierAction.arrive(B, 2));
    s = after(s, new BarrierAction.arrive(C, 2));
    s = after(s, new BarrierAction.decide(2, new Outcome.passed()));
    s = after(s, new BarrierAction.tell(B, 2));
    assertThat(s.told().at(B)).isEqualTo(new Told(2, new Outcome.passed()));
  }

  private static Outcome failed(ProcessId... missing) {
    return new Outcome.failed(new TreeSet<>(List.of(missing)));
  }

  private String obstacle(States s, BarrierAction action) {
    return automaton.enabled(action, s).falseConjunct();
  }

  private States after(States s, BarrierAction action) {
    assertThat(obstacle(s, action)).isEmpty();
    return automaton.trans(action, s);
  }
}
