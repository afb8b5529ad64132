package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.sim.fault.ProbeRun.MS;
import static org.starl.sim.fault.ProbeRun.S;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.trace.TraceEvent;

/** Every fault of the air bites while it lasts, and stops. Of 100 beats 30 fall into 3 s. */
class AirFaultsTest {

  private static final String FOR_3_S = "at=3s,for=3s)";

  private static final long FROM = 3 * S;
  private static final long UNTIL = 6 * S;

  @Test
  void withoutFaultsEveryBeatArrivesAndNoFaultIsReported() {
    ProbeRun run = ProbeRun.of();
    assertThat(run.count(0, 1, 0, 12 * S)).isEqualTo(100);
    assertThat(run.faults()).isEmpty();
  }

  @Test
  void lossLastsForItsDuration() {
    ProbeRun run = ProbeRun.of("loss(0.5," + FOR_3_S);
    assertThat(run.count(0, 1, FROM, UNTIL)).isBetween(5, 25);
    assertThat(run.count(0, 1, 0, FROM) + run.count(0, 1, UNTIL + 20 * MS, 12 * S))
        .isGreaterThan(68);
    assertThat(run.faults())
        .containsExactly(
            "3000 world begin loss(0.5,at=3s,for=3s)",
            "6000 world end loss(0.5,at=3s,for=3s)",
            "6000 world healed");
  }

  @Test
  void lossWithProbability1LosesEverything() {
    ProbeRun run = ProbeRun.of("loss(1," + FOR_3_S);
    assertThat(run.count(0, 1, FROM + 20 * MS, UNTIL)).isZero();
  }

  @Test
  void lossOnALinkDoesNotAffectOtherLinks() {
    ProbeRun run = ProbeRun.of("loss(1,from=bot0,to=bot1)");
    assertThat(run.count(0, 1, 0, 12 * S)).isZero();
    assertThat(run.count(1, 0, 0, 12 * S)).isEqualTo(100);
    assertThat(run.count(0, 2, 0, 12 * S)).isEqualTo(100);
  }

  @Test
  void burstsLoseConsecutiveMessages() {
    ProbeRun run = ProbeRun.of("burst(1s,1s)");
    List<TraceEvent.Delivered> heard = run.heard(0, 1, 0, 12 * S);
    assertThat(heard).hasSizeBetween(15, 85);
    int gaps = 0;
    int longest = 0;
    for (int i = 1; i < heard.size(); i++) {
      int missed = (int) (heard.get(i).seq() - heard.get(i - 1).seq()) - 1;
      gaps += missed > 0 ? 1 : 0;
      longest = Math.max(longest, missed);
    }
    assertThat(gaps).as("independent loss of the same rate would have some 25").isBetween(1, 12);
    assertThat(longest).isGreaterThan(4);
  }

  @Test
  void delayAddsToTheBaseDelayAndDoesNotChangeLoss() {
    ProbeRun run = ProbeRun.of("delay(200ms," + FOR_3_S, "loss(0.5,from=bot0,to=bot2)");
    List<Long> delays = delaysMs(run, 1);
    assertThat(delays).hasSize(100).containsOnly(10L, 210L);
    assertThat(delays.stream().filter(ms -> ms == 210)).hasSize(30);
    assertThat(run.count(0, 2, 0, 12 * S)).isBetween(30, 70);
  }

  private static List<Long> delaysMs(ProbeRun run, int to) {
    List<Long> delays = new ArrayList<>();
    for (TraceEvent.Delivered heard : run.heard(0, to, 0, 12 * S)) {
      run.of(TraceEvent.Sent.class, 0, 0, 12 * S).stream()
          .filter(sent -> sent.seq() == heard.seq())
          .forEach(sent -> delays.add((heard.timeNs() - sent.timeNs()) / MS));
    }
    return delays;
  }

  @Test
  void duplicatesArriveTwice() {
    ProbeRun run = ProbeRun.of("duplicate(1,20ms," + FOR_3_S);
    List<TraceEvent.Delivered> heard = run.heard(0, 1, 0, 12 * S);
    assertThat(heard).hasSize(130);
    assertThat(run.count(0, 1, FROM, UNTIL + 50 * MS)).isBetween(59, 62);
    assertThat(delaysMs(run, 1)).allMatch(ms -> ms >= 10 && ms <= 30).contains(10L);
  }

