package org.starl.primitives.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Everywhere;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.Phases;
import org.starl.primitives.agreement.AgreementAction;
import org.starl.primitives.agreement.AgreementFact;
import org.starl.primitives.agreement.Decision;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.barrier.BarrierAction;
import org.starl.primitives.barrier.BarrierFact;
import org.starl.primitives.barrier.BarrierOutcome;
import org.starl.primitives.election.ElectionAction;
import org.starl.primitives.election.ElectionFact;
import org.starl.primitives.election.Leader;
import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.geocast.GeocastId;
import org.starl.primitives.membership.Short;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.paths.TubeFact;
import org.starl.primitives.paths.TubeFlag;
import org.starl.primitives.paths.TubeList;
import org.starl.primitives.registration.Shown;
import org.starl.shape.RecordShape;
import org.starl.shape.SumShape;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

class PrimitivePhasesTest {

  private static final RobotId BOT = new RobotId("bot1");
  private static final ProcessId ME = ProcessId.first(BOT, 1);

  private static Phases of(String primitive) {
    return PrimitivePhases.ALL.stream()
        .filter(phases -> phases.primitive().equals(primitive))
        .findFirst()
        .orElseThrow();
  }

  /** The phases after each event. */
  private static List<String> after(String primitive, TraceEvent... events) {
    Phases phases = of(primitive);
    List<String> after = new ArrayList<>();
    Phases.Step step = phases.steps().get();
    String phase = phases.first();
    for (TraceEvent event : events) {
      phase = step.after(phase, event);
      assertThat(phases.names()).contains(phase);
      after.add(phase);
    }
    return after;
  }

  private static <F> TraceEvent acts(String primitive, RecordShape<F> shape, F fact) {
    return TraceEvent.Action.of(0, BOT, Instance.of(primitive, "x"), shape, fact);
  }

  private static <F> TraceEvent acts(String primitive, SumShape<F> shape, F fact) {
    return TraceEvent.Action.of(0, BOT, Instance.of(primitive, "x"), shape, fact);
  }

  private static <T> TraceEvent shows(String primitive, Var<T> variable, T value) {
    return new TraceEvent.Variable(0, BOT, Instance.of(primitive, "x"), variable, value);
  }

  @Test
  void eachPrimitiveDeclaresItsPhasesAndSealedMessages() {
    assertThat(PrimitivePhases.ALL)
        .extracting(Phases::primitive)
        .containsExactlyInAnyOrder(
            "agreement",
            "barrier",
            "broadcast",
            "election",
            "geocast",
            "ledger",
            "mutex",
            "registration",
            "tubes");
    for (Phases phases : PrimitivePhases.ALL) {
      assertThat(phases.names()).hasSizeGreaterThan(1).doesNotHaveDuplicates();
      assertThat(phases.channels().values()).isNotEmpty().allMatch(Class::isSealed);
    }
  }

  @Test
  void aMutexIsTryingUntilItIsCriticalOrGivesUp() {
    assertThat(
            after(
                "mutex",
                mutex(new MutexFact.DoMutex(ME, 1, 1, set("A B"), new TreeSet<>())),
                mutex(new MutexFact.OdMutex(ME, 1, set("A B"))),
                mutex(new MutexFact.Release(ME, 1, set("A"), set("B"))),
                mutex(new MutexFact.Release(ME, 1, set("B"), set(""))),
                mutex(new MutexFact.DoMutex(ME, 2, 1, set("A"), new TreeSet<>())),
                mutex(new MutexFact.Withdraw(ME, 2, MutexFailure.DEADLINE))))
        .containsExactly("TRYING", "CRITICAL", "CRITICAL", "IDLE", "TRYING", "IDLE");
  }

  private static TraceEvent mutex(MutexFact fact) {
    return acts("mutex", MutexFact.SHAPE, fact);
  }

  private static SortedSet<String> set(String sections) {
    return Short.sections(sections);
  }

