package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationProtocol.Phase;
import org.starl.trace.TraceEvent;

/** The phases that a trace shows are those of the protocol. */
class RegistrationPhasesTest {

  private static final long CHECK_MS = 7;

  private final Map<RobotId, Phases.Step> steps = new TreeMap<>();
  private final Map<RobotId, String> shown = new TreeMap<>();
  private final SortedSet<Phase> seen = new TreeSet<>();
  private int read;

  @Property(tries = 100)
  void aTraceShowsTheProtocolsPhase(@ForAll long seed) {
    Life life = new Life(seed);
    shown.clear();
    seen.clear();
    read = 0;
    check(life.town);
    life.live();
    Statistics.label("in").collect(seen.contains(Phase.IN));
    Statistics.label("in").coverage(runs -> runs.check(true).percentage(share -> share > 50));
    Statistics.label("halfway").collect(seen.contains(Phase.LEFT_HALFWAY));
    Statistics.label("halfway").coverage(runs -> runs.check(true).count(count -> count > 0));
  }

  private void check(Town town) {
    for (; read < town.trace.size(); read++) {
      TraceEvent event = town.trace.get(read);
      boolean isStart =
          event instanceof TraceEvent.Variable start && start.value().equals(View.NONE);
      if (isStart) {
        steps.put(event.robot(), RegistrationFact.PHASES.steps().get());
        shown.put(event.robot(), RegistrationFact.PHASES.first());
      }
      Phases.Step step = Objects.requireNonNull(steps.get(event.robot()));
      shown.compute(event.robot(), (robot, before) -> step.after(before, event));
    }
    for (TownRobot robot : town.robots.values()) {
      if (robot.isUp()) {
        Phase phase = robot.protocol().phase();
        seen.add(phase);
        assertThat(shown.get(robot.name))
            .as("%s at %d ms", robot.name, town.nowMs())
            .isEqualTo(phase.name());
      }
    }
    town.afterMs(CHECK_MS, () -> check(town));
  }
}
