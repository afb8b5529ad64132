package org.starl.sim.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.random.Rng;
import org.starl.sim.kernel.CarrierKind;
import org.starl.sim.kernel.Kernel;
import org.starl.sim.world.TestTrace;
import org.starl.trace.TraceEvent;

final class SimNetworkTest {

  private static final long MS = 1_000_000;

  /** Some robots on the air, and what each has received: {@code time text}. */
  private static final class Air {
    final Kernel time = new Kernel(CarrierKind.VIRTUAL);
    final TestTrace trace = new TestTrace();
    final SimNetwork network = new SimNetwork(time, trace, new Rng(7));
    final Map<String, Radio> radios = new LinkedHashMap<>();
    final Map<String, List<String>> received = new LinkedHashMap<>();

    Air(int robots) {
      for (int i = 0; i < robots; i++) {
        attach("bot" + i);
      }
    }

    void attach(String name) {
      Radio radio = network.attach(new RobotId(name), time.strand(name));
      List<String> log = received.computeIfAbsent(name, any -> new ArrayList<>());
      radio.onReceive((buffer, length) -> log.add(time.nowNs() + " " + text(buffer, length)));
      radios.put(name, radio);
    }

    void runFor(double seconds) {
      runUntil(time, time.nowNs() + (long) (seconds * 1e9));
    }

    void send(String from, String to, String text) {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      radio(from).send(new RobotId(to), bytes, bytes.length);
      // The buffer is the sender's again.
      java.util.Arrays.fill(bytes, (byte) '!');
    }

    void broadcast(String from, String text) {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      radio(from).broadcast(bytes, bytes.length);
      java.util.Arrays.fill(bytes, (byte) '!');
    }

    Radio radio(String name) {
      Radio radio = radios.get(name);
      if (radio == null) {
        throw new IllegalArgumentException(name);
      }
      return radio;
    }

    List<String> log(String name) {
      return received.getOrDefault(name, List.of());
    }

    private static String text(byte[] buffer, int length) {
      return new String(buffer, 0, length, StandardCharsets.UTF_8);
    }
  }

  private static void runUntil(Kernel time, long untilNs) {
    time.schedule(untilNs, () -> {});
    time.run(untilNs, () -> false);
  }

  @Test
  void aDatagramArrivesAfterTheDelayNotInsideSend() {
    Air air = new Air(2);
    air.send("bot0", "bot1", "now");
    assertThat(air.log("bot1")).isEmpty();
    air.runFor(0);
    air.network.base(new Latency.Constant(5 * MS), Loss.NONE);
    air.send("bot0", "bot1", "later");
    air.runFor(1);
    assertThat(air.log("bot1")).containsExactly("0 now", 5 * MS + " later");
  }

  @Test
  void aBroadcastReachesEveryoneElse() {
    Air air = new Air(4);
    air.broadcast("bot2", "hello");
    air.runFor(1);
    assertThat(air.log("bot0")).containsExactly("0 hello");
    assertThat(air.log("bot1")).containsExactly("0 hello");
    assertThat(air.log("bot2")).isEmpty();
    assertThat(air.log("bot3")).containsExactly("0 hello");
    assertThat(air.network.statistics()).isEqualTo(new NetStatistics(1, 5, 3, 0));
  }

  @Test
  void lossIsIndependentForEachRecipient() {
    Air air = new Air(3);
    air.network.base(new Latency.Constant(0), new Loss(0.5));
    for (int i = 0; i < 2000; i++) {
      air.broadcast("bot0", String.valueOf(i));
    }
    air.runFor(1);
    assertThat(air.log("bot1")).hasSizeBetween(900, 1100);
    assertThat(air.log("bot2")).hasSizeBetween(900, 1100);
    List<String> both = new ArrayList<>(air.log("bot1"));
    both.retainAll(air.log("bot2"));
    assertThat(both).hasSizeBetween(400, 600);
    assertThat(air.trace.of(TraceEvent.Dropped.class))
        .hasSize((int) air.network.statistics().lost())
        .allSatisfy(dropped -> assertThat(dropped.why()).isEqualTo("loss"));
  }

