package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.primitives.barrier.BarrierOutcome.Excluded;
import org.starl.primitives.barrier.BarrierOutcome.Failed;
import org.starl.primitives.barrier.BarrierOutcome.Passed;
import org.starl.primitives.barrier.BarrierOutcome.Unknown;
import org.starl.spec.SpecReport;

class BarrierProtocolTest {

  @Property(tries = 80)
  void theSpecificationHoldsUnderFaultsAndMembersContinueAfterHealing(@ForAll long seed) {
    Gathering gathering = Gathering.drawn(seed);
    boolean well = gathering.live();
    SpecReport report = gathering.finish();
    assertThat(report.holds()).as("seed %d: %s", seed, report).isTrue();
    assertThat(well).as("seed %d: healed, and the members go on", seed).isTrue();
  }

  /**
   * Two of six are left, the last in the order in which robots propose; four that come before them had
   * arrived and crashed, and a deadline is shorter than their turns.
   */
  @Test
  void theLastProposerInOrderProposesBeforeItsDeadline() {
    assertThat(Gathering.drawn(-78).live()).isTrue();
  }

  /** In a life of its own a member may be alone, and is owed nothing; in most it is. */
  @Test
  void mostRandomRunsCheckNotHung() {
    int checked = 0;
    for (long seed = 1; seed <= 20; seed++) {
      Gathering gathering = Gathering.drawn(seed);
      gathering.live();
      checked += gathering.finish().checks(BarrierSpec.NOT_HUNG) > 0 ? 1 : 0;
    }
    assertThat(checked).isGreaterThan(10);
  }

  @Test
  void theLastArrivalReleasesAllWithinSixMessageDelays() {
    Gathering gathering = Gathering.up(5, BarrierSettings.DEFAULT);
    for (int i = 0; i < 4; i++) {
      gathering.world.robots.get(i).arrive();
    }
    gathering.world.runForMs(3_000);
    assertThat(gathering.world.robots).noneMatch(m -> m.outcome().isTold());
    gathering.world.robots.get(4).arrive();
    assertThat(gathering.world.runUntil(() -> allPassed(gathering, 1), 1_000)).isTrue();
    assertThat(gathering.world.nowMs()).isEqualTo(3_000 + 6 * 10);
    assertThat(gathering.finish().holds()).isTrue();
  }

  @Test
  void theBarrierIsReusable() {
    Gathering gathering = Gathering.up(4, BarrierSettings.DEFAULT);
    for (int generation = 1; generation <= 20; generation++) {
      int passed = generation;
      gathering.world.robots.forEach(Member::arrive);
      assertThat(gathering.world.runUntil(() -> allPassed(gathering, passed), 1_000)).isTrue();
    }
    assertThat(gathering.finish().checks(BarrierSpec.NO_EARLY)).isEqualTo(80);
  }

  @Test
  void anArrivalThatComesBeforeItsGenerationIsKept() {
    Gathering gathering = Gathering.up(2, BarrierSettings.DEFAULT);
    gathering.world.robots.forEach(Member::arrive);
    Member early = gathering.world.robots.get(0);
    Member late = gathering.world.robots.get(1);
    gathering.world.runUntil(() -> early.outcome().isTold(), 1_000);
    assertThat(late.outcome().isTold()).isFalse();
    early.arrive();
    gathering.world.runForMs(15);
    assertThat(late.outcome()).isEqualTo(new Passed(1));
    late.arrive();
    assertThat(gathering.world.runUntil(() -> allPassed(gathering, 2), 100)).isTrue();
  }

