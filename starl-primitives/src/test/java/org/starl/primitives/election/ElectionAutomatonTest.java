package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.RandomRun;
import org.starl.primitives.election.ElectionAutomaton.Known;
import org.starl.primitives.election.ElectionAutomaton.States;
import org.starl.random.Rng;
import org.starl.spec.automaton.Lift;

/** The executable form of {@code Election_decls} by itself. */
class ElectionAutomatonTest {

  private static final List<ProcessId> PIDS =
      List.of(id("a", 1), id("a", 2), id("b", 1), id("c", 1));
  private static final int TERMS = 4;

  private final ElectionAutomaton automaton = new ElectionAutomaton();

  private static ProcessId id(String robot, long inc) {
    return new ProcessId(new RobotId(robot), inc);
  }

  @Property(tries = 100)
  void randomRunsKeepWhatIsProved(@ForAll long seed) {
    new RandomRun<>(automaton, (rng, s) -> any(rng), ElectionAutomatonTest::broken)
        .check(seed, action -> action instanceof ElectionAction.learn, 1);
  }

  private static String broken(States before, ElectionAction action, States s) {
    return isKept(before, s) ? broken(s) : "kept";
  }

  private static String broken(States s) {
    for (ProcessId i : PIDS) {
      Known known = s.Leader().at(i);
      if (!(known.who() instanceof Lift.up<ProcessId> up)) {
        continue;
      }
      ProcessId leader = up.value();
      if (!s.stood().at(known.term()).contains(leader) || !s.part().at(leader)) {
        return "Soundness";
      }
      for (ProcessId j : PIDS) {
        Known other = s.Leader().at(j);
        if (other.who().isUp() && other.term() == known.term() && !other.equals(known)) {
          return "Agreement";
        }
      }
    }
    return "";
  }

  private static boolean isKept(States before, States after) {
    return before.elected().allMatch((n, who) -> after.elected().at(n).equals(who));
  }

  private static ElectionAction any(Rng rng) {
    ProcessId i = PIDS.get(rng.nextInt(PIDS.size()));
    long n = rng.nextInt(TERMS);
    return switch (rng.nextInt(8)) {
      case 0 -> new ElectionAction.do_election(i);
      case 1, 2 -> new ElectionAction.candidate(i, n);
      case 3, 4 -> new ElectionAction.elect(n, i);
      case 5, 6 -> new ElectionAction.learn(i, n);
      default -> new ElectionAction.fail(i);
    };
  }

  @Test
  void everyFalseConjunctIsNamedWithItsValues() {
    ProcessId a = PIDS.get(0);
    ProcessId b = PIDS.get(2);
    States s = automaton.start();
    assertThat(obstacle(s, new ElectionAction.candidate(a, 1)))
        .isEqualTo("part(i) is false: NOT part(a#1)");
    assertThat(obstacle(s, new ElectionAction.learn(a, 1)))
        .isEqualTo("up?(elected(n)) is false: elected(1) = bottom");
    s = automaton.trans(new ElectionAction.do_election(a), s);
    s = automaton.trans(new ElectionAction.candidate(a, 1), s);
    assertThat(obstacle(s, new ElectionAction.elect(1, b)))
        .isEqualTo("stood(n)(i) is false: stood(1) = [a#1]");
    s = automaton.trans(new ElectionAction.elect(1, a), s);
    assertThat(obstacle(s, new ElectionAction.elect(1, a)))
        .isEqualTo("bottom?(elected(n)) is false: elected(1) = up(a#1)");
  }

  private String obstacle(States s, ElectionAction action) {
    return automaton.enabled(action, s).falseConjunct();
  }
}
