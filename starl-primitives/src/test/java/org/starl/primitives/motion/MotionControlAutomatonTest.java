package org.starl.primitives.motion;

import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.primitives.conformance.RandomRun;
import org.starl.primitives.motion.MotionControlAutomaton.States;
import org.starl.random.Rng;

/** The executable form of {@code MotionControl_decls}, without runs. */
class MotionControlAutomatonTest {

  private static final List<RobotId> PIDS = List.of(new RobotId("i"), new RobotId("j"));
  private static final int COMMANDS = 4;

  private final MotionControlAutomaton automaton = new MotionControlAutomaton(Place::isNear);

  @Property(tries = 100)
  void randomRunsSatisfyTheProvedInvariants(@ForAll long seed) {
    new RandomRun<>(automaton, (rng, s) -> any(rng), (before, action, s) -> broken(s))
        .check(seed, action -> action instanceof MotionControlAction.arrived, 1);
  }

  /** Avoids, Told. */
  private static String broken(States s) {
    for (RobotId i : PIDS) {
      MotionFlag flag = s.motionflag().at(i);
      if (flag != MotionFlag.IDLE && s.avoid().at(i).contains(s.pos().at(i))) {
        return "Avoids";
      }
      if (flag == MotionFlag.DONE && !s.at().at(i).isNear(s.target().at(i))) {
        return "Told";
      }
    }
    return "";
  }

  private static MotionControlAction any(Rng rng) {
    RobotId i = PIDS.get(rng.nextInt(PIDS.size()));
    return switch (rng.nextInt(10)) {
      case 0, 1 -> {
        long command = rng.nextLong(1, COMMANDS);
        boolean isGotopoint = rng.nextBoolean(0.2);
        yield new MotionControlAction.do_move(
            i, Place.target(command), isGotopoint ? Area.NONE : new Area(command));
      }
      case 2, 3 -> new MotionControlAction.arrived(i);
      case 4 ->
          rng.nextBoolean(0.5)
              ? new MotionControlAction.failed(i)
              : new MotionControlAction.motion_stop(i);
      default -> new MotionControlAction.move(i, Place.of(some(rng), some(rng)));
    };
  }

  private static SortedSet<Long> some(Rng rng) {
    SortedSet<Long> some = new TreeSet<>();
    for (long command = 1; command <= COMMANDS; command++) {
      if (rng.nextBoolean(0.4)) {
        some.add(command);
      }
    }
    return Collections.unmodifiableSortedSet(some);
  }
}
