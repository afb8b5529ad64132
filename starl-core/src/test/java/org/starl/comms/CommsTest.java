// Longer than 500 lines because all of it needs the same two or three robots and their channel.
package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.shape.Geometry;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.testing.FakePlatform;
import org.starl.testing.FakeWorld;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

class CommsTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final Channel<String> TALK = new Channel<>("talk", "1", new Text());
  private static final FakeWorld.Rule LOSE_ALL = (from, to, datagram) -> new long[0];

  private final FakeWorld world = new FakeWorld("a", "b", "c");
  private final List<String> heard = new ArrayList<>();

  /** Strings as they are. */
  private static final class Text implements Codec<String> {
    @Override
    public void write(String message, WireWriter out) {
      out.bytes(message.getBytes(java.nio.charset.StandardCharsets.UTF_8));
    }

    @Override
    public String read(WireReader in) {
      return new String(in.bytes(), java.nio.charset.StandardCharsets.UTF_8);
    }
  }

  private Comms comms(String name, int boot) {
    return new Comms(world.boot(name).platform(), boot);
  }

  private Endpoint<String> open(Comms comms, String as) {
    return comms.open(TALK, (from, message) -> heard.add(as + ":" + from + ":" + message));
  }

  @Test
  void aPlainMessageArrivesOnItsChannel() {
    Endpoint<String> a = open(comms("a", 1), "a");
    open(comms("b", 1), "b");

    a.send(B, "hello");
    world.runMs(10);

    assertThat(heard).containsExactly("b:a:hello");
  }

  @Test
  void aBroadcastReachesEveryoneElse() {
    Endpoint<String> a = open(comms("a", 1), "a");
    open(comms("b", 1), "b");
    open(comms("c", 1), "c");

    a.broadcast("hello");
    world.runMs(10);

    assertThat(heard).containsExactly("b:a:hello", "c:a:hello");
  }

  @Test
  void instancesOfOnePrimitiveAreSeparate() {
    Endpoint<String> a = open(comms("a", 1), "a");
    Comms b = comms("b", 1);
    b.open(new Channel<>("talk", "2", new Text()), (from, message) -> heard.add(message));

    a.send(B, "hello");
    world.runMs(10);

    assertThat(heard).isEmpty();
    assertThat(b.dropped(DropReason.NO_LISTENER)).isEqualTo(1);
  }

  @Test
  void aDuplicatedPlainMessageIsHandledTwice() {
    Endpoint<String> a = open(comms("a", 1), "a");
    open(comms("b", 1), "b");
    world.rule = (from, to, datagram) -> new long[] {1, 2};

    a.send(B, "hello");
    world.runMs(10);

    assertThat(heard).hasSize(2);
  }

  @Test
  void aDuplicatedReliableMessageIsHandledOnce() {
    Endpoint<String> a = open(comms("a", 1), "a");
    Comms b = comms("b", 1);
    open(b, "b");
    world.rule = (from, to, datagram) -> new long[] {1, 2};

    Receipt receipt = a.sendReliably(B, "hello");
    world.runMs(10);

    assertThat(heard).containsExactly("b:a:hello");
    assertThat(receipt.isDelivered()).isTrue();
    assertThat(b.dropped(DropReason.DUPLICATE)).isEqualTo(1);
  }

  @Test
  void aLostAcknowledgementIsSentAgain() {
    Endpoint<String> a = open(comms("a", 1), "a");
    open(comms("b", 1), "b");
    world.rule = (from, to, datagram) -> from.equals(B) ? new long[0] : new long[] {1};

    Receipt receipt = a.sendReliably(B, "hello");
    world.runMs(240);
    assertThat(receipt.isSettled()).isFalse();
    world.rule = (from, to, datagram) -> new long[] {1};
    world.runMs(20);

    assertThat(receipt.isDelivered()).isTrue();
    assertThat(heard).hasSize(1);
  }

  @Test
  void aChannelOpenedLaterGetsTheMessageByARetry() {
    Endpoint<String> a = open(comms("a", 1), "a");
    Comms b = comms("b", 1);

    Receipt receipt = a.sendReliably(B, "hello");
    world.runMs(100);
    assertThat(receipt.isSettled()).isFalse();
    open(b, "b");
    world.runMs(200);

    assertThat(receipt.isDelivered()).isTrue();
    assertThat(heard).containsExactly("b:a:hello");
  }

  @Test
  void aReceiptFailsAfterTheLastRetry() {
    Endpoint<String> a = open(comms("a", 1), "a");
    List<Long> failures = new ArrayList<>();
    List<Integer> sizes = new ArrayList<>();
    world.rule =
        (from, to, datagram) -> {
          sizes.add(datagram.length);
          return new long[0];
        };

    Receipt receipt = a.sendReliably(B, "hello", new Reliability(100, 2, 10_000, 2, 60_000));
    receipt.whenSettled(() -> failures.add(world.nowNs()));
    world.runMs(60_000);

    assertThat(receipt.isFailed()).isTrue();
    assertThat(sizes).hasSize(3);
    assertThat(failures).containsExactly(700_000_000L);
  }

  @Test
  void aReceiptFailsAtTheDeadline() {
    Endpoint<String> a = open(comms("a", 1), "a");
    List<Long> failures = new ArrayList<>();
    world.rule = LOSE_ALL;

    a.sendReliably(B, "hello", new Reliability(100, 1, 100, 1_000, 250))
        .whenSettled(() -> failures.add(world.nowNs()));
    world.runMs(1_000);

    assertThat(failures).containsExactly(250_000_000L);
  }

  @Test
  void closingFailsReceiptsAndStopsReceiving() {
    Endpoint<String> a = open(comms("a", 1), "a");
    Comms b = comms("b", 1);
    Endpoint<String> other = open(b, "b");
    world.rule = LOSE_ALL;
    Receipt receipt = a.sendReliably(B, "hello");
    List<Boolean> failed = new ArrayList<>();
    receipt.whenSettled(() -> failed.add(receipt.isFailed()));

    a.close();
    other.close();

    assertThat(failed).containsExactly(true);
    assertThatIllegalStateException().isThrownBy(() -> a.send(B, "more"));
    assertThatIllegalStateException().isThrownBy(() -> a.broadcast("more"));
    assertThatIllegalStateException().isThrownBy(() -> a.sendReliably(B, "more"));
    open(b, "b again");
  }

  @Test
  void openingTwiceIsRefused() {
    Comms a = comms("a", 1);
    open(a, "a");

    assertThatIllegalStateException()
        .isThrownBy(() -> open(a, "a"))
        .withMessageContaining("talk/1");
  }

  @Test
  void aMessageToTheSenderItselfArrivesInALaterPiece() {
    Comms comms = comms("a", 1);
    Endpoint<String> a = open(comms, "a");
    world.rule = LOSE_ALL;

    a.send(A, "plain");
    Receipt receipt = a.sendReliably(A, "reliable");
    assertThat(heard).isEmpty();
    assertThat(receipt.isSettled()).isFalse();
    world.runMs(0);

    assertThat(heard).containsExactly("a:a:plain", "a:a:reliable");
    assertThat(receipt.isDelivered()).isTrue();
  }

  @Test
  void aReliableMessageToTheSenderItselfWaitsForTheChannel() {
    Comms comms = comms("a", 1);
    Endpoint<String> other =
        comms.open(new Channel<>("talk", "2", new Text()), (from, message) -> {});

    Receipt receipt = other.sendReliably(A, "x", new Reliability(10, 1, 10, 3, 100));
    other.close();
    world.runMs(200);

    assertThat(receipt.isFailed()).isTrue();
    assertThat(comms.dropped(DropReason.NO_LISTENER)).isEqualTo(1);
  }

  @Test
  void aMessageOfADeadIncarnationIsDropped() {
    Endpoint<String> first = open(comms("a", 1), "a");
    Comms b = comms("b", 1);
    open(b, "b");
    world.rule = (from, to, datagram) -> new long[] {20_000_000};
    first.send(B, "late");
    first.sendReliably(B, "late too");
    Endpoint<String> second = open(comms("a", 2), "a");
    world.rule = (from, to, datagram) -> new long[] {1};
    second.send(B, "new");
    world.runMs(100);

    assertThat(heard).containsExactly("b:a:new");
    assertThat(b.dropped(DropReason.DEAD_SENDER)).isEqualTo(2);
  }

  @Test
  void messagesOfARestartedSenderArriveFromTheFirstOn() {
    Endpoint<String> first = open(comms("a", 1), "a");
    open(comms("b", 1), "b");
    first.sendReliably(B, "one");
    world.runMs(10);

    Receipt receipt = open(comms("a", 2), "a").sendReliably(B, "two");
    world.runMs(10);

    assertThat(heard).containsExactly("b:a:one", "b:a:two");
    assertThat(receipt.isDelivered()).isTrue();
  }

  @Test
  void anAcknowledgementForADeadIncarnationSettlesNothing() {
    open(comms("b", 1), "b");
    world.rule = (from, to, datagram) -> new long[] {from.equals(B) ? 50_000_000 : 1};
    open(comms("a", 1), "a").sendReliably(B, "one");
    world.runMs(10);
    Comms second = comms("a", 2);
    world.rule = LOSE_ALL;
    Receipt receipt = open(second, "a").sendReliably(B, "two");
    world.runMs(100);

    assertThat(receipt.isSettled()).isFalse();
    assertThat(second.dropped(DropReason.STALE_ACK)).isEqualTo(1);
  }

  @Test
  void aRestartedReceiverMayHandleAMessageAgain() {
    Endpoint<String> a = open(comms("a", 1), "a");
    open(comms("b", 1), "b");
    world.rule = (from, to, datagram) -> from.equals(B) ? new long[0] : new long[] {1};
    Receipt receipt = a.sendReliably(B, "hello");
    world.runMs(10);
    open(comms("b", 2), "b2");
    world.rule = (from, to, datagram) -> new long[] {1};
    world.runMs(300);

    assertThat(heard).containsExactly("b:a:hello", "b2:a:hello");
    assertThat(receipt.isDelivered()).isTrue();
  }

  @Test
  void theLamportClockAdvancesBeforeTheHandlerRuns() {
    Comms a = comms("a", 1);
    Comms b = comms("b", 1);
    List<Long> seen = new ArrayList<>();
    b.open(TALK, (from, message) -> seen.add(b.lamportClock().now()));
    Endpoint<String> talk = open(a, "a");
    a.lamportClock().advanceTo(41);
    a.lamportClock().tick();

    talk.send(B, "hello");
    world.runMs(10);

    assertThat(seen).containsExactly(42L);
  }

  @Test
  void retransmissionsAndAcknowledgementsCarryTheCurrentClock() {
    Comms a = comms("a", 1);
    Comms b = comms("b", 1);
    open(b, "b");
    Endpoint<String> talk = open(a, "a");
    world.rule = LOSE_ALL;
    talk.sendReliably(B, "hello");
    world.rule = (from, to, datagram) -> new long[] {1};
    a.lamportClock().advanceTo(7);
    b.lamportClock().advanceTo(9);
    world.runMs(249);
    assertThat(b.lamportClock().now()).isEqualTo(9);
    b.lamportClock().advanceTo(5);
    a.lamportClock().advanceTo(30);
    world.runMs(2);

    assertThat(b.lamportClock().now()).isEqualTo(30);
    b.lamportClock().advanceTo(50);
    talk.sendReliably(B, "again");
    world.runMs(2);
    assertThat(a.lamportClock().now()).isEqualTo(50);
  }

  @Test
  void aMessageThatIsTooLongIsRefused() {
    Endpoint<String> a = open(comms("a", 1), "a");

    assertThatIllegalArgumentException()
        .isThrownBy(() -> a.send(B, "x".repeat(1_400)))
        .withMessage("channel talk/1: a message of 1402 bytes, at most 1363 fit a datagram");
    a.send(B, "x".repeat(1_361));
    assertThatIllegalArgumentException().isThrownBy(() -> a.send(B, "x".repeat(1_362)));
  }

  @Test
  void aFullDatagramArrives() {
    Endpoint<String> a = open(comms("a", 1), "a");
    open(comms("b", 1), "b");

    a.send(B, "x".repeat(1_361));
    world.runMs(10);

    assertThat(heard).containsExactly("b:a:" + "x".repeat(1_361));
    assertThat(world.trace)
        .anySatisfy(event ->
            assertThat(event)
                .isInstanceOfSatisfying(
                    TraceEvent.Sent.class,
                    sent -> assertThat(sent.bytes()).isEqualTo(Header.MAX_BYTES)));
  }

  @Test
  void anEchoAndAMisdirectedDatagramAreCountedAndDropped() {
    Comms comms = comms("a", 1);
    Endpoint<String> a = open(comms, "a");
    Comms b = comms("b", 1);
    open(b, "b");
    List<byte[]> datagrams = new ArrayList<>();
    world.rule =
        (from, to, datagram) -> {
          datagrams.add(datagram);
          return new long[0];
        };
    a.send(new RobotId("c"), "hello");

    world.inject(A, datagrams.get(0));
    world.inject(B, datagrams.get(0));
    world.runMs(1);

    assertThat(comms.dropped(DropReason.OWN)).isEqualTo(1);
    assertThat(b.dropped(DropReason.NOT_FOR_US)).isEqualTo(1);
    assertThat(heard).isEmpty();
  }

  @Test
  void eachReasonIsLoggedOnce() {
    FakePlatform platform = world.boot("a");
    Comms comms = new Comms(platform.platform(), 1);

    world.inject(A, new byte[] {1, 2, 3});
    world.inject(A, new byte[] {1, 2, 3, 4});
    world.inject(A, new byte[0]);
    world.runMs(1);

    assertThat(comms.dropped(DropReason.FOREIGN)).isEqualTo(2);
    assertThat(comms.received()).isEqualTo(3);
    assertThat(platform.log)
        .containsExactly(
            "WARN comms: dropped a datagram from ?: foreign (3 bytes);"
                + " more of these are only counted",
            "WARN comms: dropped a datagram from ?: truncated (0 bytes);"
                + " more of these are only counted");
  }

  @Test
  void aDroppedDatagramIsTraced() {
    comms("a", 1);

    world.inject(A, new byte[] {1, 2, 3});
    world.runMs(1);

    assertThat(world.trace).containsExactly(new TraceEvent.Dropped(0, A, "?", "foreign"));
  }

  @Test
  void datagramsToAllToOneAndToItselfAreCounted() {
    Comms comms = comms("a", 1);
    Endpoint<String> a = open(comms, "a");
    Comms b = comms("b", 1);
    open(b, "b");

    a.broadcast("to all");
    a.sendReliably(B, "to one");
    a.send(A, "to itself");
    world.runMs(10);

    assertThat(comms.sent()).isEqualTo(3);
    assertThat(comms.received()).as("the acknowledgement and its own").isEqualTo(2);
    assertThat(b.sent()).isEqualTo(1);
    assertThat(b.received()).isEqualTo(2);
  }

  @Test
  void aSettledReceiptRunsAnActionAtOnceAndEachOnce() {
    Endpoint<String> a = open(comms("a", 1), "a");
    open(comms("b", 1), "b");
    List<String> told = new ArrayList<>();

    Receipt receipt = a.sendReliably(B, "hello");
    receipt.whenSettled(() -> told.add("before"));
    world.runMs(10);
    receipt.whenSettled(() -> told.add("after"));

    assertThat(told).containsExactly("before", "after");
  }

  @Test
  void sentAndDeliveredMessagesAreTraced() {
    Endpoint<String> a = open(comms("a", 1), "a");
    open(comms("b", 1), "b");

    a.send(B, "x");
    world.runMs(1);

    assertThat(world.trace)
        .containsExactly(
            new TraceEvent.Sent(0, A, "b", TALK.instance(), 1, 40, TALK.shape(), "x"),
            new TraceEvent.Delivered(1_000_000, B, A, TALK.instance(), 1, TALK.shape(), "x"));
  }

  @Test
  void theTraceHasTheMessagesAndAcknowledgementsThemselves() {
    Channel<Point> places = Channel.of("places", Geometry.POINT);
    Endpoint<Point> a = comms("a", 1).open(places, (from, place) -> {});
    comms("b", 1).open(places, (from, place) -> heard.add(place.toString()));
    Point place = new Point(1, 2);

    a.sendReliably(B, place);
    world.runMs(10);

    assertThat(heard).containsExactly(place.toString());
    assertThat(places.instance()).isEqualTo(Instance.of("app", "places"));
    assertThat(world.trace)
        .map(event ->
            switch (event) {
              case TraceEvent.Sent sent -> sent.message();
              case TraceEvent.Delivered delivered -> delivered.message();
              default -> event;
            })
        .containsExactly(place, place, new Ack(1));
  }

  @Test
  void aMessageIsAcknowledgedEvenIfItsHandlerClosesTheChannel() {
    Endpoint<String> a = open(comms("a", 1), "a");
    Comms b = comms("b", 1);
    List<Endpoint<String>> self = new ArrayList<>();
    self.add(b.open(TALK, (from, message) -> self.get(0).close()));

    Receipt receipt = a.sendReliably(B, "hello");
    world.runMs(10);

    assertThat(receipt.isDelivered()).isTrue();
  }

  @Test
  void eachOfManyChannelsReceivesItsOwnMessages() {
    Comms comms = comms("a", 1);
    List<Endpoint<String>> endpoints = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      String instance = "i" + i;
      endpoints.add(
          comms.open(
              new Channel<>("talk", instance, new Text()),
              (from, message) -> heard.add(instance + " heard " + message)));
    }
    for (int i = 0; i < 100; i++) {
      endpoints.get(i).send(A, "i" + i);
    }
    for (int i = 0; i < 100; i += 3) {
      endpoints.get(i).close();
    }
    world.runMs(1);

    List<String> expected = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      if (i % 3 != 0) {
        expected.add("i" + i + " heard i" + i);
      }
    }
    assertThat(heard).isEqualTo(expected);
    assertThat(comms.dropped(DropReason.NO_LISTENER)).isEqualTo(34);
  }
}
