package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.sim.SimObserver;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationPlan;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/** Events of several processes as one run. */
class LiveMergeTest {

  private static final long MS = 1_000_000;
  private static final RobotId BOT = new RobotId("bot0");

  private final List<TraceEvent> seen = new ArrayList<>();
  private LiveMerge merge = begun();

  /** Shows to {@link #seen}, which it empties. */
  private LiveMerge begun() {
    SimulationPlan plan = Simulation.builder().build().plan();
    SimObserver observer =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            seen.add(event);
          }
        };
    LiveMerge begun = new LiveMerge(plan, List.of(observer));
    seen.clear();
    return begun;
  }

  private static TraceEvent event(long atNs) {
    return new Fault(atNs, BOT, "x" + atNs, "");
  }

  /** Events come late by less than they are held back. */
  @Property(tries = 200)
  void eventsAreShownInTheOrderOfTheirTimes(
      @ForAll @Size(max = 30) List<@IntRange(max = 3000) Integer> timesMs,
      @ForAll @Size(30) List<@IntRange(max = 399) Integer> delaysMs) {
    record Coming(long atNs, long comesNs) {}
    merge = begun();
    List<Coming> coming = new ArrayList<>();
    for (int i = 0; i < timesMs.size(); i++) {
      long atNs = timesMs.get(i) * MS;
      coming.add(new Coming(atNs, atNs + delaysMs.get(i) * MS));
    }
    coming.sort(Comparator.comparingLong(Coming::comesNs));
    coming.forEach(each -> merge.add(event(each.atNs()), each.atNs(), false));
    long endNs = merge.end();
    assertThat(seen).hasSize(coming.size());
    assertThat(seen).isSortedAccordingTo(Comparator.comparingLong(TraceEvent::timeNs));
    assertThat(seen).allMatch(event -> ((Fault) event).name().equals("x" + event.timeNs()));
    assertThat(endNs).isEqualTo(timesMs.stream().mapToLong(ms -> ms * MS).max().orElse(0));
  }

  @Example
  void anEventThatComesTooLateGetsTheTimeOfTheLatest() {
    merge.add(event(100 * MS), 100 * MS, false);
    merge.reached(2000 * MS);
    merge.add(event(50 * MS), 50 * MS, false);
    merge.end();
    assertThat(seen.stream().map(TraceEvent::timeNs)).endsWith(100 * MS, 100 * MS);
  }

  @Example
  void thePastOfAllTracesIsKnownBeforeAnyIsShown() {
    merge.follows();
    merge.follows();
    merge.add(event(50_000 * MS), 50_000 * MS, false);
    merge.caughtUp();
    merge.add(event(1_000 * MS), 1_000 * MS, false);
    assertThat(seen).isEmpty();
    merge.caughtUp();
    merge.end();
    assertThat(seen.stream().map(TraceEvent::timeNs)).containsExactly(1_000 * MS, 50_000 * MS);
  }

  @Example
  void trueBodiesReplaceMeasuredOnesAndABodyJoinsOnce() {
    Joined truth = new Joined(0, BOT, new Pose(1, 0, 0), 150);
    Joined measured = new Joined(1, BOT, new Pose(2, 0, 0), 150);
    merge.add(truth, 0, true);
    merge.add(measured, 1, false);
    merge.add(new Moved(2, BOT, new Pose(3, 0, 0), 0, 0), 2, false);
    merge.add(new Moved(3, BOT, new Pose(4, 0, 0), 0, 0), 3, true);
    merge.add(new Joined(4, BOT, new Pose(5, 0, 0), 150), 4, true);
    merge.end();
    assertThat(seen.stream().filter(Joined.class::isInstance)).containsExactly(truth);
    assertThat(seen.stream().filter(Moved.class::isInstance).map(e -> ((Moved) e).pose().xMm()))
        .containsExactly(4.0, 5.0);
  }

  @Example
  void aMeasuredBodyIsABeliefWhereTheTrueOneIsKnown() {
    merge.add(new Joined(0, BOT, new Pose(0, 0, 0), 150), 0, true);
    merge.add(new Joined(1, BOT, new Pose(0.5, 0, 0), 150), 1, false); // not told: nearly true
    merge.add(new Moved(2, BOT, new Pose(600, 0, 1), 0, 0), 2, false);
    merge.add(new Moved(3, BOT, new Pose(100, 0, 0), 0, 0), 3, true);
    merge.add(new Moved(4, BOT, new Pose(600, 0, 1), 0, 0), 4, false);
    merge.end();
    assertThat(seen.stream().filter(Variable.class::isInstance))
        .containsExactly(deviation(2, 600), deviation(4, 500));
  }

  private static Variable deviation(long timeNs, double xMm) {
    return new Variable(
        timeNs, BOT, Deviation.SOURCE, Deviation.VAR, new Deviation(xMm, 0, 1, 0, StrictMath.PI));
  }
}
