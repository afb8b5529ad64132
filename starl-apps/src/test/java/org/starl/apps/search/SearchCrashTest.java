package org.starl.apps.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.apps.Plan;
import org.starl.apps.search.logic.SearchApp.Location;
import org.starl.apps.search.logic.SearchFact;
import org.starl.apps.search.logic.SearchFact.Assigned;
import org.starl.id.RobotId;
import org.starl.sim.Director;
import org.starl.sim.SimControl;
import org.starl.sim.SimObserver;
import org.starl.sim.world.Unsynced;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/** Whole searches in which a robot crashes: the others go on, and so does it after a restart. */
@Tag("long")
class SearchCrashTest {

  /** It crashes between two legs of its sweep: all that it bars can be seen from beside it. */
  @Test
  void othersSearchTheRoomInFullAroundARobotThatCrashedInIt() {
    Map<String, String> files = Map.of("files", Searches.originals().toString(), "object", "none");
    Plan plan = Searches.plan(8, 0, files, Map.of());
    plan.simulation().fault("crash(bot1,at=35s)");
    assertThat(Searches.answer(plan)).isEqualTo("nothing there");
    assertThat(plan.story().lines()).anyMatch(line -> line.endsWith("has searched room E in full"));
  }

  /** It crashes inside by the door: a way leads past it, but not to all that it has not seen. */
  @Test
  void theOthersTryARoomBarredByACrashedRobotAndGiveItUpInTime() {
    Plan plan = Searches.plan(3, 3, Map.of("rooms", "1", "object", "none"), Map.of());
    plan.simulation().fault("crash(bot0,at=35s)");
    assertThat(Searches.answer(plan)).isEqualTo("gave up, could not search A");
    List<String> lines = plan.story().lines();
    assertThat(lines).anyMatch(line -> line.endsWith("bot1 takes room A"));
    assertThat(lines).anyMatch(line -> line.endsWith("bot2 takes room A"));
  }

  /** Crashes the first robot with a certain event, soon after it, and observes the others. */
  private static final class Killer implements Director, SimObserver {
    private static final long AFTER_NS = 12_000_000_000L;

    private final Director also;
    private final long downNs;
    private final Predicate<Variable> isIt;
    private final Map<RobotId, String> rooms = new TreeMap<>();
    private @Nullable RobotId victim;
    private boolean isDead;
    private boolean isFollowed;
    private boolean isSucceeded;
    private boolean isBack;

    /**
     * @param downNs how long the robot is down; 0: for ever
     */
    Killer(Director also, long downNs, Predicate<Variable> isIt) {
      this.also = also;
      this.downNs = downNs;
      this.isIt = isIt;
    }

    @Override
    public void observed(TraceEvent event) {
      if (!(event instanceof Variable variable)) {
        return;
      }
      if (victim == null && isIt.test(variable)) {
        victim = variable.robot();
      }
      String room = variable.of(SearchFact.ROOM);
      if (room != null) {
        isFollowed |= isDead && room.equals(rooms.get(victim));
        isBack |= isDead && variable.robot().equals(victim) && !room.isEmpty();
        if (!isDead) {
          rooms.put(variable.robot(), room);
        }
      }
      isSucceeded |= isDead && leads(variable, 2);
    }

    @Override
    public void direct(SimControl control) {
      also.direct(control);
      look(control);
    }

    private void look(SimControl control) {
      RobotId robot = victim;
      if (robot == null) {
        control.at(control.nowNs() + 50_000_000, () -> look(control));
      } else {
        control.at(
            control.nowNs() + AFTER_NS,
            () -> {
              isDead = true;
              if (downNs > 0) {
                control.crash(robot, downNs, Unsynced.LOST);
              } else {
                control.crash(robot);
              }
            });
      }
    }
  }

  private static boolean leads(Variable variable, long term) {
    return variable.of(SearchFact.DUTY) instanceof Assigned duty && duty.term() == term;
  }

  private static boolean sweeps(Variable variable) {
    return variable.of(SearchFact.LOCATION) == Location.SWEEP;
  }

  private static Predicate<Variable> leadersSweep() {
    SortedSet<RobotId> leaders = new TreeSet<>();
    return variable -> {
      if (variable.of(SearchFact.DUTY) instanceof Assigned duty
          && duty.term() == 1
          && !duty.rooms().isEmpty()) {
        leaders.add(variable.robot());
      }
      return leaders.contains(variable.robot()) && sweeps(variable);
    };
  }

  @Test
  void anotherRobotLeadsWhenTheLeaderCrashes() {
    for (long seed = 1; seed <= 3; seed++) {
      assertThat(killed(seed, 0, leadersSweep()).isSucceeded).as("seed %d", seed).isTrue();
    }
  }

  @Test
  void aLeaderThatRestartsSearchesOnWithTheOthers() {
    for (long seed = 7; seed <= 8; seed++) {
      Killer killer = killed(seed, 20_000_000_000L, leadersSweep());
      assertThat(killer.isSucceeded).as("seed %d: led by another", seed).isTrue();
      assertThat(killer.isBack).as("seed %d: searches again", seed).isTrue();
    }
  }

  @Test
  void theRoomOfASearcherThatCrashesIsAssignedToAnother() {
    for (long seed = 4; seed <= 6; seed++) {
      Killer killer = killed(seed, 0, SearchCrashTest::sweeps);
      assertThat(killer.isFollowed).as("seed %d", seed).isTrue();
    }
  }

  /** All rooms are searched in full, that of the crashed robot only as far as it is not barred. */
  private static Killer killed(long seed, long downNs, Predicate<Variable> isIt) {
    Map<String, String> empty = Map.of("rooms", "4", "object", "none");
    Plan plan = Searches.plan(seed, 3, empty, Map.of("messageLoss", "0.1"));
    Director sensors = plan.simulation().build().plan().director();
    Killer killer = new Killer(sensors == null ? control -> {} : sensors, downNs, isIt);
    plan.simulation().director(killer).observer(killer);
    String answer = Searches.answer(plan);
    String room = killer.rooms.get(killer.victim);
    assertThat(answer)
        .as("seed %d\n%s", seed, String.join("\n", plan.story().lines()))
        .isIn("nothing there", "gave up, could not search " + room);
    return killer;
  }
}
