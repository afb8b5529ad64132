package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.testing.FakeWorld;

/** A datagram counts once, in its session, and only if its sender sealed it. */
class SealTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final Channel<String> TALK =
      new Channel<>(
          "talk",
          "1",
          new Codec<>() {
            @Override
            public void write(String message, WireWriter out) {
              out.string(message);
            }

            @Override
            public String read(WireReader in) {
              return in.string();
            }
          });

  /** What {@code a} sends to {@code b}, as it is in the air. */
  private final List<byte[]> air = new ArrayList<>();

  private final List<String> heard = new ArrayList<>();
  private final FakeWorld world = new FakeWorld("a", "b");

  private static DeploymentKey key(int first) {
    byte[] secret = new byte[DeploymentKey.BYTES];
    Arrays.fill(secret, (byte) first);
    return new DeploymentKey(secret);
  }

  private Comms boot(RobotId id, int boot, @Nullable DeploymentKey key) {
    world.key = key;
    return new Comms(world.boot(id.name()).platform(), boot);
  }

  private Comms listener(@Nullable DeploymentKey key) {
    Comms comms = boot(B, 1, key);
    comms.open(TALK, (from, message) -> heard.add(message));
    return comms;
  }

  private Endpoint<String> talker(int boot, @Nullable DeploymentKey key) {
    return boot(A, boot, key).open(TALK, (from, message) -> {});
  }

  private void record() {
    record(1);
  }

  private void record(long... delaysNs) {
    world.rule =
        (from, to, datagram) -> {
          if (from.equals(A)) {
            air.add(datagram.clone());
          }
          return delaysNs;
        };
  }

  private void play(byte[] datagram) {
    world.inject(B, datagram);
    world.runMs(1);
  }

  @Test
  void datagramsWithTheKeyArrive() {
    Comms b = listener(key(1));
    Endpoint<String> a = talker(1, key(1));

    a.send(B, "plain");
    a.broadcast("all");
    Receipt receipt = a.sendReliably(B, "reliable");
    world.runMs(10);

    assertThat(heard).containsExactly("plain", "all", "reliable");
    assertThat(receipt.isDelivered()).isTrue();
    assertThat(b.dropped(DropReason.FORGED)).isZero();
  }

  @Test
  void datagramsUnderAnotherOrNoKeyAreDropped() {
    Comms b = listener(key(1));
    talker(1, key(2)).send(B, "another key");
    world.runMs(1);
    talker(2, null).send(B, "no key");
    world.runMs(1);

    assertThat(heard).isEmpty();
    assertThat(b.dropped(DropReason.OTHER_SESSION)).isEqualTo(1);
    assertThat(b.dropped(DropReason.FORGED)).isEqualTo(1);
  }

  @Test
  void theBodyOfASealedDatagramCannotBeRead() {
    listener(key(1));
    record();
    talker(1, key(1)).send(B, "a secret");
    world.runMs(1);

    assertThat(heard).containsExactly("a secret");
    assertThat(new String(air.get(0), StandardCharsets.ISO_8859_1))
        .contains("talk/1")
        .doesNotContain("secret");
  }

  @Test
  void aDatagramOfAnEarlierSessionIsDroppedEvenIfTheKeyIsTheSame() {
    listener(key(1));
    record();
    talker(1, key(1)).send(B, "yesterday");
    world.runMs(1);
    heard.clear();
    Comms restarted = listener(key(1));
    play(air.get(0));

    assertThat(heard).isEmpty();
    assertThat(restarted.dropped(DropReason.OTHER_SESSION)).isEqualTo(1);
  }

  @Test
  void aRobotWithoutAKeyDropsSealedDatagrams() {
    Comms b = listener(null);
    talker(1, key(1)).send(B, "sealed");
    world.runMs(1);

    assertThat(heard).isEmpty();
    assertThat(b.dropped(DropReason.OVERLONG)).isEqualTo(1);
  }

  @Test
  void aReplayedDatagramIsDropped() {
    Comms b = listener(key(1));
    record();
    Endpoint<String> a = talker(1, key(1));
    a.send(B, "once");
    a.sendReliably(B, "surely");
    world.runMs(10);
    List.copyOf(air).forEach(this::play);

    assertThat(heard).containsExactly("once", "surely");
    assertThat(b.dropped(DropReason.REPLAYED)).isEqualTo(2);
  }

  @Test
  void aRetransmissionIsNotAReplay() {
    listener(key(1));
    int[] acknowledgements = new int[1];
    world.rule =
        (from, to, datagram) -> {
          boolean isFirstAcknowledgement = from.equals(B) && acknowledgements[0]++ == 0;
          return isFirstAcknowledgement ? new long[0] : new long[] {1};
        };
    Receipt receipt = talker(1, key(1)).sendReliably(B, "surely");
    world.runMs(1_000);

    assertThat(receipt.isDelivered()).isTrue();
    assertThat(heard).containsExactly("surely");
  }

  @Test
  void replayedDatagramsOfADeadIncarnationAreDropped() {
    Comms b = listener(key(1));
    record();
    talker(1, key(1)).send(B, "first life");
    world.runMs(1);
    talker(2, key(1)).send(B, "second life");
    world.runMs(1);
    play(air.get(0));

    assertThat(heard).containsExactly("first life", "second life");
    assertThat(b.dropped(DropReason.OTHER_SESSION)).isEqualTo(1);
  }

  @Property(tries = 300)
  void aDatagramWithAChangedByteIsDropped(
      @ForAll @IntRange(max = 10_000) int at, @ForAll @IntRange(min = 1, max = 255) int change) {
    air.clear();
    heard.clear();
    Comms b = listener(key(1));
    record();
    talker(1, key(1)).send(B, "as it was");
    byte[] changed = air.get(0).clone();
    changed[at % changed.length] ^= (byte) change;
    play(changed);

    assertThat(heard).containsOnlyOnce("as it was").hasSize(1);
    assertThat(dropped(b)).isEqualTo(1);
  }

  private static long dropped(Comms comms) {
    return Arrays.stream(DropReason.values()).mapToLong(comms::dropped).sum();
  }

  @Property(tries = 100)
  void aCountIsAcceptedOnceInAnyOrder(
      @ForAll @Size(max = 60) List<@IntRange(min = 1, max = 4_000) Integer> counts) {
    air.clear();
    heard.clear();
    Comms b = listener(key(1));
    record(new long[0]);
    Endpoint<String> a = talker(1, key(1));
    int last = counts.stream().max(Integer::compare).orElse(0);
    for (int count = 1; count <= last; count++) {
      a.send(B, String.valueOf(count));
    }
    List<String> expected = new ArrayList<>();
    int highest = 0;
    for (int count : counts) {
      boolean isKnowable = count > highest - Seal.WINDOW;
      if (isKnowable && !expected.contains(String.valueOf(count))) {
        expected.add(String.valueOf(count));
      }
      highest = Math.max(highest, count);
      play(air.get(count - 1));
    }

    assertThat(heard).as("%s", counts).isEqualTo(expected);
    assertThat(dropped(b)).isEqualTo(counts.size() - expected.size());
  }
}
