package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/** The two sides of reliable unicast over a network that loses, doubles, delays and reorders. */
class ReliableUnicastTest {

  private static final RobotId SENDER = new RobotId("s");

  /** One message of one incarnation of the sender. */
  private record Message(int boot, RobotId to, int id) {}

  /** One handling of it by one incarnation of its receiver. */
  private record Handling(Message message, int receiverBoot) {}

  private record Event(long atNs, long serial, Runnable action) implements Comparable<Event> {
    @Override
    public int compareTo(Event other) {
      int byTime = Long.compare(atNs, other.atNs);
      return byTime != 0 ? byTime : Long.compare(serial, other.serial);
    }
  }

  /** One sender and some receivers, each with a crash now and then, driven by one seed. */
  private static final class Network {
    final Rng rng;
    double loss;
    double doubling = 0.2;
    long maxDelayMs = 2_000;
    final PriorityQueue<Event> events = new PriorityQueue<>();
    final Map<Handling, Integer> handled = new HashMap<>();
    final Map<Message, Receipt> receipts = new HashMap<>();
    final Map<Message, Long> deadlines = new HashMap<>();
    final List<String> wrong = new ArrayList<>();
    final Map<RobotId, InboundWindows> receivers = new HashMap<>();
    final Map<RobotId, Integer> receiverBoots = new HashMap<>();
    OutboundQueue<Message> sender;
    int senderBoot;
    long nowNs;
    long serial;

    Network(long seed, double loss) {
      this.rng = new Rng(seed);
      this.loss = loss;
      restartSender();
    }

    void restartSender() {
      senderBoot++;
      sender = new OutboundQueue<>(this::transmit);
    }

    void restartReceiver(RobotId robot) {
      receiverBoots.merge(robot, 1, Integer::sum);
      receivers.put(robot, new InboundWindows());
    }

    void send(RobotId to, Reliability reliability) {
      Message message = new Message(senderBoot, to, receipts.size());
      deadlines.put(message, nowNs + reliability.deadlineMs() * NS_PER_MS);
      Receipt receipt = sender.send(to, message, reliability, nowNs);
      receipts.put(message, receipt);
      receipt.whenSettled(() -> {
        if (nowNs > deadlines.get(message)) {
          wrong.add(message + " settled late, at " + nowNs);
        }
      });
    }

    void transmit(Outgoing<Message> outgoing) {
      Message message = outgoing.content;
      for (int copies = 1 + (rng.nextBoolean(doubling) ? 1 : 0); copies > 0; copies--) {
        travel(() -> arrive(message.to, message, outgoing.order));
      }
    }

    void travel(Runnable arrival) {
      if (!rng.nextBoolean(loss)) {
        at(nowNs + rng.nextLong(1, maxDelayMs * NS_PER_MS), arrival);
      }
    }

    void at(long atNs, Runnable action) {
      serial++;
      events.add(new Event(atNs, serial, action));
    }

    void arrive(RobotId to, Message message, long order) {
      InboundWindows receiver = receivers.get(to);
      if (receiver.admit(SENDER, message.boot) != null) {
        return;
      }
      DropReason refusal = receiver.refusal(SENDER, order);
      if (refusal == null) {
        receiver.handle(SENDER, message.boot, order);
        handled.merge(new Handling(message, receiverBoots.get(to)), 1, Integer::sum);
      }
      if (refusal == null || refusal == DropReason.DUPLICATE) {
        travel(() -> acknowledge(to, message.boot, order));
      }
    }

    void acknowledge(RobotId from, int boot, long order) {
      if (boot == senderBoot) {
        sender.acknowledged(from, order, nowNs);
      }
    }

    void runUntil(long untilNs) {
      while (true) {
        Event next = events.peek();
        long nextNs = Math.min(next == null ? Long.MAX_VALUE : next.atNs, sender.nextDueNs());
        if (nextNs > untilNs) {
          nowNs = untilNs;
          return;
        }
        nowNs = nextNs;
        if (next != null && next.atNs == nextNs) {
          events.poll();
          next.action.run();
        }
        sender.advance(nowNs);
      }
    }