  @Test
  void anAdditionalRobotDoesNotChangeTheRandomNumbersOfOthers() {
    Air few = new Air(3);
    Air many = new Air(5);
    for (Air air : List.of(few, many)) {
      air.network.base(Latency.parse("uniform(10ms,200ms)"), new Loss(0.3));
      for (int i = 0; i < 100; i++) {
        air.broadcast("bot0", "a" + i);
        air.send("bot1", "bot2", "b" + i);
        if (air == many) {
          air.broadcast("bot4", "noise");
        }
        air.runFor(0.05);
      }
      air.runFor(1);
    }
    List<String> withoutNoise = new ArrayList<>(many.log("bot2"));
    withoutNoise.removeIf(line -> line.endsWith("noise"));
    assertThat(withoutNoise).isEqualTo(few.log("bot2")).hasSizeGreaterThan(50);
  }

  @Test
  void differentSeedsGiveDifferentDelays() {
    List<List<String>> logs = new ArrayList<>();
    for (long seed = 0; seed < 2; seed++) {
      Kernel time = new Kernel(CarrierKind.VIRTUAL);
      SimNetwork network = new SimNetwork(time, new TestTrace(), new Rng(seed));
      network.base(Latency.parse("uniform(0ms,1s)"), Loss.NONE);
      List<String> log = new ArrayList<>();
      Radio sender = network.attach(new RobotId("a"), time.strand("a"));
      Radio receiver = network.attach(new RobotId("b"), time.strand("b"));
      receiver.onReceive((buffer, length) -> log.add(String.valueOf(time.nowNs())));
      sender.broadcast(new byte[1], 1);
      runUntil(time, 2_000 * MS);
      logs.add(log);
    }
    assertThat(logs.get(0)).isNotEqualTo(logs.get(1));
  }

  @Test
  void aRuleMaySendDuringItsDecision() {
    Air air = new Air(3);
    air.network.base(new Latency.Constant(1 * MS), Loss.NONE);
    air.network.install(copy -> {
      if (copy.to().name().equals("bot1")) {
        air.send("bot0", "bot2", "I saw one");
      }
      return Verdict.PASS;
    });
    air.send("bot0", "bot1", "one");
    air.runFor(1);
    assertThat(air.log("bot1")).containsExactly(1 * MS + " one");
    assertThat(air.log("bot2")).containsExactly(1 * MS + " I saw one");
  }

  @Test
  void aRuleMayRemoveTheReceiver() {
    Air air = new Air(2);
    air.network.install(copy -> {
      air.network.detach(copy.to());
      return Verdict.PASS;
    });
    air.send("bot0", "bot1", "one");
    air.runFor(1);
    assertThat(air.log("bot1")).isEmpty();
    assertThat(air.trace.of(TraceEvent.Dropped.class))
        .extracting(TraceEvent.Dropped::why)
        .containsExactly("no-such-robot");
  }

  @Test
  void theFirstRuleThatAnswersDecidesUntilItIsRemoved() {
    Air air = new Air(2);
    LinkRule.Handle late = air.network.install(copy -> Verdict.later(30 * MS));
    LinkRule.Handle cut = air.network.install(copy -> Verdict.drop("partition"));
    air.network.install(copy -> Verdict.PASS);
    air.send("bot0", "bot1", "cut");
    cut.uninstall();
    cut.uninstall();
    air.send("bot0", "bot1", "late");
    late.uninstall();
    air.send("bot0", "bot1", "plain");
    air.runFor(1);
    assertThat(air.log("bot1")).containsExactly("0 plain", 30 * MS + " late");
    assertThat(air.trace.of(TraceEvent.Dropped.class))
        .containsExactly(new TraceEvent.Dropped(0, new RobotId("bot1"), "bot0", "partition"));
  }

  @Test
  void aRuleThatDrawsAndPassesDoesNotChangeBaseDelays() {
    Air plain = new Air(2);
    Air ruled = new Air(2);
    ruled.network.install(copy -> copy.rng().nextBoolean(0) ? Verdict.drop("never") : Verdict.PASS);
    for (Air air : List.of(plain, ruled)) {
      air.network.base(Latency.parse("exponential(50ms)"), new Loss(0.2));
      for (int i = 0; i < 50; i++) {
        air.send("bot0", "bot1", "m" + i);
      }
      air.runFor(10);
    }
    assertThat(ruled.log("bot1")).isEqualTo(plain.log("bot1"));
  }

  @Test
  void aPartitionLastsUntilItHeals() {
    Air air = new Air(4);
    LinkRule.Handle split =
        air.network.install(Partition.isolating(new RobotId("bot0"), new RobotId("bot1")));
    air.broadcast("bot0", "left");
    air.broadcast("bot2", "right");
    split.uninstall();
    air.broadcast("bot3", "healed");
    air.runFor(1);
    assertThat(air.log("bot0")).containsExactly("0 healed");
    assertThat(air.log("bot1")).containsExactly("0 left", "0 healed");
    assertThat(air.log("bot2")).containsExactly("0 healed");
    assertThat(air.log("bot3")).containsExactly("0 right");
  }

