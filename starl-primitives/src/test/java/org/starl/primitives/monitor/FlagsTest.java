package org.starl.primitives.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFlag;
import org.starl.primitives.election.Election;
import org.starl.primitives.election.ElectionFact;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.election.Leader;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.registration.RList;
import org.starl.primitives.registration.Registration;
import org.starl.primitives.registration.RegistrationFact;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.SimObserver;
import org.starl.sim.Simulation;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;
import org.starl.trace.Var;

/** A correct run, whose robots show one variable wrongly. */
class FlagsTest {

  private static final long MS = 1_000_000;
  private static final Var<RList> R_LIST = RegistrationFact.R_LIST;

  /** Uses each primitive that has a flag. */
  private static final class App extends LogicThread {
    App(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Registration registration = new Registration(gvh, "x");
      M_Mutex mutex = new M_Mutex(gvh, "x", registration);
      Election election = new Election(gvh, "x");
      registration.do_register();
      await(() -> registration.rList().get().isAgreed());
      mutex.do_mutex(List.of("A", "B"));
      await(mutex::od_mutex);
      sleep(10);
      mutex.release("A");
      sleep(10);
      mutex.release("B");
      mutex.do_mutex(List.of("A"));
      mutex.withdraw();
      sleep(10);
      mutex.do_mutex(List.of("B"));
      await(mutex::od_mutex);
      mutex.release("B");
      election.do_election();
      await(() -> election.Leader().get().isElected());
      gvh.plat.moat.doMove(new ItemPosition("far", 9_000, 9_000));
      sleep(500);
      gvh.plat.moat.motion_stop();
      registration.unregister();
      await(registration::isUnregistered);
      return List.of();
    }
  }

  private static List<TraceEvent> recorded() {
    List<TraceEvent> events = new ArrayList<>();
    Simulation.builder()
        .seed(1)
        .robots(3, App::new)
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                events.add(event);
              }
            })
        .build()
        .run();
    return events;
  }

  private static SpecReport judge(List<TraceEvent> events) {
    Monitors monitors =
        Monitors.of(
            List.of(MutexSpec::new, RegistrationSpec::new, ElectionSpec::new, MotionSpec::new));
    events.stream().sorted(Comparator.comparingLong(TraceEvent::timeNs)).forEach(monitors::observe);
    return monitors.report();
  }

  private static final List<TraceEvent> RUN = recorded();

  @Test
  void theRunItselfHolds() {
    SpecReport report = judge(RUN);
    assertThat(report.violations()).isEmpty();
    assertThat(report.neverChecked())
        .doesNotContain(
            "mutex.crit",
            "mutex.failed",
            "registration.rList",
            "election.Leader",
            "motion.motionflag",
            "synod.Quorums");
  }

  /** What robots show instead, and the lemma that tells. */
  enum Bug {
    TRUE_BEFORE_ACCESS("mutex.crit", event -> moved(event, MutexFact.CRIT, true, -1)),
    TRUE_A_STEP_LATER("mutex.crit", event -> moved(event, MutexFact.CRIT, true, 1)),
    TRUE_AFTER_THE_LAST_RELEASE("mutex.crit", event -> without(event, MutexFact.CRIT, false)),
    FALSE_AFTER_THE_FIRST_RELEASE("mutex.crit", Bug::falseTooEarly),
    NOT_FAILED_AFTER_WITHDRAW("mutex.failed", event -> without(event, MutexFact.FAILED, true)),
    STILL_FAILED_IN_THE_NEXT_REQUEST(
        "mutex.failed", event -> without(event, MutexFact.FAILED, false)),
    NO_REASON_FOR_A_FAILURE(
        "mutex.failed", event -> without(event, MutexFact.FAILURE, MutexFailure.WITHDRAWN)),
    LISTED_AFTER_UNREGISTER("registration.rList", event -> without(event, R_LIST, RList.UNKNOWN)),
    FORGETS_ITS_LEADER("election.Leader", Bug::forgetful),
    MOVING_AFTER_STOP(
        "motion.motionflag", event -> without(event, MotionFact.FLAG, MotionFlag.IDLE));

    private final String lemma;
    private final Function<TraceEvent, Stream<TraceEvent>> change;

    Bug(String lemma, Function<TraceEvent, Stream<TraceEvent>> change) {
      this.lemma = lemma;
      this.change = change;
    }

    private static <T> boolean sets(TraceEvent event, Var<T> flag, T value) {
      return event.timeNs() > 0
          && event instanceof Variable variable
          && value.equals(variable.of(flag));
    }

    private static <T> Stream<TraceEvent> moved(TraceEvent event, Var<T> flag, T value, long ms) {
      return Stream.of(sets(event, flag, value) ? event.at(event.timeNs() + ms * MS) : event);
    }

    private static <T> Stream<TraceEvent> without(TraceEvent event, Var<T> flag, T value) {
      return sets(event, flag, value) ? Stream.of() : Stream.of(event);
    }

    private static Stream<TraceEvent> falseTooEarly(TraceEvent event) {
      return event instanceof Action action && action.fact() instanceof MutexFact.Release
          ? Stream.of(
              event,
              new Variable(event.timeNs(), event.robot(), action.source(), MutexFact.CRIT, false))
          : Stream.of(event);
    }

    private static Stream<TraceEvent> forgetful(TraceEvent event) {
      return event instanceof Variable variable
              && variable.of(ElectionFact.LEADER) instanceof Leader.Name
          ? Stream.of(
              event,
              new Variable(
                  event.timeNs() + MS,
                  event.robot(),
                  variable.source(),
                  ElectionFact.LEADER,
                  Leader.NONE),
              event.at(event.timeNs() + 2 * MS))
          : Stream.of(event);
    }
  }

  @ParameterizedTest
  @EnumSource
  void itsLemmaAloneIsViolated(Bug bug) {
    SpecReport report = judge(RUN.stream().flatMap(bug.change).toList());
    assertThat(report.violations())
        .as("%s", report)
        .isNotEmpty()
        .allMatch(violation -> violation.lemma().equals(bug.lemma));
  }
}
