package org.starl.spec;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;

/**
 * Monitors for what apps often require, each in one line:
 *
 * <pre>{@code
 * simulation.monitor(() -> Require.neverTwoIn("alone_at_the_dock", DOCK));
 * simulation.monitor(() -> Require.eventuallyIn("at_the_goal", GOAL, Duration.ofSeconds(60)));
 * simulation.monitor(() -> Require.always("in_line", "all robots keep the line", Line::isKept));
 * simulation.monitor(() -> Require.atTheEnd("home", "all robots are home", Home::isReached));
 * }</pre>
 *
 * <p>They judge true bodies, not the robots' estimates. They look at each event of a body, a variable
 * or a fault, and between events every 40 ms of virtual time: at 250 mm/s, every 10 mm of way.
 */
public final class Require {

  private static final long STEP_NS = 40 * Time.NS_PER_MS;

  private Require() {}

  /** No two robots touch the region at one time. A robot touches it with any part of its body. */
  public static Monitor neverTwoIn(String lemma, Region region) {
    return new Looking(lemma, "Never two robots in " + region + ".") {
      private List<RobotId> before = List.of();

      @Override
      void look(RunState state, Report report) {
        List<RobotId> there = new ArrayList<>();
        for (RobotId robot : state.robots()) {
          if (region.distanceMm(state.pose(robot).at()) < state.radiusMm(robot)) {
            there.add(robot);
          }
        }
        report.checked(lemma);
        if (there.size() > 1 && !before.containsAll(there)) {
          String detail = "all of them are in " + region;
          report.violatedIn(region, lemma, state.timeNs(), there, detail);
        }
        before = there;
      }
    };
  }

  /** Each robot is once in the region, with the center of its body; see the other method. */
  public static Monitor eventuallyIn(String lemma, Region region, Duration within) {
    return eventuallyIn(lemma, robot -> region, within);
  }

  /**
   * Each robot is once in its region, with the center of its body, within this time from its start.
   * The time begins again when the faults that were active have ended, and when the robot's program
   * has restarted.
   */
  public static Monitor eventuallyIn(
      String lemma, Function<RobotId, Region> regionOf, Duration within) {
    Within<RobotId> deadlines = new Within<>(within.toNanos());
    FaultState faults = new FaultState();
    return new Looking(
        lemma, "Each robot is in its region within " + Time.seconds(within.toNanos()) + " s.") {

      {
        progress(lemma, description(lemma));
      }

      @Override
      public void observe(TraceEvent event, Report report) {
        super.observe(event, report);
        if (event instanceof Joined) {
          deadlines.start(event.robot(), event.timeNs());
        }
        if (faults.observe(event)) {
          deadlines.assumeAll(faults.isFaultFree(), event.timeNs());
          deadlines.assumeEach(faults::isUp, event.timeNs());
        }
      }

      @Override
      void look(RunState state, Report report) {
        for (RobotId robot : state.robots()) {
          if (regionOf.apply(robot).contains(state.pose(robot).at()) && deadlines.stop(robot)) {
            report.checked(lemma);
          }
        }
        deadlines.expire(
            state.timeNs(),
            (robot, sinceNs, deadlineNs) -> {
              report.checked(lemma);
              Region region = regionOf.apply(robot);
              String detail = "has not been in " + region;
              report.violatedIn(region, lemma, deadlineNs, List.of(robot), detail);
            });
      }
    };
  }

  /**
   * The condition holds at each look.
   *
   * @param sentence what it says, for people
   * @param condition depends only on its argument
   */
  public static Monitor always(String lemma, String sentence, Predicate<RunState> condition) {
    return new Looking(lemma, sentence) {
      private boolean held = true;

      @Override
      void look(RunState state, Report report) {
        boolean holds = condition.test(state);
        report.checked(lemma);
        if (held && !holds) {
          report.violated(
              lemma, state.timeNs(), List.copyOf(state.robots()), "does not hold: " + sentence);
        }
        held = holds;
      }
    };
  }

  /**
   * The condition holds at the end of the run, also of one that reaches its time limit.
   *
   * @param sentence what it says, for people
   * @param condition depends only on its argument
   */
  public static Monitor atTheEnd(String lemma, String sentence, Predicate<RunState> condition) {
    return new Looking(lemma, sentence) {

      @Override
      void look(RunState state, Report report) {
        // Before the end, nothing is required.
      }

      @Override
      void lookAtTheEnd(RunState state, Report report) {
        report.checked(lemma);
        if (!condition.test(state)) {
          report.violated(
              lemma,
              state.timeNs(),
              List.copyOf(state.robots()),
              "does not hold at the end: " + sentence);
        }
      }
    };
  }

  /** A monitor that looks at the state of the run, at events and between them. */
  private abstract static class Looking extends LemmaMonitor {
    private final RunState state = new RunState();

    Looking(String lemma, String sentence) {
      lemma(lemma, sentence);
    }

    abstract void look(RunState state, Report report);

    void lookAtTheEnd(RunState state, Report report) {
      look(state, report);
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      lookUntil(event.timeNs(), report);
      state.observe(event);
      if (changesTheState(event)) {
        look(state, report);
      }
    }

    @Override
    public final void finish(long endNs, Report report) {
      lookUntil(endNs, report);
      lookAtTheEnd(state, report);
    }

    private void lookUntil(long timeNs, Report report) {
      while (state.timeNs() + STEP_NS <= timeNs) {
        state.advance(state.timeNs() + STEP_NS);
        look(state, report);
      }
      state.advance(timeNs);
    }

    private static boolean changesTheState(TraceEvent event) {
      return switch (event) {
        case TraceEvent.Variable variable -> true;
        case TraceEvent.Moved moved -> true;
        case Joined joined -> true;
        case Left left -> true;
        case TraceEvent.Fault fault -> true;
        case TraceEvent.Action action -> false;
        case TraceEvent.Sent sent -> false;
        case TraceEvent.Delivered delivered -> false;
        case TraceEvent.Dropped dropped -> false;
        case TraceEvent.Intervention intervention -> false;
      };
    }
  }
}