  @Test
  void delaysAndCopiesOfRulesAddToLaterDecisions() {
    Air air = new Air(2);
    air.network.base(new Latency.Constant(5 * MS), Loss.NONE);
    LinkRule.Handle dropping = air.network.install(copy -> Verdict.drop("rule"));
    air.network.install(copy -> Verdict.again(2 * MS));
    air.network.install(copy -> Verdict.later(10 * MS));
    air.network.install(copy -> Verdict.later(20 * MS));
    air.send("bot0", "bot1", "dropped");
    dropping.uninstall();
    air.send("bot0", "bot1", "twice");
    air.runFor(1);
    assertThat(air.log("bot1")).containsExactly(35 * MS + " twice", 37 * MS + " twice");
    assertThat(air.network.statistics().lost()).isEqualTo(1);
  }

  @Test
  void aDelayBelow0IsABug() {
    assertThatThrownBy(() -> Verdict.later(-1)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> Verdict.again(-1)).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void aOneWayPartitionCutsOneDirection() {
    Air air = new Air(3);
    air.network.install(
        Partition.oneWay(List.of(new RobotId("bot0")), List.of(new RobotId("bot1"))));
    for (String from : List.of("bot0", "bot1", "bot2")) {
      air.broadcast(from, from);
    }
    air.runFor(1);
    assertThat(air.log("bot0")).containsExactly("0 bot1", "0 bot2");
    assertThat(air.log("bot1")).containsExactly("0 bot2");
    assertThat(air.log("bot2")).containsExactly("0 bot0", "0 bot1");
  }

  @Test
  void aRemovedRobotReceivesAndSendsNothing() {
    Air air = new Air(3);
    air.network.base(new Latency.Constant(10 * MS), Loss.NONE);
    air.broadcast("bot0", "first");
    Radio old = air.radio("bot1");
    air.network.detach(new RobotId("bot1"));
    old.broadcast(new byte[] {'x'}, 1);
    air.runFor(1);
    air.broadcast("bot0", "second");
    air.send("bot0", "bot1", "third");
    air.attach("bot1");
    air.broadcast("bot0", "fourth");
    air.runFor(1);
    assertThat(air.log("bot1")).containsExactly(1010 * MS + " fourth");
    assertThat(air.log("bot2")).hasSize(3).noneMatch(line -> line.endsWith("x"));
    assertThat(air.trace.of(TraceEvent.Dropped.class))
        .extracting(TraceEvent.Dropped::why)
        .containsExactly("gone", "no-such-robot");
  }

  @Test
  void aReturningRobotDrawsNewDelays() {
    Air air = new Air(2);
    air.network.base(new Latency.Uniform(0, 1000 * MS), Loss.NONE);
    for (int incarnation = 0; incarnation < 3; incarnation++) {
      long beganNs = air.time.nowNs();
      for (int i = 0; i < 5; i++) {
        air.send("bot0", "bot1", "after " + beganNs);
      }
      air.runFor(1000 * MS);
      air.network.detach(new RobotId("bot0"));
      air.attach("bot0");
    }
    List<Long> delays = new ArrayList<>();
    for (String arrival : air.log("bot1")) {
      String[] words = arrival.split(" after ");
      delays.add(Long.parseLong(words[0]) - Long.parseLong(words[1]));
    }
    assertThat(delays).hasSize(15).doesNotHaveDuplicates();
  }

  @Test
  void aRadioWithoutReceiverLosesDatagrams() {
    Air air = new Air(1);
    Radio deaf = air.network.attach(new RobotId("deaf"), air.time.strand("deaf"));
    air.broadcast("bot0", "hello");
    air.runFor(1);
    assertThat(air.network.statistics().lost()).isOne();
    deaf.onReceive((buffer, length) -> {});
    assertThatThrownBy(() -> deaf.onReceive((buffer, length) -> {}))
        .isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> air.attach("bot0")).isInstanceOf(IllegalStateException.class);
  }

  @Test
  void aDatagramThatIsTooLongIsABug() {
    Air air = new Air(1);
    byte[] buffer = new byte[Radio.MAX_BYTES + 1];
    assertThatThrownBy(() -> air.radio("bot0").broadcast(buffer, buffer.length))
        .isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> air.radio("bot0").broadcast(new byte[3], 4))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
