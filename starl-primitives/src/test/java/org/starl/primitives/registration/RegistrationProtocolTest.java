package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.primitives.chaos.Weather;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationProtocol.Phase;
import org.starl.spec.SpecReport;

class RegistrationProtocolTest {

  private static final Weather TEN_MS = new Weather(0, 0, 10, 10, 0);

  @Property(tries = 400)
  void theSpecificationHoldsUnderFaultsAndAllChangesComeAfterHealing(@ForAll long seed) {
    Life life = new Life(seed);
    SpecReport report = life.live();
    assertThat(report.holds()).as("seed %d: %s", seed, report).isTrue();
    assertThat(life.gotWell).as("seed %d: healed, and all got what they want", seed).isTrue();
  }

  @Test
  void aJoinThatKnowsTheNumberTakesFourMessageDelays() {
    Town town = fourUp();
    long beganMs = town.nowMs();
    town.robot(0).do_register();
    assertThat(town.runUntil(() -> isIn(town, 0), 1_000)).isTrue();
    assertThat(town.nowMs() - beganMs).isEqualTo(40);
  }

  @Test
  void aJoinThatMustLearnTheNumberTakesSixMessageDelays() {
    Town town = new Town(1, 5, 4, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    town.robot(1).do_register();
    town.runForMs(500);
    long beganMs = town.nowMs();
    town.robot(4).do_register();
    assertThat(town.runUntil(() -> isIn(town, 4), 1_000)).isTrue();
    assertThat(town.nowMs() - beganMs).isEqualTo(60);
  }

  @Test
  void othersHearOfAJoinOneMessageDelayLater() {
    Town town = fourUp();
    town.robot(0).do_register();
    town.runForMs(50);
    assertThat(town.robots.values())
        .allSatisfy(robot -> assertThat(robot.protocol().view().number()).isEqualTo(1));
  }

  @Property(tries = 50)
  void simultaneousJoinsUnderLossSucceedWithinSeconds(@ForAll long seed) {
    Town town = new Town(seed, 4, 4, new RegistrationSpec());
    town.weather = Weather.LOSSY;
    town.startAll();
    town.robots.values().forEach(robot -> robot.wantsIn = true);
    town.robots.values().forEach(TownRobot::pursue);
    assertThat(
            town.runUntil(
                () -> town.robots.values().stream().allMatch(TownRobot::isSatisfied), 20_000))
        .isTrue();
    assertThat(town.finish().holds()).isTrue();
  }

  @Test
  void withoutAMajorityAJoinFails() {
    Town town = new Town(3, 4, 4, new RegistrationSpec());
    town.settings = town.settings.withDeadlineMs(3_000);
    town.startAll();
    town.robot(2).crash();
    town.robot(3).crash();
    town.robot(0).do_register();
    town.runForMs(2_990);
    assertThat(town.robot(0).protocol().hasFailed()).isFalse();
    town.runForMs(20);
    assertThat(town.robot(0).protocol().hasFailed()).isTrue();
    assertThat(town.robot(0).protocol().phase()).isEqualTo(Phase.OUT);
  }

  @Test
  void anAbandonedAttemptThatOthersCompleteIsRemoved() {
    Town town = new Town(5, 3, 3, new RegistrationSpec());
    town.weather = TEN_MS;
    town.settings = town.settings.withDeadlineMs(25);
    town.startAll();
    town.robot(0).do_register();
    ProcessId firstAttempt = town.robot(0).protocol().me();
    town.runForMs(26);
    assertThat(town.robot(0).protocol().hasFailed()).isTrue();
    town.settings = town.settings.withDeadlineMs(10_000);
    town.robot(1).crash();
    town.robot(1).start();
    town.robot(1).do_register();
    assertThat(town.runUntil(() -> isIn(town, 1), 5_000)).isTrue();
    assertThat(town.trace).anySatisfy(e -> assertThat(e.toString()).contains("1:" + firstAttempt));
    town.runForMs(5_000);
    assertThat(town.robot(1).protocol().view().contains(firstAttempt)).isFalse();
    assertThat(town.robot(0).protocol().me()).isNotEqualTo(firstAttempt);
    assertThat(town.finish().holds()).isTrue();
  }

  @Test
  void anUnregisteredRobotMayRegisterUnderAnotherId() {
    Town town = fourUp();
    town.robot(0).do_register();
    town.runForMs(100);
    ProcessId first = town.robot(0).protocol().me();
    town.robot(0).unregister();
    assertThat(town.robot(0).protocol().isUnregistered()).isFalse();
    town.runForMs(600);
    assertThat(town.robot(0).protocol().isUnregistered()).isTrue();
    assertThat(town.robot(0).protocol().view().admitted()).isEmpty();
    town.robot(0).do_register();
    assertThat(town.robot(0).protocol().isUnregistered()).isFalse();
    town.runForMs(100);
    assertThat(isIn(town, 0)).isTrue();
    assertThat(town.robot(0).protocol().me()).isNotEqualTo(first);
  }

  @Test
  void theListIsNullWhileANewerOneIsExpectedUpToTheBound() {
    Town town = fourUp();
    town.robot(0).do_register();
    town.runForMs(100);
    assertThat(town.robot(0).protocol().rList().isAgreed()).isTrue();
    town.robot(1).do_register();
    town.runForMs(15);
    assertThat(town.robot(0).protocol().rList().isAgreed()).isFalse();
    town.robot(1).crash();
    town.runForMs(town.settings.nullMs());
    assertThat(town.robot(0).protocol().rList().isAgreed()).isTrue();
  }

  @Test
  void aMemberThatMissedAViewAsksForIt() {
    Town town = new Town(9, 5, 3, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    town.robot(4).do_register();
    town.runForMs(100);
    // Robot 4 hears nothing of the next view: longer than it is repeated.
    town.cutAt = 4;
    town.robot(3).do_register();
    town.runForMs(15_000);
    assertThat(town.robot(4).protocol().view().number()).isEqualTo(1);
    town.cutAt = 0;
    town.runForMs(3_000);
    assertThat(town.robot(4).protocol().view().number()).isEqualTo(2);
  }

  @Test
  void aRobotThatMissedItsAdmissionAndItsRemovalAsksUnderAnotherId() {
    Town town = new Town(9, 5, 5, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    town.robot(0).do_register();
    town.runForMs(1_000);
    town.robot(4).do_register();
    town.runForMs(15);
    // The others know its wish. From now on robot 4 hears nothing of them.
    town.cutAt = 4;
    ProcessId first = town.robot(4).protocol().me();
    town.robot(3).do_register();
    town.runForMs(3_000);
    assertThat(town.robot(0).protocol().view().contains(first)).isTrue();
    ProcessId fencer = town.robot(0).protocol().me();
    town.robot(0)
        .protocol()
        .confine(
            new Confinement(first, new TreeSet<>(), new TreeSet<>(List.of(fencer))), town.nowNs());
    town.runForMs(1_000);
    assertThat(town.robot(0).protocol().view().mentions(first)).isFalse();
    town.cutAt = 0;
    assertThat(town.runUntil(() -> isIn(town, 4), 10_000)).isTrue();
    assertThat(town.robot(4).protocol().me()).isNotEqualTo(first);
    SpecReport report = town.finish();
    assertThat(report.holds()).as("%s", report).isTrue();
  }

  @Property(tries = 50)
  void aRobotThatLeavesBeforeOthersKnowIsForgotten(@ForAll long seed) {
    Town town = new Town(seed, 5, 5, new RegistrationSpec());
    town.startAll();
    town.robots.values().forEach(TownRobot::do_register);
    town.runForMs(3_000);
    ProcessId gone = town.robot(0).protocol().me();
    town.newsIsLost = true;
    town.robot(0).unregister();
    assertThat(town.runUntil(() -> town.robot(0).protocol().phase() == Phase.OUT, 5_000)).isTrue();
    town.robot(0).crash();
    for (int i = 1; i < 5; i++) {
      assertThat(town.robot(i).protocol().view().contains(gone)).isTrue();
    }
    town.newsIsLost = false;
    town.weather = Weather.LOSSY;
    town.runForMs(12_000);
    for (int i = 1; i < 5; i++) {
      assertThat(town.robot(i).protocol().view().contains(gone)).isFalse();
    }
    assertThat(town.finish().holds()).isTrue();
  }

  @Test
  void aConfinedRobotIsRemovedAndItsGhostGoesAfterStandsIn() {
    Town town = fourUp();
    town.robots.values().forEach(TownRobot::do_register);
    town.runForMs(3_000);
    ProcessId wronged = town.robot(3).protocol().me();
    ProcessId fencer = town.robot(0).protocol().me();
    Confinement confinement =
        new Confinement(wronged, new TreeSet<>(List.of("A")), new TreeSet<>(List.of(fencer)));
    town.robot(0).protocol().confine(confinement, town.nowNs());
    town.runForMs(500);
    assertThat(town.robot(1).protocol().view().ghost(wronged)).isNotNull();
    assertThat(town.robot(3).protocol().phase()).isEqualTo(Phase.OUT);
    assertThat(town.robot(3).protocol().rList().isAgreed()).isFalse();
    assertThat(town.robot(3).protocol().hasFailed()).as("it is told").isTrue();
    town.robot(3).do_register();
    assertThat(town.robot(3).protocol().hasFailed()).isFalse();
    town.runForMs(500);
    assertThat(isIn(town, 3)).isTrue();
    assertThat(town.robot(1).protocol().view().ghost(wronged)).isNotNull();
    town.robot(3).tidy();
    town.runForMs(500);
    assertThat(town.robot(1).protocol().view().mentions(wronged)).isFalse();
    assertThat(town.finish().holds()).isTrue();
  }

  @Test
  void aConfinedRobotMayUnregister() {
    Town town = fourUp();
    town.robots.values().forEach(TownRobot::do_register);
    town.runForMs(3_000);
    ProcessId fencer = town.robot(0).protocol().me();
    Confinement confinement =
        new Confinement(
            town.robot(3).protocol().me(),
            new TreeSet<>(List.of("A")),
            new TreeSet<>(List.of(fencer)));
    town.robot(0).protocol().confine(confinement, town.nowNs());
    town.runForMs(500);
    town.robot(3).unregister();
    assertThat(town.robot(3).protocol().isUnregistered()).isFalse();
    town.runForMs(700);
    assertThat(town.robot(3).protocol().isUnregistered()).isTrue();
    assertThat(town.robot(1).protocol().view().ghosts()).isEmpty();
    SpecReport report = town.finish();
    assertThat(report.holds()).as("%s", report).isTrue();
  }

  @Test
  void theNextStartOfACrashedRobotConfinesItsOldId() {
    Town town = fourUp();
    town.robots.values().forEach(TownRobot::do_register);
    town.runForMs(3_000);
    ProcessId dead = town.robot(3).protocol().me();
    town.robot(3).crash();
    town.robot(3).start();
    town.robot(3).protocol().standsIn(new TreeSet<>(List.of("A", "B")), town.nowNs());
    town.runForMs(4_000);
    View.Ghost ghost = town.robot(0).protocol().view().ghost(dead);
    assertThat(ghost)
        .isEqualTo(new View.Ghost(ghost.admittedBy(), new TreeSet<>(List.of("A", "B"))));
    town.robot(3).protocol().standsIn(new TreeSet<>(List.of("B", "C")), town.nowNs());
    town.runForMs(1_000);
    assertThat(town.robot(0).protocol().view().ghost(dead).sections()).containsExactly("B");
    town.robot(3).tidy();
    town.runForMs(1_000);
    assertThat(town.robot(0).protocol().view().mentions(dead)).isFalse();
    assertThat(town.finish().holds()).isTrue();
  }

  @Property(tries = 50)
  void aFewRoadsideAcceptorsServeManyRobotsThoughOneIsDown(@ForAll long seed) {
    Town town = new Town(seed, 7, 3, new RegistrationSpec());
    town.weather = Weather.LOSSY;
    town.startAll();
    town.robot((int) Math.floorMod(seed, 3L)).crash();
    for (int i = 3; i < 7; i++) {
      town.robot(i).wantsIn = true;
      town.robot(i).pursue();
    }
    assertThat(town.runUntil(() -> satisfied(town, 3, 7), 30_000)).isTrue();
    View list = town.robot(6).protocol().view();
    assertThat(list.participants().asList()).doesNotContainAnyElementsOf(town.acceptors);
    for (int i = 3; i < 7; i++) {
      town.robot(i).wantsIn = false;
      town.robot(i).pursue();
    }
    assertThat(town.runUntil(() -> satisfied(town, 3, 7), 30_000)).isTrue();
    assertThat(town.finish().holds()).isTrue();
  }

  @Test
  void aCrashDuringAChangeNeitherStopsItNorRemovesTheMember() {
    for (long seed = 0; seed < 50; seed++) {
      Town town = new Town(seed, 5, 5, new RegistrationSpec());
      town.startAll();
      for (int i = 0; i < 3; i++) {
        town.robot(i).do_register();
      }
      town.runForMs(3_000);
      ProcessId crashed = town.robot(0).protocol().me();
      town.robot(3).do_register();
      town.robot(4).do_register();
      town.robot(1).unregister();
      town.runForMs(seed);
      town.robot(0).crash();
      assertThat(town.runUntil(() -> isIn(town, 3) && isIn(town, 4), 20_000)).isTrue();
      assertThat(town.robot(3).protocol().view().contains(crashed)).isTrue();
      assertThat(town.finish().holds()).as("seed %d", seed).isTrue();
    }
  }

  @Test
  void callsInTheWrongPhaseThrow() {
    Town town = fourUp();
    assertThatThrownBy(() -> town.robot(0).unregister()).isInstanceOf(IllegalStateException.class);
    town.robot(0).do_register();
    // A program cannot know whether it is registered: the list may be null for a while.
    town.robot(0).do_register();
    assertThat(town.runUntil(() -> isIn(town, 0), 20_000)).isTrue();
    town.robot(0).do_register();
    assertThat(isIn(town, 0)).isTrue();
    town.robot(0).unregister();
    assertThatThrownBy(() -> town.robot(0).do_register()).isInstanceOf(IllegalStateException.class);
  }

  @Test
  void aRobotThatWasEvictedAndFailsToComeBackIsOut() {
    Town town = fourUp();
    town.robots.values().forEach(TownRobot::do_register);
    town.runForMs(3_000);
    ProcessId evicted = town.robot(3).protocol().me();
    ProcessId fencer = town.robot(0).protocol().me();
    town.robot(0)
        .protocol()
        .confine(
            new Confinement(evicted, new TreeSet<>(), new TreeSet<>(List.of(fencer))),
            town.nowNs());
    assertThat(town.runUntil(() -> town.robot(3).protocol().phase() == Phase.OUT, 5_000)).isTrue();
    town.robot(1).crash();
    town.robot(2).crash();
    town.robot(3).do_register();
    assertThat(town.runUntil(() -> town.robot(3).protocol().hasFailed(), 60_000)).isTrue();
    assertThatThrownBy(() -> town.robot(3).unregister()).isInstanceOf(IllegalStateException.class);
  }

  @Test
  void unregisterThatWasGivenUpMayBeCalledAgainAfterItHasEnded() {
    Town town = fourUp();
    town.robot(0).do_register();
    assertThat(town.runUntil(() -> isIn(town, 0), 20_000)).isTrue();
    town.robot(0).unregister();
    assertThat(town.runUntil(() -> town.robot(0).protocol().isUnregistered(), 20_000)).isTrue();
    // What a program does that has seen the deadline pass, and not yet the end.
    town.robot(0).unregister();
    assertThat(town.robot(0).protocol().isUnregistered()).isTrue();
    assertThat(town.finish().holds()).isTrue();
  }

  private static Town fourUp() {
    Town town = new Town(1, 4, 4, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    return town;
  }

  private static boolean satisfied(Town town, int from, int to) {
    for (int i = from; i < to; i++) {
      if (!town.robot(i).isSatisfied()) {
        return false;
      }
    }
    return true;
  }

  private static boolean isIn(Town town, int index) {
    return town.robot(index).protocol().phase() == Phase.IN;
  }
}