    int handledBy(Message message, int receiverBoot) {
      return handled.getOrDefault(new Handling(message, receiverBoot), 0);
    }
  }

  private static Network network(long seed, double loss, int receivers) {
    Network network = new Network(seed, loss);
    for (int i = 0; i < receivers; i++) {
      network.restartReceiver(new RobotId("r" + i));
    }
    return network;
  }

  private static Reliability anyReliability(Rng rng) {
    long firstMs = rng.nextLong(1, 400);
    return new Reliability(
        firstMs,
        1 + rng.nextDouble(),
        firstMs + rng.nextLong(0, 1_000),
        rng.nextInt(16),
        rng.nextLong(1, 20_000));
  }

  private static void sendSome(Network network, int messages, int receivers) {
    for (int id = 0; id < messages; id++) {
      RobotId to = new RobotId("r" + network.rng.nextInt(receivers));
      network.send(to, anyReliability(network.rng));
      if (network.rng.nextBoolean(0.5)) {
        network.runUntil(network.nowNs + network.rng.nextLong(0, 500) * NS_PER_MS);
      }
    }
  }

  @Property(tries = 200)
  void eachMessageIsHandledAtMostOnceAndExactlyOnceIfDelivered(
      @ForAll long seed,
      @ForAll @DoubleRange(max = 1) double loss,
      @ForAll @IntRange(min = 1, max = 3) int receivers) {
    Network network = network(seed, loss, receivers);
    sendSome(network, 60, receivers);
    network.runUntil(network.nowNs + 60_000 * NS_PER_MS);

    assertThat(network.wrong).isEmpty();
    network.receipts.forEach((message, receipt) -> {
      assertThat(receipt.isSettled()).isTrue();
      int times = network.handledBy(message, 1);
      assertThat(times).isLessThanOrEqualTo(1);
      if (receipt.isDelivered()) {
        assertThat(times).isEqualTo(1);
      }
    });
    network.receivers.values().forEach(r -> assertThat(r.size()).isLessThanOrEqualTo(1));
  }

  @Property(tries = 200)
  void crashesOfBothSidesNeverLetAnIncarnationHandleAMessageTwice(
      @ForAll long seed, @ForAll @DoubleRange(max = 0.9) double loss) {
    Network network = network(seed, loss, 2);
    for (int round = 0; round < 8; round++) {
      sendSome(network, 10, 2);
      if (network.rng.nextBoolean(0.5)) {
        network.restartSender();
      } else {
        network.restartReceiver(new RobotId("r" + network.rng.nextInt(2)));
      }
    }
    network.runUntil(network.nowNs + 60_000 * NS_PER_MS);

    assertThat(network.wrong).isEmpty();
    assertThat(network.handled.values()).allMatch(times -> times == 1);
    network.receipts.forEach((message, receipt) -> {
      if (receipt.isDelivered()) {
        assertThat(network.handled.keySet()).anyMatch(h -> h.message().equals(message));
      }
    });
  }

  @Property(tries = 50)
  void pendingMessagesAreDeliveredOnceTheNetworkIsReliable(
      @ForAll long seed, @ForAll @IntRange(min = 1, max = 700) int messages) {
    Network network = network(seed, 1, 1);
    Reliability patient = new Reliability(250, 1.5, 2_000, 1_000, 600_000);
    for (int id = 0; id < messages; id++) {
      network.send(new RobotId("r0"), patient);
    }
    network.runUntil(10_000 * NS_PER_MS);
    network.loss = 0;
    network.maxDelayMs = 50;
    network.runUntil(30_000 * NS_PER_MS);

    assertThat(network.receipts.values()).allMatch(Receipt::isDelivered);
    assertThat(network.handled).hasSize(messages);
  }