  @Test
  void aRegistrationLeavesWithTheViewWithoutIt() {
    assertThat(
            after(
                "registration",
                Shown.acts(0, "bot1", "do_register", "bot1"),
                Shown.sees(0, "bot1", "1:bot1@1"),
                Shown.shows(0, "bot1", "1:[bot1]"),
                Shown.shows(0, "bot1", "null"),
                Shown.acts(0, "bot1", "unregister", "bot1"),
                Shown.failed(0, "bot1"),
                Shown.sees(0, "bot1", "2:bot11@1")))
        .containsExactly("JOINING", "IN", "IN", "IN", "LEAVING", "LEFT_HALFWAY", "OUT");
    assertThat(
            after(
                "registration",
                Shown.acts(0, "bot1", "do_register", "bot1"),
                Shown.acts(0, "bot1", "give_up", "bot1"),
                Shown.failed(0, "bot1")))
        .containsExactly("JOINING", "JOINING", "OUT");
  }

  @Test
  void aBarrierWaitsFromTheArrivalToTheOutcome() {
    ProcessId other = ProcessId.parse("bot2");
    assertThat(
            after(
                "barrier",
                acts("barrier", BarrierFact.ARRIVE, new BarrierAction.arrive(ME, 1)),
                shows("barrier", BarrierFact.OUTCOME, BarrierOutcome.NONE_YET),
                shows("barrier", BarrierFact.OUTCOME, new BarrierOutcome.Passed(1)),
                acts("barrier", BarrierFact.ARRIVE, new BarrierAction.arrive(ME, 2)),
                shows(
                    "barrier",
                    BarrierFact.OUTCOME,
                    new BarrierOutcome.Failed(2, new TreeSet<>(Set.of(other))))))
        .containsExactly("WAITING", "WAITING", "PASSED", "WAITING", "FAILED");
  }

  @Test
  void anElectionKnowsALeaderOrWaits() {
    assertThat(
            after(
                "election",
                shows("election", ElectionFact.LEADER, Leader.NONE),
                acts("election", ElectionFact.DO_ELECTION, new ElectionAction.do_election(ME)),
                shows("election", ElectionFact.LEADER, new Leader.Name(ProcessId.parse("bot2"), 1)),
                shows("election", ElectionFact.LEADER, Leader.NONE),
                shows("election", ElectionFact.LEADER, Leader.FAIL)))
        .containsExactly("NO_CANDIDATE", "WAITING", "KNOWS_LEADER", "WAITING", "FAILED");
  }

  @Test
  void anAgreementStaysDecided() {
    TraceEvent proposes =
        acts("agreement", AgreementFact.PROPOSE, new AgreementAction.propose(BOT, "0a"));
    Value value = Value.of(new byte[] {10});
    assertThat(
            after(
                "agreement",
                shows("agreement", AgreementFact.DECIDED, new Decision.NoneYet<>()),
                proposes,
                shows("agreement", AgreementFact.FAILED, true),
                proposes,
                shows("agreement", AgreementFact.DECIDED, new Decision.Decided<>("x", value)),
                proposes))
        .containsExactly("IDLE", "PROPOSING", "FAILED", "PROPOSING", "DECIDED", "DECIDED");
  }

  @Test
  void aGeocastIsCastingUntilItsFlagIsTrue() {
    GeocastId id = new GeocastId(ME, 1);
    assertThat(
            after(
                "geocast",
                shows("geocast", GeocastFact.GCASTFLAG, false),
                acts(
                    "geocast",
                    GeocastFact.SHAPE,
                    new GeocastFact.do_geocast(id, new Everywhere(), 1)),
                shows("geocast", GeocastFact.GCASTFLAG, true)))
        .containsExactly("IDLE", "CASTING", "IDLE");
    assertThat(
            after(
                "broadcast",
                acts(
                    "broadcast", GeocastFact.SHAPE, new GeocastFact.BCast(id, new Everywhere(), 1)),
                acts("broadcast", GeocastFact.SHAPE, new GeocastFact.copy(id)),
                shows("broadcast", GeocastFact.GCASTFLAG, true)))
        .containsExactly("CASTING", "CASTING", "IDLE");
  }

  @Test
  void tubesHaveThePhasesOfTheirFlag() {
    assertThat(
            after(
                "tubes",
                shows("tubes", TubeFact.FLAG, TubeFlag.PLANNING),
                shows("tubes", TubeFact.HELD, new TubeList(List.of())),
                shows("tubes", TubeFact.FLAG, TubeFlag.DONE)))
        .containsExactly("PLANNING", "PLANNING", "DONE");
  }
}