  @Test
  void reorderingLetsLaterMessagesOvertake() {
    ProbeRun run = ProbeRun.of("reorder(0.5,1s," + FOR_3_S);
    List<TraceEvent.Delivered> heard = run.heard(0, 1, 0, 12 * S);
    assertThat(heard).hasSize(100);
    List<Long> seqs = heard.stream().map(TraceEvent.Delivered::seq).toList();
    assertThat(seqs).isNotEqualTo(seqs.stream().sorted().toList());
    assertThat(seqs.subList(0, 25)).isEqualTo(seqs.stream().sorted().toList().subList(0, 25));
  }

  @Test
  void aPartitionSplitsAndHeals() {
    ProbeRun run = ProbeRun.of("partition(bot0+bot1|bot2," + FOR_3_S);
    assertThat(run.count(0, 1, 0, 12 * S)).isEqualTo(100);
    assertThat(run.count(0, 2, FROM + 20 * MS, UNTIL)).isZero();
    assertThat(run.count(2, 0, FROM + 20 * MS, UNTIL)).isZero();
    assertThat(run.count(0, 2, 0, 12 * S)).isEqualTo(70);
  }

  @Test
  void aOneWayPartitionCutsOneDirection() {
    ProbeRun run = ProbeRun.of("partition(bot0>bot1+bot2," + FOR_3_S);
    assertThat(run.count(0, 1, 0, 12 * S)).isEqualTo(70);
    assertThat(run.count(0, 2, 0, 12 * S)).isEqualTo(70);
    assertThat(run.count(1, 0, 0, 12 * S)).isEqualTo(100);
  }

  @Test
  void anAreaIsCutOffFromTheRest() {
    for (String area : List.of("circle(0,2m,500mm)", "rect(-1m,1500mm,1m,3m)")) {
      ProbeRun run = ProbeRun.of("partition(area=" + area + "," + FOR_3_S);
      assertThat(run.count(1, 2, 0, 12 * S)).isEqualTo(70);
      assertThat(run.count(2, 1, 0, 12 * S)).isEqualTo(70);
      assertThat(run.count(0, 1, 0, 12 * S)).isEqualTo(100);
    }
  }

  @Test
  void rangeLimitsByTrueDistance() {
    ProbeRun run = ProbeRun.of("range(1500mm," + FOR_3_S);
    assertThat(run.count(1, 2, 0, 12 * S)).as("1 m apart").isEqualTo(100);
    assertThat(run.count(0, 2, 0, 12 * S)).as("2 m apart and more").isEqualTo(70);
    assertThat(run.count(0, 1, FROM, UNTIL)).as("bot0 drives away").isLessThan(20);
  }

  @Test
  void wallsAndBodiesBlockSight() {
    Obstacles wall = Obstacles.of(Obstacle.wall(new Point(-200, 1500), new Point(200, 1500)));
    ProbeRun run = ProbeRun.of(wall, "sight(" + FOR_3_S);
    assertThat(run.count(1, 2, 0, 12 * S)).as("a wall between").isEqualTo(70);
    ProbeRun open = ProbeRun.of("sight(until=3s)");
    assertThat(open.count(1, 2, 0, 12 * S)).isEqualTo(100);
    assertThat(open.count(0, 2, 0, 100 * MS)).as("bot1's body between, at first").isZero();
    assertThat(open.count(0, 2, 0, 12 * S)).as("bot0 drives out of its shadow").isGreaterThan(75);
  }

  @Test
  void removingAFaultDoesNotChangeOthers() {
    List<TraceEvent.Delivered> alone = ProbeRun.of("loss(0.5)").heard(0, 1, 0, 12 * S);
    List<TraceEvent.Delivered> beside =
        ProbeRun.of("duplicate(0.3,to=bot2)", "loss(0.5)", "loss(0.5,from=bot2,to=bot0)")
            .heard(0, 1, 0, 12 * S);
    assertThat(beside).isEqualTo(alone);
  }
}
