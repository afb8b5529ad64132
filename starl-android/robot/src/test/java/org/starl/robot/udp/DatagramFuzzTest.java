package org.starl.robot.udp;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.comms.DropReason;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.session.KnownStarts;
import org.starl.session.Session;
import org.starl.sim.check.MalformedBytes;

/**
 * Any bytes as a datagram, without a seal and sealed with and without the key: a robot takes what
 * docs/wire-format.md calls a message for it, which is written here a second time, and nothing else; what
 * is sealed it takes once.
 */
public class DatagramFuzzTest {

  private static final RobotId SELF = new RobotId("b");
  private static final RobotId OTHER = new RobotId("a");
  private static final Participants BOTH = Participants.of(List.of(OTHER, SELF));
  private static final DeploymentKey KEY = key();
  private static final int MOST_BYTES = 1400;
  private static final int NAMES_AT = 26;
  private static final int PLAIN = 1;
  private static final int RELIABLE = 2;
  private static final List<byte[]> GENUINE = said(KEY);

  private static DeploymentKey key() {
    byte[] secret = new byte[DeploymentKey.BYTES];
    secret[0] = 1;
    return new DeploymentKey(secret);
  }

  /** What another robot sends, of each kind. */
  private static List<byte[]> said(@Nullable DeploymentKey key) {
    LoneRobot other = new LoneRobot(OTHER, BOTH, key);
    other.talk.send(SELF, "hello");
    other.talk.broadcast("to all \u00e4\ud83d\ude00");
    other.talk.sendReliably(SELF, "surely");
    List<byte[]> said = new ArrayList<>(other.sent);
    LoneRobot hearer = new LoneRobot(OTHER, BOTH, key);
    LoneRobot speaker = new LoneRobot(SELF, BOTH, key);
    speaker.talk.sendReliably(OTHER, "tell me");
    hearer.arrive(speaker.sent.get(0));
    said.addAll(hearer.sent);
    return said;
  }

  public static void fuzzerTestOneInput(byte[] input) {
    String message = messageOrNull(input);
    openTo(input, message);
    boolean isGenuine = GENUINE.stream().anyMatch(each -> Arrays.equals(each, input));
    if (!isGenuine) {
      LoneRobot robot = new LoneRobot(SELF, BOTH, KEY);
      robot.arrive(input);
      require(LoneRobot.dropped(robot.comms) == 1, "a forged one was taken for sealed");
      require(robot.heard.isEmpty() && robot.sent.isEmpty(), "a forged one had an effect");
    }
    sealed(input, message);
  }

  private static void openTo(byte[] input, @Nullable String message) {
    LoneRobot robot = new LoneRobot(SELF, BOTH, (DeploymentKey) null);
    robot.arrive(input);
    requireHeard(robot, message);
    if (message != null && input[3] == RELIABLE) {
      require(robot.sent.size() == 1, "no acknowledgement");
      robot.arrive(input);
      require(robot.heard.size() == 1, "heard a reliable one twice");
      require(robot.comms.dropped(DropReason.DUPLICATE) == 1, "no duplicate");
    }
  }

  /** A robot that has the key can still send any body. */
  private static void sealed(byte[] input, @Nullable String message) {
    int bodyAt = bodyAtOrNegative(input);
    if (bodyAt < 0) {
      return;
    }
    Session end =
        new KnownStarts(peer -> KEY.pairKey(OTHER, SELF), OTHER, 1, peer -> 1, () -> BOTH, null)
            .with(SELF);
    byte[] sealed = new byte[input.length + Session.BYTES];
    Objects.requireNonNull(end).seal(input, bodyAt, input.length, sealed);
    LoneRobot robot = new LoneRobot(SELF, BOTH, KEY);
    robot.arrive(sealed);
    String heard = isFromOther(input) ? message : null;
    requireHeard(robot, heard);
    robot.arrive(sealed);
    require(robot.heard.size() == (heard == null ? 0 : 1), "heard a recording");
    require(LoneRobot.dropped(robot.comms) == (heard == null ? 2 : 1), "a recording counts not");
    require(heard == null || robot.comms.dropped(DropReason.REPLAYED) == 1, "not replayed");
  }

  /** Where the body begins if the three names are in the datagram. */
  private static int bodyAtOrNegative(byte[] bytes) {
    int at = NAMES_AT;
    for (int i = 0; i < 3 && at < bytes.length; i++) {
      at += 1 + (bytes[at] & 0xFF);
    }
    return at > NAMES_AT && at <= bytes.length ? at : -1;
  }

  private static boolean isFromOther(byte[] bytes) {
    return bytes[NAMES_AT] == 1 && bytes[NAMES_AT + 1] == OTHER.name().charAt(0);
  }

  private static void requireHeard(LoneRobot robot, @Nullable String message) {
    require(
        robot.heard.equals(message == null ? List.of() : List.of(message)),
        "heard " + robot.heard + ", expected " + message);
    require(LoneRobot.dropped(robot.comms) == (message == null ? 1 : 0), "not counted");
  }

  /** What a datagram from anybody says to {@link #SELF} on the channel; null if nothing. */
  private static @Nullable String messageOrNull(byte[] bytes) {
    ByteBuffer in = ByteBuffer.wrap(bytes);
    try {
      boolean isOurs = in.get() == 'S' && in.get() == 'L' && in.get() == 1;
      int kind = in.get();
      boolean isWhole = in.getShort() == bytes.length && bytes.length <= MOST_BYTES;
      boolean isNumbered = in.getInt() > 0 && in.getLong() > 0;
      long clock = in.getLong();
      String from = name(in);
      String to = name(in);
      String channel = name(in);
      boolean isFor =
          to.equals(SELF.name()) && (kind == PLAIN || kind == RELIABLE)
              || to.isEmpty() && kind == PLAIN;
      boolean isOrdered = kind != RELIABLE || in.getLong() > 0;
      boolean isKnown = RobotId.isValid(from) && !from.equals(SELF.name());
      byte[] text = new byte[in.get() & 0xFF];
      in.get(text);
      boolean isMessage =
          isOurs
              && isWhole
              && isNumbered
              && clock >= 0
              && clock < 1L << 62
              && isFor
              && isOrdered
              && isKnown
              && channel.equals(LoneRobot.TALK.name())
              && !in.hasRemaining();
      return isMessage ? UTF_8.newDecoder().decode(ByteBuffer.wrap(text)).toString() : null;
    } catch (BufferUnderflowException | CharacterCodingException e) {
      return null;
    }
  }

  private static String name(ByteBuffer in) {
    byte[] name = new byte[in.get() & 0xFF];
    in.get(name);
    return new String(name, US_ASCII);
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  @Test
  @Tag("long")
  void aRobotAcceptsOnlyMessages() {
    List<byte[]> samples = new ArrayList<>(said(null));
    samples.addAll(GENUINE);
    assertThat(samples).hasSize(8);
    assertThat(samples.stream().filter(sample -> messageOrNull(sample) != null)).hasSize(3);

    MalformedBytes.feed(samples, DatagramFuzzTest::fuzzerTestOneInput);
  }
}
