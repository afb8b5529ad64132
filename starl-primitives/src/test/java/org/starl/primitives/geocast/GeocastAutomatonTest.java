package org.starl.primitives.geocast;

import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.RandomRun;
import org.starl.primitives.geocast.GeocastAutomaton.States;
import org.starl.random.Rng;

/** The executable form of {@code Geocast_decls}, without runs. */
class GeocastAutomatonTest {

  private static final List<RobotId> PIDS =
      List.of(new RobotId("i"), new RobotId("j"), new RobotId("k"));
  private static final List<String> MSGS = List.of("1", "2", "3", "4");

  private final GeocastAutomaton automaton = new GeocastAutomaton();

  @Property(tries = 100)
  void randomRunsSatisfyTheProvedInvariants(@ForAll long seed) {
    new RandomRun<>(automaton, (rng, s) -> any(rng), this::broken)
        .check(seed, action -> action instanceof GeocastAction.deliver, 1);
  }

  private String broken(States before, GeocastAction action, States s) {
    if (action instanceof GeocastAction.deliver deliver) {
      String m = deliver.m();
      if (before.now() < s.t0().at(m) || before.now() > s.t0().at(m) + s.d().at(m)) {
        return "deadline";
      }
      if (automaton.enabled(deliver, s).isTrue()) {
        return "once";
      }
    }
    return broken(s);
  }

  /** Inv_geo, Exclusion. */
  private static String broken(States s) {
    for (String m : MSGS) {
      for (RobotId i : PIDS) {
        boolean in = s.was_in().at(m).at(i);
        boolean out = s.was_out().at(m).at(i);
        boolean isInside = s.area().at(m).contains(s.pos().at(i));
        if (s.sent().contains(m) && s.got().at(m).at(i) && !in) {
          return "Exclusion of " + m + " and " + i;
        }
        boolean isRight =
            s.t0().at(m) <= s.now() && (in || out) && (!s.isOpen(m) || (isInside ? in : out));
        if (s.sent().contains(m) && !isRight) {
          return "Inv_geo of " + m + " and " + i;
        }
      }
    }
    return "";
  }

  private static GeocastAction any(Rng rng) {
    RobotId i = PIDS.get(rng.nextInt(PIDS.size()));
    String m = MSGS.get(rng.nextInt(MSGS.size()));
    return switch (rng.nextInt(20)) {
      case 0 -> new GeocastAction.dt(rng.nextInt(3));
      case 1 -> new GeocastAction.do_geocast(m, new Area(m), 5 + rng.nextInt(20));
      case 2 -> new GeocastAction.restart(i);
      case 3, 4, 5, 6 -> new GeocastAction.move(i, new Place(some(rng)));
      default -> new GeocastAction.deliver(m, i);
    };
  }

  private static SortedSet<String> some(Rng rng) {
    SortedSet<String> some = new TreeSet<>(MSGS);
    some.removeIf(m -> rng.nextBoolean(0.6));
    return Collections.unmodifiableSortedSet(some);
  }
}
