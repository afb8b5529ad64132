package org.starl.workload;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.sim.fault.Envelope;
import org.starl.time.Time;

/**
 * The contract of every implementation of a primitive: under the faults of its envelope no
 * specification is violated, and after the faults every robot is served in time.
 */
abstract class PrimitiveContract {

  private static final int ROBOTS = 5;

  private final String primitive;
  private final SortedMap<String, String> implementation;

  /**
   * @param implementation parameters that select it
   */
  PrimitiveContract(String primitive, Map<String, String> implementation) {
    this.primitive = primitive;
    this.implementation = new TreeMap<>(implementation);
  }

  /** The faults that it tolerates. */
  Envelope envelope() {
    return Runs.demo(primitive).envelope();
  }

  /** A few here; campaigns run thousands. */
  long seeds() {
    return 6;
  }

  private Runs.Ended run(long seed, Map<String, String> more) {
    Map<String, String> set = new TreeMap<>(implementation);
    set.putAll(more);
    return Runs.run(Runs.plan(primitive, seed, set));
  }

  private String replay(long seed, String more) {
    StringBuilder line = new StringBuilder("./starl run " + primitive + " --seed " + seed + more);
    implementation.forEach((key, value) -> line.append(" --set ").append(key + "=" + value));
    return line.toString();
  }

  @Test
  void chaosViolatesNothingAndAfterItEveryRobotIsServed() {
    String chaos = envelope().toString();
    for (long seed = 1; seed <= seeds(); seed++) {
      Runs.Ended ended = run(seed, Map.of("chaos", chaos));
      String what = replay(seed, " --set chaos=" + chaos);
      assertThat(ended.result().spec().holds()).as("%s: %s", what, ended.result().spec()).isTrue();
      assertThat(ended.result().unfinished()).as(what).isEmpty();
      assertThat(ended.faults()).as(what).isPositive();
      assertThat(ended.servedAfterHealing()).as(what).hasSize(ROBOTS);
      assertThat(ended.servedAfterHealing().values()).as(what).allMatch(times -> times >= 3);
    }
  }

  /** The others have done all their rounds, and are needed again. */
  @Test
  void aRobotThatCrashesInItsLastRoundIsServedAgain() {
    if (Set.of(Envelope.NETWORK, Envelope.SPATIAL).contains(envelope())) {
      return; // no crashes
    }
    Map<String, String> quiet = Map.of("busy", "1s");
    long atNs = run(1, quiet).result().endNs() - Time.NS_PER_MS;
    for (int robot = 0; robot < ROBOTS; robot++) {
      String crash = "crash(bot%d,at=%dns,restart=125ms)".formatted(robot, atNs);
      Runs.Ended ended = run(1, Map.of("busy", "1s", "faults", crash));
      String what = replay(1, " --set busy=1s --fault '" + crash + "'");
      assertThat(ended.result().spec().holds()).as("%s: %s", what, ended.result().spec()).isTrue();
      assertThat(ended.result().unfinished()).as(what).isEmpty();
    }
  }

  @Test
  void permanentLossAndDelayViolateNothing() {
    Map<String, String> foul =
        Map.of("messageLoss", "0.3", "messageDelay", "exponential(50ms)", "busy", "5s");
    Runs.Ended ended = run(1, foul);
    String what = replay(1, " --loss 0.3 --delay 'exponential(50ms)' --set busy=5s");
    assertThat(ended.result().spec().holds()).as("%s: %s", what, ended.result().spec()).isTrue();
    assertThat(ended.result().unfinished()).as(what).isEmpty();
  }

  @Test
  void everyLemmaIsChecked() {
    List<String> silent = new ArrayList<>();
    Runs.Ended ended = run(1, Map.of("positionNoise", "5mm", "busy", "5s"));
    for (String lemma : ended.result().spec().lemmas()) {
      if (ended.result().spec().checks(lemma) == 0) {
        silent.add(lemma);
      }
    }
    silent.removeAll(MatrixTest.ONLY_WITH_FAULTS);
    assertThat(silent).as(replay(1, "")).isEmpty();
  }
}
