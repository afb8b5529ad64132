package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.primitives.conformance.RandomRun;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.Short;
import org.starl.primitives.mutex.MutexAutomaton.States;
import org.starl.random.Rng;

/** The executable form of {@code Mutex_decls}, without runs. */
class MutexAutomatonTest {

  private static final List<ProcessId> PIDS =
      List.of(ProcessId.parse("i"), ProcessId.parse("j"), ProcessId.parse("k"));
  private static final ProcessId I = PIDS.get(0);
  private static final ProcessId J = PIDS.get(1);
  private static final List<String> ZONES = List.of("A", "B", "C");

  private final MutexAutomaton automaton = new MutexAutomaton();

  @Property(tries = 100)
  void randomRunsSatisfyTheProvedInvariants(@ForAll long seed) {
    new RandomRun<>(automaton, MutexAutomatonTest::any, (before, action, s) -> broken(s))
        .check(seed, action -> true, 31);
  }

  private static String broken(States s) {
    if (!isExclusive(s)) {
      return "exclusive";
    }
    return isInPhase(s) ? "" : "phase";
  }

  private static boolean isExclusive(States s) {
    for (ProcessId i : PIDS) {
      for (ProcessId j : PIDS) {
        if (!i.equals(j) && Sections.meet(s.held(i), s.held(j))) {
          return false;
        }
      }
    }
    return true;
  }

  /** A waiting robot has access to no section. */
  private static boolean isInPhase(States s) {
    return PIDS.stream().allMatch(i -> s.crit_set().at(i).isEmpty() || s.req_set().at(i).isEmpty());
  }

  private static MutexAction any(Rng rng, States s) {
    ProcessId i = PIDS.get(rng.nextInt(PIDS.size()));
    SortedSet<String> some = some(rng);
    return switch (rng.nextInt(8)) {
      case 0, 1 -> new MutexAction.do_mutex(i, some);
      case 2, 3, 4 -> new MutexAction.od_mutex(i, s.req_set().at(i));
      case 5 -> new MutexAction.release(i, Sections.common(s.crit_set().at(i), some));
      case 6 -> rng.nextBoolean(0.5) ? new MutexAction.withdraw(i) : new MutexAction.restart(i);
      default -> new MutexAction.stands_in(i, some);
    };
  }

  private static SortedSet<String> some(Rng rng) {
    List<String> some = new ArrayList<>(ZONES);
    some.removeIf(zone -> rng.nextBoolean(0.5));
    return Sections.copyOf(some);
  }

  @Test
  void theStartStateHasNoRequestsAndNoHolders() {
    assertThat(automaton.theory()).isEqualTo("Mutex_decls");
    assertThat(PIDS).allMatch(i -> automaton.start().held(i).isEmpty());
    assertThat(PIDS).allMatch(i -> automaton.start().req_set().at(i).isEmpty());
  }

  @Test
  void everyFalseConjunctIsNamedWithItsValues() {
    States idle = automaton.start();
    States waits = after(idle, new MutexAction.do_mutex(I, set("A B")));
    States holds = after(waits, new MutexAction.od_mutex(I, set("A B")));
    States restarted = after(holds, new MutexAction.restart(I));
    States other = after(restarted, new MutexAction.do_mutex(J, set("B C")));
    assertThat(obstacle(idle, new MutexAction.do_mutex(I, set(""))))
        .isEqualTo("RS != {} is false: RS = []");
    assertThat(obstacle(waits, new MutexAction.do_mutex(I, set("C"))))
        .isEqualTo("req_set(i) = {} is false: req_set(i) = [A, B]");
    assertThat(obstacle(holds, new MutexAction.do_mutex(I, set("C"))))
        .isEqualTo("crit_set(i) = {} is false: crit_set(i) = [A, B]");
    assertThat(obstacle(waits, new MutexAction.od_mutex(I, set("A"))))
        .isEqualTo("RS = req_set(i) is false: req_set(i) = [A, B]");
    assertThat(obstacle(other, new MutexAction.od_mutex(J, set("B C"))))
        .isEqualTo("free_for?(i, RS) is false: held(i) = [A, B]");
    assertThat(obstacle(holds, new MutexAction.release(I, set("B C"))))
        .isEqualTo("RS subset crit_set(i) is false: crit_set(i) = [A, B]");
    assertThat(obstacle(holds, new MutexAction.withdraw(I)))
        .isEqualTo("req_set(i) != {} is false: req_set(i) = []");
    assertThat(obstacle(other, new MutexAction.withdraw(J))).isEmpty();
  }

  @Test
  void sectionsOfAnEarlierStartAreHeldUntilStandsIn() {
    States s = automaton.start();
    s = after(s, new MutexAction.do_mutex(I, set("A B")));
    s = after(s, new MutexAction.od_mutex(I, set("A B")));
    s = after(s, new MutexAction.restart(I));
    assertThat(s.crit_set().at(I)).isEmpty();
    assertThat(s.held(I)).containsExactly("A", "B");
    s = after(s, new MutexAction.stands_in(I, set("B C")));
    assertThat(s.held(I)).containsExactly("B");
    s = after(s, new MutexAction.do_mutex(J, set("A")));
    s = after(s, new MutexAction.od_mutex(J, set("A")));
    s = after(s, new MutexAction.stands_in(I, set("")));
    assertThat(s.rest_set().isConstant()).isTrue();
  }

  private String obstacle(States s, MutexAction action) {
    return automaton.enabled(action, s).falseConjunct();
  }

  private States after(States s, MutexAction action) {
    assertThat(obstacle(s, action)).isEmpty();
    return automaton.trans(action, s);
  }

  private static SortedSet<String> set(String names) {
    return new TreeSet<>(Short.sections(names));
  }
}
