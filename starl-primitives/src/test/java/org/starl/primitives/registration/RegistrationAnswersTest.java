package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.chaos.Weather;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationProtocol.Phase;
import org.starl.trace.Instance;

/** What one robot does at once: without its answer, a repetition would do the same later. */
class RegistrationAnswersTest {

  private static final Weather TEN_MS = new Weather(0, 0, 10, 10, 0);

  @Test
  void anAttemptThatFailedIsNotMadeWhenAMajorityIsBack() {
    Town town = new Town(3, 4, 4, new RegistrationSpec());
    town.settings = town.settings.withDeadlineMs(3_000);
    town.startAll();
    town.robot(2).crash();
    town.robot(3).crash();
    town.robot(0).do_register();
    town.runForMs(3_010);
    town.robot(2).start();
    town.robot(3).start();
    town.runForMs(20_000);
    assertThat(town.robot(1).protocol().view().number()).isZero();
    assertThat(town.trace).anySatisfy(e -> assertThat(e.toString()).contains("give_up"));
  }

  /** bot3, which is no acceptor and has seen a full list, tries to join. */
  private static Town waitsForRoom() {
    Town town = new Town(1, 4, 3, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    View full = View.NONE.next();
    while (ViewFormat.fitsWithRoom(full)) {
      full = full.with(ProcessId.first(new RobotId("member" + full.ids().size()), 1));
    }
    town.robot(3).protocol().learned(1, ViewFormat.toValue(full));
    town.robot(3).do_register();
    return town;
  }

  @Test
  void aJoinWaitsForRoom() {
    Town town = waitsForRoom();
    RegistrationProtocol joins = town.robot(3).protocol();
    long sent = town.sent();
    town.runForMs(2 * town.settings.queryMs());
    assertThat(town.sent()).as("it asks for a newer view").isGreaterThan(sent);
    assertThat(joins.waitsFor(Instance.APP).toString()).contains("room");
    View roomy = View.NONE.next().next().with(ProcessId.first(new RobotId("bot1"), 1));
    joins.learned(2, ViewFormat.toValue(roomy));
    town.runForMs(1_000);
    assertThat(joins.phase()).isEqualTo(Phase.IN);
  }

  @Test
  void aJoinWithoutRoomFailsAtItsDeadline() {
    Town town = waitsForRoom();
    RegistrationProtocol joins = town.robot(3).protocol();
    town.runForMs(town.settings.deadlineMs() - 10);
    assertThat(joins.hasFailed()).isFalse();
    town.runForMs(20);
    assertThat(joins.hasFailed()).isTrue();
    assertThat(joins.phase()).isEqualTo(Phase.OUT);
    assertThat(joins.waitsFor(Instance.APP).toString()).contains("room");
  }

  @Test
  void aRobotThatIsOvertakenAsksAgainUnderItsId() {
    Town town = fourUp();
    town.robot(0).do_register();
    ProcessId first = town.robot(0).protocol().me();
    View others = View.NONE.next().with(ProcessId.first(new RobotId("bot3"), 1));
    town.robot(0).protocol().learned(1, ViewFormat.toValue(others));
    assertThat(town.robot(0).protocol().me()).as("it was not in view 1").isEqualTo(first);
    town.robot(0).protocol().learned(3, ViewFormat.toValue(others.next().next()));
    assertThat(town.robot(0).protocol().me()).as("it may be in view 2").isNotEqualTo(first);
    assertThat(town.trace)
        .anySatisfy(e -> assertThat(e.toString()).contains("give_up", first.toString()));
  }

  @Test
  void aMemberThatIsIdleLeaves() {
    Town town = fourUp();
    town.robot(0).do_register();
    town.runForMs(100);
    ProcessId me = town.robot(0).protocol().me();
    town.robot(0).protocol().markIdle(me, town.nowNs());
    assertThat(town.robot(0).protocol().phase()).isEqualTo(Phase.OUT);
    assertThat(town.robot(0).protocol().hasFailed()).as("it is told").isTrue();
    town.runForMs(50);
    assertThat(town.robot(1).protocol().view().mentions(me)).isFalse();
  }

  @Test
  void aRobotIsUnregisteredWhenItsEarlierIdsHaveLeftToo() {
    Town town = fourUp();
    RegistrationProtocol leaves = town.robot(0).protocol();
    town.robot(0).do_register();
    View first = View.NONE.next().with(leaves.me());
    leaves.learned(1, ViewFormat.toValue(first));
    leaves.markIdle(leaves.me(), town.nowNs());
    town.robot(0).do_register();
    leaves.learned(2, ViewFormat.toValue(first.next().with(leaves.me())));
    town.robot(0).unregister();
    leaves.learned(3, ViewFormat.toValue(first.next().next()));
    assertThat(leaves.isUnregistered()).as("the first id is listed").isFalse();
    leaves.learned(4, ViewFormat.toValue(View.NONE.next().next().next().next()));
    assertThat(leaves.isUnregistered()).isTrue();
  }

  @Test
  void aRobotThatOthersRemovedIsUnregisteredAtOnce() {
    Town town = fourUp();
    town.robots.values().forEach(TownRobot::do_register);
    town.runForMs(3_000);
    ProcessId wronged = town.robot(3).protocol().me();
    ProcessId fencer = town.robot(0).protocol().me();
    town.robot(0)
        .protocol()
        .confine(
            new Confinement(wronged, new TreeSet<>(), new TreeSet<>(List.of(fencer))),
            town.nowNs());
    town.runForMs(500);
    assertThat(town.robot(3).protocol().phase()).isEqualTo(Phase.OUT);
    town.robot(3).unregister();
    assertThat(town.robot(3).protocol().phase()).isEqualTo(Phase.OUT);
    assertThat(town.robot(3).protocol().isUnregistered()).isTrue();
    assertThat(town.robot(3).protocol().hasFailed()).isFalse();
  }

  @Test
  void aRobotIsUnregisteredWhenAllKnowOrTheBoundHasPassed() {
    Town town = new Town(9, 5, 3, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    for (int i : List.of(0, 4)) {
      town.robot(i).do_register();
      town.runForMs(500);
    }
    // Robot 4, which is no acceptor, hears of nothing.
    town.cutAt = 4;
    town.robot(0).unregister();
    town.runForMs(500);
    assertThat(town.robot(0).protocol().phase()).isEqualTo(Phase.OUT);
    assertThat(town.robot(0).protocol().isUnregistered()).as("robot 4 may not know").isFalse();
    town.runForMs(30_000);
    assertThat(town.robot(0).protocol().isUnregistered()).isTrue();
  }

  @Test
  void whoIsRemovedOrAdmittedHearsOfItAtOnce() {
    Town town = new Town(9, 5, 3, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    for (int i : List.of(0, 4)) {
      town.robot(i).do_register();
      town.runForMs(500);
    }
    ProcessId wronged = town.robot(4).protocol().me();
    ProcessId fencer = town.robot(0).protocol().me();
    town.robot(0)
        .protocol()
        .confine(
            new Confinement(wronged, new TreeSet<>(), new TreeSet<>(List.of(fencer))),
            town.nowNs());
    town.runForMs(60);
    assertThat(town.robot(4).protocol().phase()).isEqualTo(Phase.OUT);
  }

  @Test
  void aRobotWithoutAViewAsksAllForItBeforeItStandsIn() {
    Town town = new Town(9, 5, 3, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    town.robot(4).do_register();
    town.runForMs(100);
    town.robot(4).crash();
    town.robot(4).start();
    town.robot(4).protocol().standsIn(new TreeSet<>(), town.nowNs());
    town.runForMs(20);
    assertThat(town.robot(4).protocol().view().number()).isEqualTo(1);
  }

  @Test
  void aRobotThatStandsInAsksUntilItHasAView() {
    Town town = new Town(9, 5, 3, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    town.robot(3).do_register();
    town.runForMs(100);
    town.cutAt = 4;
    town.robot(4).tidy();
    town.runForMs(town.settings.queryMs());
    town.cutAt = 0;
    town.runForMs(2 * town.settings.queryMs());
    assertThat(town.robot(4).protocol().view().number()).isEqualTo(1);
  }

  @Test
  void aRobotDoesNotCompleteAViewInPlaceOfItsOwnProposal() {
    Town town = fourUp();
    for (int i : List.of(0, 3)) {
      town.robot(i).do_register();
      town.runForMs(500);
    }
    ProcessId gone = town.robot(3).protocol().me();
    ProcessId fencer = town.robot(0).protocol().me();
    town.robot(2).crash();
    town.robot(3).crash();
    town.robot(0)
        .protocol()
        .confine(
            new Confinement(gone, new TreeSet<>(), new TreeSet<>(List.of(fencer))), town.nowNs());
    town.runForMs(4 * town.settings.nullMs());
    town.robot(2).start();
    town.runUntil(() -> town.robot(0).protocol().view().number() > 2, 20_000);
    assertThat(town.robot(0).protocol().view().mentions(gone)).isFalse();
  }

  @Test
  void anUnregisterThatIsCalledAgainHasNotFailedYet() {
    Town town = fourUp();
    town.robot(0).do_register();
    town.runForMs(500);
    town.robot(2).crash();
    town.robot(3).crash();
    town.robot(0).unregister();
    town.runForMs(town.settings.deadlineMs() + 10);
    assertThat(town.robot(0).protocol().phase()).isEqualTo(Phase.LEFT_HALFWAY);
    assertThat(town.robot(0).protocol().hasFailed()).isTrue();
    town.robot(0).unregister();
    assertThat(town.robot(0).protocol().hasFailed()).isFalse();
  }

  @Test
  void aRefreshAsksAllForTheLatestView() {
    Town town = new Town(9, 5, 3, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    town.robot(3).do_register();
    town.runForMs(100);
    assertThat(town.robot(4).protocol().view().number()).isZero();
    town.robot(4).protocol().refresh(town.nowNs());
    town.runForMs(20);
    assertThat(town.robot(4).protocol().view().number()).isEqualTo(1);
  }

  @Test
  void aRobotThatLeftAsksNothingMore() {
    Town town = fourUp();
    town.robot(0).do_register();
    town.runForMs(100);
    town.robot(0).unregister();
    town.runForMs(30_000);
    long sent = town.sent();
    town.runForMs(30_000);
    assertThat(town.sent()).isEqualTo(sent);
  }

  private static Town fourUp() {
    Town town = new Town(1, 4, 4, new RegistrationSpec());
    town.weather = TEN_MS;
    town.startAll();
    return town;
  }
}
