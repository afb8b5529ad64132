package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.RandomRun;
import org.starl.primitives.registration.RegistrationAutomaton.States;
import org.starl.random.Rng;

/** The executable form of {@code Registration_decls} by itself. */
class RegistrationAutomatonTest {

  private static final List<ProcessId> PIDS =
      List.of(id("a", 1), id("a", 2), id("b", 1), id("c", 1));

  private final RegistrationAutomaton automaton = new RegistrationAutomaton();

  private static ProcessId id(String robot, long inc) {
    return new ProcessId(new RobotId(robot), inc);
  }

  @Property(tries = 60)
  void randomRunsKeepWhatIsProved(@ForAll long seed) {
    new RandomRun<>(automaton, RegistrationAutomatonTest::any, (before, action, s) -> broken(s))
        .check(seed, action -> action instanceof RegistrationAction.decide, 1);
  }

  /** Keeps, Fresh, Soundness; Agreement is plain from the states' form. */
  private static String broken(States s) {
    for (ProcessId i : PIDS) {
      if (s.ts().at(i) > s.number() || s.rList(i).stream().anyMatch(j -> !s.asked().contains(j))) {
        return "Soundness";
      }
      boolean was = false;
      boolean left = false;
      for (long n = 0; n <= s.number(); n++) {
        boolean is = s.list().at(n).contains(i);
        if (is && left) {
          return "Fresh";
        }
        left |= was && !is;
        was |= is;
      }
      if (left && !s.gone().contains(i)) {
        return "Keeps";
      }
    }
    return "";
  }

  private static RegistrationAction any(Rng rng, States s) {
    ProcessId i = PIDS.get(rng.nextInt(PIDS.size()));
    return switch (rng.nextInt(12)) {
      case 0, 1 -> new RegistrationAction.do_register(i);
      case 2 ->
          switch (rng.nextInt(6)) {
            case 0 -> new RegistrationAction.unregister(i);
            case 1 -> new RegistrationAction.give_up(i);
            case 2 -> new RegistrationAction.confine(i);
            default -> new RegistrationAction.learn(i, s.number());
          };
      case 3, 4, 5 -> new RegistrationAction.learn(i, rng.nextInt((int) s.number() + 2));
      default -> new RegistrationAction.decide(some(rng));
    };
  }

  private static SortedSet<ProcessId> some(Rng rng) {
    List<ProcessId> some = new ArrayList<>(PIDS);
    some.removeIf(id -> rng.nextBoolean(0.4));
    return Collections.unmodifiableSortedSet(new TreeSet<>(some));
  }
}