  @Property(tries = 50)
  void pendingMessagesSpanLessThanAWindow(
      @ForAll long seed, @ForAll @DoubleRange(max = 1) double loss) {
    Rng rng = new Rng(seed);
    RobotId to = new RobotId("r");
    Map<Long, Outgoing<Integer>> underWay = new HashMap<>();
    List<Long> spans = new ArrayList<>();
    OutboundQueue<Integer> queue =
        new OutboundQueue<>(outgoing -> {
          underWay.put(outgoing.order, outgoing);
          underWay.values().removeIf(Receipt::isSettled);
          long oldest = underWay.keySet().stream().mapToLong(o -> o).min().orElseThrow();
          spans.add(outgoing.order - oldest);
        });
    for (int id = 0; id < 600; id++) {
      queue.send(to, id, new Reliability(100, 1, 100, 3, 2_000), id * NS_PER_MS);
      if (!rng.nextBoolean(loss)) {
        queue.acknowledged(to, 1 + rng.nextInt(id + 1), id * NS_PER_MS);
      }
    }
    for (long ms = 600; ms < 5_000; ms++) {
      queue.advance(ms * NS_PER_MS);
    }

    assertThat(spans).allMatch(span -> span < InboundWindows.WINDOW);
    assertThat(queue.nextDueNs()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void aWaitingMessageFailsAtItsDeadline() {
    List<Long> transmitted = new ArrayList<>();
    OutboundQueue<Integer> queue = new OutboundQueue<>(o -> transmitted.add(o.order));
    RobotId to = new RobotId("r");
    Reliability once = new Reliability(1_000, 1, 1_000, 0, 1_000);
    for (int i = 0; i < InboundWindows.WINDOW; i++) {
      queue.send(to, i, Reliability.DEFAULT, 0);
    }
    Receipt held = queue.send(to, 256, once, 0);

    queue.advance(1_000 * NS_PER_MS);

    assertThat(held.isFailed()).isTrue();
    assertThat(transmitted).doesNotContain(257L);
  }

  @Test
  void aReceiptsActionMaySendTheNextMessage() {
    List<Long> transmitted = new ArrayList<>();
    OutboundQueue<Integer> queue = new OutboundQueue<>(o -> transmitted.add(o.order));
    RobotId to = new RobotId("r");
    Receipt first = queue.send(to, 0, Reliability.DEFAULT, 0);
    first.whenSettled(() -> queue.send(to, 1, Reliability.DEFAULT, 5));

    assertThat(queue.acknowledged(to, 1, 5)).isTrue();
    assertThat(queue.acknowledged(to, 1, 6)).isFalse();
    assertThat(queue.acknowledged(to, 7, 6)).isFalse();
    assertThat(transmitted).containsExactly(1L, 2L);
  }

  @Test
  void aNumberTooOldForTheWindowIsRefused() {
    InboundWindows windows = new InboundWindows();
    windows.handle(SENDER, 1, 1);
    windows.handle(SENDER, 1, 300);

    assertThat(windows.refusal(SENDER, 44)).isEqualTo(DropReason.TOO_OLD);
    assertThat(windows.refusal(SENDER, 45)).isNull();
    windows.handle(SENDER, 1, 45);
    assertThat(windows.refusal(SENDER, 45)).isEqualTo(DropReason.DUPLICATE);
    assertThat(windows.refusal(SENDER, 300)).isEqualTo(DropReason.DUPLICATE);
    assertThat(windows.refusal(SENDER, 301)).isNull();
    assertThat(windows.refusal(SENDER, Long.MAX_VALUE)).isNull();
  }

  @Test
  void sendersBeyondTheLimitAreRefused() {
    InboundWindows windows = new InboundWindows();
    for (int i = 0; i < InboundWindows.MAX_SENDERS; i++) {
      assertThat(windows.admit(new RobotId("x" + i), 2)).isNull();
    }

    assertThat(windows.admit(SENDER, 2)).isEqualTo(DropReason.TOO_MANY_SENDERS);
    assertThat(windows.admit(SENDER, 1)).isNull();
    assertThat(windows.refusal(SENDER, 1)).isEqualTo(DropReason.TOO_MANY_SENDERS);
    assertThat(windows.size()).isEqualTo(InboundWindows.MAX_SENDERS);
  }
}
