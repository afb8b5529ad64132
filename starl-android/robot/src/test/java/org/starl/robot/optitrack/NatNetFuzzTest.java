package org.starl.robot.optitrack;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.sim.check.MalformedBytes;

/**
 * Any datagrams from a server of any version: the first byte of an input is the version, then come
 * datagrams, each behind its length. No frame is taken that was cut, none keeps more than its datagram
 * holds, and no fix is of what cannot stand on a floor.
 */
public class NatNetFuzzTest {

  private static final int LEAST_MODEL_BYTES = 9;
  private static final long STEP_NS = 7_000_000;
  private static final LittleEndianWriter OUT = new LittleEndianWriter();

  public static void fuzzerTestOneInput(byte[] input) {
    if (input.length < 1) {
      return;
    }
    NatNetVersion version = FullStream.VERSIONS.get((input[0] & 0xFF) % 5);
    long[] nowNs = {1_000_000_000};
    Tally tally = new Tally((timeNs, level, tag, line) -> requireLine(line), "fuzz");
    NatNetProtocol client =
        new NatNetProtocol(
            NatNetSettings.unicast(Loopback.HOST),
            tally,
            sent -> require(sent.length <= 274, "sends " + sent.length + " bytes"),
            bodies -> requireSound(bodies, nowNs[0]));
    int at = 1;
    while (input.length - at >= 2) {
      int length =
          Math.min((input[at] & 0xFF) | (input[at + 1] & 0xFF) << 8, input.length - at - 2);
      byte[] datagram = Arrays.copyOfRange(input, at + 2, at + 2 + length);
      at += 2 + length;
      parse(datagram, version);
      nowNs[0] += STEP_NS;
      client.tick(nowNs[0]);
      client.received(datagram, datagram.length, nowNs[0]);
      // A header in accord with the rest, so that what is behind it is read.
      byte[] fitted = fitted(datagram);
      parse(fitted, version);
      client.received(fitted, fitted.length, nowNs[0]);
      require(
          client.models().ids().size() * LEAST_MODEL_BYTES <= fitted.length
              || client.models().ids().size() * LEAST_MODEL_BYTES <= input.length,
          "keeps more models than came");
    }
  }

  private static byte[] fitted(byte[] datagram) {
    byte[] fitted = datagram.clone();
    if (fitted.length >= Message.HEADER_BYTES) {
      fitted[2] = (byte) (fitted.length - Message.HEADER_BYTES);
      fitted[3] = (byte) (fitted.length - Message.HEADER_BYTES >> 8);
    }
    return fitted;
  }

  /** Each parser by itself, for each sees more than the client lets through. */
  private static void parse(byte[] datagram, NatNetVersion version) {
    int length = datagram.length;
    MocapFrame frame = StreamTest.orNull(datagram, length, in -> FrameParser.parse(in, version));
    if (frame != null) {
      require(frame.bodies().size() * RigidBodyState.BYTES < length, "more bodies than bytes");
      require(
          frame.bodies().equals(readAgain(frame.bodies())), "bodies that cannot be written again");
      int stated = (datagram[2] & 0xFF) | (datagram[3] & 0xFF) << 8;
      for (int cut = Message.HEADER_BYTES + stated - 1; cut >= 0; cut = cut * 3 / 4 - 1) {
        require(
            StreamTest.orNull(datagram, cut, in -> FrameParser.parse(in, version)) == null,
            "a frame of which " + cut + " of " + length + " bytes came");
      }
    }
    Models models = StreamTest.orNull(datagram, length, in -> Models.parse(in, version));
    if (models != null) {
      require(models.ids().size() * LEAST_MODEL_BYTES <= length, "more models than bytes");
    }
    ServerInfo info = StreamTest.orNull(datagram, length, ServerInfo::parse);
    require(info == null || info.name().length() < 256, "a long name");
  }

  private static List<RigidBodyState> readAgain(List<RigidBodyState> bodies) {
    OUT.begin(Message.FRAME);
    bodies.forEach(body -> body.write(OUT));
    byte[] bytes = OUT.end();
    LittleEndianReader in = Message.payload(bytes, bytes.length);
    List<RigidBodyState> again = new ArrayList<>();
    for (int i = 0; i < bodies.size(); i++) {
      again.add(RigidBodyState.read(in));
    }
    return again;
  }

  private static void requireSound(List<TrackedBody> bodies, long nowNs) {
    for (TrackedBody body : bodies) {
      if (body.fix() != null) {
        Pose pose = body.fix().pose();
        require(Math.abs(pose.xMm()) <= 1e7 && Math.abs(pose.yMm()) <= 1e7, "far away");
        require(Math.abs(pose.headingRad()) <= StrictMath.PI, "heads nowhere");
        require(body.fix().timeNs() <= nowNs, "from the future");
        require(body.fix().errorMm() >= 5 && body.fix().errorMm() <= 1e5, "error in mm");
        require(
            body.fix().errorRad() >= 0.02 && body.fix().errorRad() <= StrictMath.PI,
            "error in rad");
      }
    }
  }

  private static void requireLine(String line) {
    require(line.length() < 1000 && line.chars().noneMatch(Character::isISOControl), line);
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  private static byte[] conversation(NatNetVersion version) {
    List<RigidBodyState> bodies =
        List.of(
            new RigidBodyState(11, 1, 0, 3, 0, 0, 0, 1, 0.001, true),
            new RigidBodyState(12, 1, 0, 3, 0, 0, 0, 1, 0.001, true));
    LittleEndianWriter out = new LittleEndianWriter();
    List<byte[]> datagrams =
        List.of(
            new ServerInfo("Motive", version, 10_000_000, false, 1511, 0).datagram(out),
            new FullStream(version).models(),
            out.begin(Message.ECHO_RESPONSE).i64(1_000_000_000 + 2 * STEP_NS).i64(5).end(),
            new FullStream(version).frame(1, bodies),
            new FullStream(version).frame(2, bodies),
            out.begin(Message.UNRECOGNIZED).end());
    byte[] whole = {(byte) FullStream.VERSIONS.indexOf(version)};
    for (byte[] datagram : datagrams) {
      byte[] more = Arrays.copyOf(whole, whole.length + 2 + datagram.length);
      more[whole.length] = (byte) datagram.length;
      more[whole.length + 1] = (byte) (datagram.length >> 8);
      System.arraycopy(datagram, 0, more, whole.length + 2, datagram.length);
      whole = more;
    }
    return whole;
  }

  @Test
  @Tag("long")
  void noDatagramsBreakTheClient() {
    List<byte[]> samples = new ArrayList<>();
    FullStream.VERSIONS.forEach(version -> samples.add(conversation(version)));

    MalformedBytes.feed(samples, NatNetFuzzTest::fuzzerTestOneInput);
  }
}
