package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.constraints.Size;
import net.jqwik.api.lifecycle.BeforeTry;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.testing.FakeWorld;

/** Whatever arrives, nothing is thrown, and nothing reaches a handler that its codec refuses. */
class MalformedDatagramTest {

  private static final RobotId B = new RobotId("b");
  private static final DropReason[] REASONS = DropReason.values();

  /** A message whose values cannot be just any bytes. */
  private record Even(int value, String word) {
    Even {
      if (value % 2 != 0 || !word.equals("even")) {
        throw new IllegalArgumentException("odd");
      }
    }
  }

  private static final class EvenCodec implements Codec<Even> {
    @Override
    public void write(Even message, WireWriter out) {
      out.i32(message.value);
      out.string(message.word);
    }

    @Override
    public Even read(WireReader in) {
      return new Even(in.i32(), in.string());
    }
  }

  private static final Channel<Even> EVEN = new Channel<>("even", "x", new EvenCodec());

  private FakeWorld world;
  private List<byte[]> sent;
  private List<Object> heard;
  private Comms receiver;
  private Receipt answered;

  @BeforeTry
  @BeforeEach
  void sendOneOfEachKind() {
    world = new FakeWorld("a", "b");
    sent = new ArrayList<>();
    heard = new ArrayList<>();
    Comms sender = new Comms(world.boot("a").platform(), 3);
    Endpoint<Even> endpoint = sender.open(EVEN, (from, message) -> {});
    receiver = new Comms(world.boot("b").platform(), 1);
    Endpoint<Even> open = receiver.open(EVEN, (from, message) -> heard.add(message));
    world.rule =
        (from, to, datagram) -> {
          sent.add(datagram);
          return new long[0];
        };
    endpoint.send(B, new Even(1024, "even"));
    endpoint.sendReliably(B, new Even(1024, "even"));
    endpoint.broadcast(new Even(1024, "even"));
    sender.acknowledge(B, 1, 1);
    answered = open.sendReliably(new RobotId("a"), new Even(1024, "even"));
  }

  private byte[] sent(int kind) {
    return sent.get(kind).clone();
  }

  private long dropped() {
    return Arrays.stream(REASONS).mapToLong(receiver::dropped).sum();
  }

  private void arrive(byte[] datagram) {
    world.inject(B, datagram);
    world.runMs(0);
  }

  @Test
  void theUnchangedDatagramsArrive() {
    List.copyOf(sent).subList(0, 4).forEach(this::arrive);

    assertThat(heard).hasSize(3);
    assertThat(answered.isDelivered()).isTrue();
    assertThat(dropped()).isZero();
  }

  @Property(tries = 4)
  void everyPrefixIsDropped(@ForAll @IntRange(max = 3) int kind) {
    byte[] whole = sent(kind);
    for (int length = 0; length < whole.length; length++) {
      arrive(Arrays.copyOf(whole, length));
    }

    assertThat(heard).isEmpty();
    assertThat(receiver.dropped(DropReason.TRUNCATED)).isEqualTo(whole.length);
  }

  @Property(tries = 4)
  void everyPrefixWithAMatchingLengthFieldIsDropped(@ForAll @IntRange(max = 3) int kind) {
    byte[] whole = sent(kind);
    for (int length = 6; length < whole.length; length++) {
      byte[] prefix = Arrays.copyOf(whole, length);
      prefix[5] = (byte) length;
      arrive(prefix);
    }

    assertThat(heard).isEmpty();
    assertThat(dropped()).isEqualTo(whole.length - 6L);
  }

  @Property
  void aDatagramWithTrailingBytesIsDropped(
      @ForAll @IntRange(max = 3) int kind,
      @ForAll boolean saysSo,
      @ForAll @Size(min = 1, max = 2_000) byte[] tail) {
    byte[] whole = sent(kind);
    byte[] longer = Arrays.copyOf(whole, whole.length + tail.length);
    System.arraycopy(tail, 0, longer, whole.length, tail.length);
    if (saysSo) {
      longer[4] = (byte) (longer.length >>> 8);
      longer[5] = (byte) longer.length;
    }
    arrive(longer);

    assertThat(heard).isEmpty();
    assertThat(answered.isDelivered()).isFalse();
    assertThat(dropped()).isEqualTo(1);
  }

  @Property
  void corruptedBytesAreDroppedOrFormAnotherValidMessage(
      @ForAll @IntRange(max = 3) int kind,
      @ForAll @LongRange(min = 0) long seed,
      @ForAll @IntRange(min = 1, max = 8) int changes) {
    Rng rng = new Rng(seed);
    byte[] datagram = sent(kind);
    for (int i = 0; i < changes; i++) {
      datagram[rng.nextInt(datagram.length)] ^= (byte) (1 + rng.nextInt(255));
    }
    long before = receiver.received();
    arrive(datagram);

    assertThat(receiver.received()).isEqualTo(before + 1);
    assertThat(heard.size() + (answered.isDelivered() ? 1 : 0) + dropped()).isEqualTo(1);
    assertThat(heard).allSatisfy(message -> assertThat(message).isInstanceOf(Even.class));
  }

  @Property
  void randomBytesAreDropped(@ForAll @Size(max = 1_500) byte[] bytes) {
    arrive(bytes);

    assertThat(heard).isEmpty();
    assertThat(dropped()).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0, FOREIGN",
    "1, 255, FOREIGN",
    "2, 2, OTHER_VERSION",
    "3, 0, UNKNOWN_KIND",
    "3, 4, UNKNOWN_KIND",
    "3, 3, BAD_NAME",
    "4, 1, TRUNCATED",
    "5, 5, OVERLONG",
    "6, 128, BAD_FIELD",
    "9, 0, BAD_FIELD",
    "10, 128, BAD_FIELD",
    "17, 0, BAD_FIELD",
    "18, 128, BAD_FIELD",
    "18, 64, BAD_FIELD",
    "26, 0, TRUNCATED",
    "26, 255, TRUNCATED",
    "27, 48, BAD_NAME",
    "27, 98, OWN",
    "28, 255, TRUNCATED",
    "29, 99, NOT_FOR_US",
    "30, 255, TRUNCATED",
    "31, 32, BAD_NAME",
    "31, 102, NO_LISTENER",
    "40, 1, BAD_PAYLOAD",
  })
  void eachFieldHasItsReason(int at, int value, DropReason reason) {
    byte[] datagram = sent(0);
    datagram[at] = (byte) value;
    arrive(datagram);

    assertThat(heard).isEmpty();
    assertThat(receiver.dropped(reason)).isEqualTo(1);
  }

  @Test
  void aRefusedPayloadIsNotAcknowledged() {
    byte[] datagram = sent(1);
    int last = datagram.length - 1;
    datagram[last] ^= 1;
    int before = sent.size();
    arrive(datagram);

    assertThat(receiver.dropped(DropReason.BAD_PAYLOAD)).isEqualTo(1);
    assertThat(sent).hasSize(before);
    datagram[last] ^= 1;
    arrive(datagram);
    assertThat(heard).hasSize(1);
    assertThat(sent).hasSize(before + 1);
  }
}
