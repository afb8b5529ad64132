package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.Timer;
import org.starl.random.Rng;
import org.starl.shape.Shapes;

/**
 * Random sends, acknowledgements and closed channels. Each message is transmitted at exactly the times
 * that its {@link Reliability} gives, from the time when its window admits it until it is settled, and
 * its receipt tells so once.
 */
class ReliableSenderPropertyTest {

  private static final int STEPS = 30;
  private static final int FEW = 4;
  private static final List<RobotId> ROBOTS = List.of(new RobotId("a"), new RobotId("b"));

  private long nowNs;
  private long timerNs;
  private Runnable expiry = () -> {};
  private final List<Letter> letters = new ArrayList<>();
  private final Map<String, Letter> byName = new HashMap<>();
  private final List<OpenEndpoint<String>> endpoints = new ArrayList<>();

  /** A message, and what is expected of it. */
  private static final class Letter {
    final RobotId to;
    final long order;
    final Reliability reliability;
    final OpenEndpoint<String> endpoint;
    final long deadlineNs;
    @Nullable Receipt receipt;
    int toldTimes;
    int transmissions;
    long waitNs;
    long dueNs;

    Letter(RobotId to, long order, Reliability used, OpenEndpoint<String> on, long nowNs) {
      this.to = to;
      this.order = order;
      this.reliability = used;
      this.endpoint = on;
      this.deadlineNs = nowNs + used.deadlineMs() * NS_PER_MS;
      this.waitNs = used.firstRetryMs() * NS_PER_MS;
      this.dueNs = deadlineNs;
    }

    boolean isSettled() {
      return receipt != null && receipt.isSettled();
    }
  }

  private final class FakeTimer implements Timer {
    @Override
    public void set(long atNs) {
      timerNs = atNs;
    }

    @Override
    public void cancel() {
      timerNs = NEVER;
    }

    @Override
    public boolean isSet() {
      return timerNs != NEVER;
    }
  }

  @Property(tries = 200, shrinking = ShrinkingMode.OFF)
  void eachMessageIsTransmittedAtItsTimesUntilItIsSettled(@ForAll long seed) {
    Rng rng = new Rng(seed);
    letters.clear();
    byName.clear();
    endpoints.clear();
    nowNs = 0;
    timerNs = Timer.NEVER;
    ReliableSender sender =
        new ReliableSender(
            () -> nowNs,
            action -> {
              expiry = action;
              return new FakeTimer();
            },
            this::transmitted);
    for (String name : List.of("one", "two")) {
      endpoints.add(new OpenEndpoint<>(null, Channel.of(name, Shapes.TEXT), (from, message) -> {}));
    }
    for (int step = 0; step < STEPS; step++) {
      switch (rng.nextInt(4)) {
        case 0 -> send(sender, rng);
        case 1 -> acknowledge(sender, rng);
        case 2 -> close(sender, endpoints.get(rng.nextInt(endpoints.size())));
        default -> pass(rng.nextLong(0, 400) * NS_PER_MS);
      }
    }
    pass(Long.MAX_VALUE - nowNs);
    assertThat(letters).allMatch(letter -> letter.isSettled() && letter.toldTimes == 1);
  }

  private void send(ReliableSender sender, Rng rng) {
    RobotId to = ROBOTS.get(rng.nextInt(ROBOTS.size()));
    OpenEndpoint<String> endpoint = endpoints.get(rng.nextInt(endpoints.size()));
    long firstMs = rng.nextLong(10, 100);
    Reliability used =
        new Reliability(
            firstMs,
            1 + rng.nextDouble(),
            firstMs + rng.nextLong(0, 200),
            rng.nextInt(6),
            rng.nextLong(50, 1_000));
    int count = rng.nextBoolean(0.3) ? InboundWindows.WINDOW : 1 + rng.nextInt(FEW);
    for (int i = 0; i < count; i++) {
      Letter letter = new Letter(to, sender.nextOrder(to), used, endpoint, nowNs);
      letters.add(letter);
      byName.put(to + " " + letter.order, letter);
      RetainedMessage message = new RetainedMessage(endpoint, "x", letter.order, new byte[0]);
      Receipt receipt = sender.send(to, message, used);
      letter.receipt = receipt;
      receipt.whenSettled(() -> letter.toldTimes++);
    }
  }

  private void acknowledge(ReliableSender sender, Rng rng) {
    List<Letter> sent = letters.stream().filter(letter -> letter.transmissions > 0).toList();
    if (!sent.isEmpty()) {
      Letter letter = sent.get(rng.nextInt(sent.size()));
      boolean wasSettled = letter.isSettled();
      assertThat(sender.acknowledged(letter.to, letter.order)).isEqualTo(!wasSettled);
      assertThat(letter.isSettled()).isTrue();
    }
  }

  private void close(ReliableSender sender, OpenEndpoint<String> endpoint) {
    sender.fail(endpoint);
    assertThat(letters).allMatch(letter -> letter.endpoint != endpoint || letter.isSettled());
  }

  private void pass(long ns) {
    long untilNs = nowNs + ns;
    while (timerNs <= untilNs && timerNs != Timer.NEVER) {
      nowNs = Math.max(nowNs, timerNs);
      timerNs = Timer.NEVER;
      expiry.run();
    }
    nowNs = untilNs;
    assertThat(letters).allMatch(letter -> letter.isSettled() || letter.dueNs >= nowNs);
  }

  private void transmitted(Outgoing<RetainedMessage> outgoing) {
    Letter letter = Objects.requireNonNull(byName.get(outgoing.to + " " + outgoing.content.number));
    assertThat(letter.isSettled()).isFalse();
    assertThat(nowNs).isLessThan(letter.deadlineNs);
    assertThat(letter.transmissions).isLessThanOrEqualTo(letter.reliability.maxRetries());
    if (letter.transmissions > 0) {
      assertThat(nowNs).isEqualTo(letter.dueNs);
    }
    letter.transmissions++;
    letter.dueNs = Math.min(nowNs + letter.waitNs, letter.deadlineNs);
    long mostNs = letter.reliability.maxWaitMs() * NS_PER_MS;
    letter.waitNs = Math.min((long) (letter.waitNs * letter.reliability.backoff()), mostNs);
  }
}