  @Test
  void aCrashedMemberIsExcludedAndAllAreToldTheSame() {
    Gathering gathering = Gathering.up(4, BarrierSettings.DEFAULT.withSilenceMs(2_000));
    Member dead = gathering.world.robots.get(3);
    dead.crash();
    for (int i = 0; i < 3; i++) {
      gathering.world.robots.get(i).arrive();
    }
    gathering.world.runForMs(2_000 + 100);
    Failed withoutTheDead = new Failed(1, new TreeSet<>(List.of(gathering.first().last())));
    for (int i = 0; i < 3; i++) {
      assertThat(gathering.world.robots.get(i).outcome()).isEqualTo(withoutTheDead);
      gathering.world.robots.get(i).arrive();
    }
    gathering.world.runForMs(100);
    assertThat(gathering.world.robots.get(0).outcome()).isEqualTo(new Passed(2));
    dead.start();
    dead.arrive();
    assertThat(dead.outcome())
        .as("a restarted robot is another participant")
        .isEqualTo(new Excluded(0));
    assertThat(gathering.finish().holds()).isTrue();
  }

  @Test
  void anAbsentLiveMemberIsExcludedAtTheDeadline() {
    Gathering gathering = Gathering.up(3, BarrierSettings.DEFAULT.withDeadlineMs(10_000));
    Member slow = gathering.world.robots.get(2);
    gathering.world.robots.get(0).arrive();
    gathering.world.robots.get(1).arrive();
    gathering.world.runForMs(9_999);
    assertThat(gathering.world.robots.get(0).outcome().isTold()).isFalse();
    gathering.world.runForMs(100);
    assertThat(gathering.world.robots.get(0).outcome()).isInstanceOf(Failed.class);
    slow.arrive();
    gathering.world.runForMs(100);
    assertThat(slow.outcome()).isEqualTo(new Excluded(1));
    slow.arrive();
    assertThat(slow.outcome()).isEqualTo(new Excluded(1));
  }

  @Test
  void withoutAMajorityTheOutcomeIsUnknownAndArrivingAgainContinuesTheWait() {
    Gathering gathering = Gathering.up(4, BarrierSettings.DEFAULT.withDeadlineMs(5_000));
    gathering.world.robots.get(2).crash();
    gathering.world.robots.get(3).crash();
    Member member = gathering.world.robots.get(0);
    member.arrive();
    gathering.world.robots.get(1).arrive();
    gathering.world.runForMs(9_999);
    assertThat(member.outcome().isTold()).isFalse();
    gathering.world.runForMs(1);
    assertThat(member.outcome()).isEqualTo(new Unknown(1));
    gathering.world.robots.get(2).start();
    member.arrive();
    assertThat(member.protocol().generation()).isEqualTo(1);
    assertThat(gathering.world.runUntil(() -> member.outcome().isTold(), 9_000)).isTrue();
    assertThat(member.outcome()).isInstanceOf(Failed.class);
    assertThat(gathering.finish().holds()).isTrue();
  }

  @Test
  void aDisconnectedMemberLearnsAllMissedOutcomes() {
    Gathering gathering = Gathering.up(4, BarrierSettings.DEFAULT.withSilenceMs(2_000));
    Member cut = gathering.world.robots.get(3);
    cut.arrive();
    gathering.world.runForMs(20);
    gathering.world.cutAt(3);
    for (int generation = 1; generation <= 3; generation++) {
      for (int i = 0; i < 3; i++) {
        gathering.world.robots.get(i).arrive();
      }
      gathering.world.runForMs(3_000);
    }
    assertThat(gathering.world.robots.get(0).outcome()).isEqualTo(new Passed(3));
    gathering.world.cutAt(0);
    gathering.world.runForMs(1_000);
    assertThat(cut.outcome()).as("it had arrived in 1 before").isEqualTo(new Passed(1));
    cut.arrive();
    assertThat(cut.outcome()).isEqualTo(new Excluded(2));
    assertThat(gathering.finish().holds()).isTrue();
  }

  @Test
  void arrivingWhileWaitingThrows() {
    Gathering gathering = Gathering.up(2, BarrierSettings.DEFAULT);
    Member member = gathering.world.robots.get(0);
    member.arrive();
    assertThatThrownBy(member::arrive).isInstanceOf(IllegalStateException.class);
  }

  private static boolean allPassed(Gathering gathering, long generation) {
    return gathering.world.robots.stream()
        .allMatch(m -> m.outcome().equals(new Passed(generation)));
  }
}
