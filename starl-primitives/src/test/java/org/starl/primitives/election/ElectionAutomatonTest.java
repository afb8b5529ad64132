package org.starl.primitives.election;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
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
      if (!s.stood().at(known.term()).contains(leader) || !s.part().contains(leader)) {
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
}
