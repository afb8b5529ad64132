package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.id.ProcessId;
import org.starl.primitives.chaos.LiveRobot;
import org.starl.primitives.chaos.Weather;
import org.starl.spec.SpecReport;

class ElectionProtocolTest {

  @Property(tries = 150)
  void theSpecificationHoldsUnderFaultsAndAllFollowOneLiveLeaderAfterHealing(@ForAll long seed) {
    liveAndCheck(seed, true);
  }

  @Property(tries = 100)
  void theRemainingRobotsFollowALiveLeaderAfterCrashes(@ForAll long seed) {
    liveAndCheck(seed, false);
  }

  private static void liveAndCheck(long seed, boolean restarts) {
    Convoy convoy = Convoy.drawn(seed);
    boolean well = convoy.live(restarts);
    SpecReport report = convoy.finish();
    assertThat(report.holds()).as("seed %d: %s", seed, report).isTrue();
    assertThat(well).as("seed %d: healed, and all follow one live leader", seed).isTrue();
    assertThat(report.checks(ElectionSpec.ELECTED)).as("seed %d", seed).isPositive();
  }

  @ParameterizedTest
  @EnumSource
  void candidatesThatStartTogetherAgreeWithinNineMessageDelays(ElectionStrategy strategy) {
    Convoy convoy = Convoy.up(5, ElectionSettings.DEFAULT.withStrategy(strategy));
    convoy.world.robots.forEach(Voter::do_election);
    // 2 of 250 ms to hear of each other, 4 real ones to decide, 1 to tell.
    assertThat(convoy.world.runUntil(convoy::isLedByOne, 2_000)).isTrue();
    assertThat(convoy.world.nowMs()).isEqualTo(2 * 250 + 5 * 10);
    assertThat(convoy.anyUp().protocol().term()).isEqualTo(1);
  }

  @Test
  void bullyElectsTheHighestId() {
    Convoy convoy = Convoy.up(4, ElectionSettings.DEFAULT.withStrategy(ElectionStrategy.BULLY));
    convoy.world.robots.forEach(Voter::do_election);
    convoy.world.runForMs(1_000);
    assertThat(leaderOf(convoy)).isEqualTo(convoy.world.robots.get(3).protocol().me());
  }

  @Test
  void afterOneCallAllRobotsLearnTheLeader() {
    Convoy convoy = Convoy.up(4, ElectionSettings.DEFAULT);
    convoy.world.robots.get(2).do_election();
    convoy.world.runForMs(1_000);
    assertThat(convoy.isLedByOne()).isTrue();
    assertThat(leaderOf(convoy)).isEqualTo(convoy.world.robots.get(2).protocol().me());
  }

  @ParameterizedTest
  @EnumSource
  void aCrashedLeaderIsReplacedWithinItsSilenceAndAnElection(ElectionStrategy strategy) {
    Convoy convoy = Convoy.up(5, ElectionSettings.DEFAULT.withStrategy(strategy));
    convoy.world.robots.forEach(Voter::do_election);
    convoy.world.runForMs(5_000);
    ProcessId first = leaderOf(convoy);
    crashed(convoy, first).crash();
    assertThat(convoy.world.runUntil(convoy::isLedByOne, 2_500 + 250 + 2_000)).isTrue();
    assertThat(leaderOf(convoy)).isNotEqualTo(first);
    assertThat(convoy.anyUp().protocol().term()).isEqualTo(2);
  }

  @Test
  void aRestartedLeaderIsReplacedWithoutWaitingForItsSilence() {
    Convoy convoy = Convoy.up(4, ElectionSettings.DEFAULT);
    convoy.world.robots.forEach(Voter::do_election);
    convoy.world.runForMs(1_000);
    ProcessId first = leaderOf(convoy);
    Voter robot = crashed(convoy, first);
    robot.crash();
    robot.start();
    robot.do_election();
    assertThat(convoy.world.runUntil(convoy::isLedByOne, 1_000)).isTrue();
    assertThat(leaderOf(convoy)).isNotEqualTo(first);
  }

  @Test
  void aLeaderStaysWhileItIsHeard() {
    Convoy convoy = Convoy.up(4, ElectionSettings.DEFAULT);
    convoy.world.robots.forEach(Voter::do_election);
    convoy.world.runForMs(60_000);
    convoy.world.robots.forEach(Voter::do_election);
    convoy.world.runForMs(1_000);
    assertThat(convoy.anyUp().protocol().term()).isEqualTo(1);
  }

  @Test
  void withoutAMajorityLeaderIsFailAtTheDeadlineUntilALeaderIsElected() {
    Convoy convoy = Convoy.up(4, ElectionSettings.DEFAULT.withDeadlineMs(3_000));
    convoy.world.robots.get(2).crash();
    convoy.world.robots.get(3).crash();
    Voter lonely = convoy.world.robots.get(0);
    lonely.do_election();
    convoy.world.runForMs(2_999);
    assertThat(lonely.leader()).isEqualTo(Leader.NONE);
    convoy.world.runForMs(1);
    assertThat(lonely.leader()).isEqualTo(Leader.FAIL);
    convoy.world.robots.get(2).start();
    convoy.world.robots.get(2).do_election();
    convoy.world.runForMs(3_000);
    assertThat(lonely.leader().isElected()).isTrue();
  }

  @Test
  void aDisconnectedLeaderFollowsTheNewOneOnceItHearsOfIt() {
    Convoy convoy = Convoy.up(5, ElectionSettings.DEFAULT.withStrategy(ElectionStrategy.BULLY));
    convoy.world.robots.forEach(Voter::do_election);
    convoy.world.runForMs(1_000);
    Voter old = convoy.world.robots.get(4);
    convoy.world.cutAt(4);
    convoy.world.runForMs(10_000);
    assertThat(old.leader()).isEqualTo(new Leader.Name(old.protocol().me(), 1));
    assertThat(leaderOf(convoy)).isEqualTo(convoy.world.robots.get(3).protocol().me());
    convoy.world.cutAt(0);
    convoy.world.runForMs(1_000);
    assertThat(old.leader()).isEqualTo(convoy.anyUp().leader());
    assertThat(convoy.finish().holds()).isTrue();
  }

  @Test
  void aRobotThatNeverCallsDoElectionIsNeverElected() {
    Convoy convoy = Convoy.up(3, ElectionSettings.DEFAULT.withStrategy(ElectionStrategy.BULLY));
    convoy.world.weather(Weather.LOSSY);
    convoy.world.robots.get(0).do_election();
    convoy.world.robots.get(1).do_election();
    convoy.world.runForMs(5_000);
    convoy.world.robots.get(1).crash();
    convoy.world.runForMs(10_000);
    assertThat(leaderOf(convoy)).isEqualTo(convoy.world.robots.get(0).protocol().me());
  }

  private static ProcessId leaderOf(Convoy convoy) {
    assertThat(convoy.anyUp().leader()).isInstanceOf(Leader.Name.class);
    return ((Leader.Name) convoy.anyUp().leader()).id();
  }

  private static Voter crashed(Convoy convoy, ProcessId id) {
    return convoy.world.robots.stream()
        .filter(LiveRobot::isUp)
        .filter(robot -> robot.protocol().me().equals(id))
        .findFirst()
        .orElseThrow();
  }
}
