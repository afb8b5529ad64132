package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.robot.udp.Beacon.Answer;
import org.starl.session.Nonce;
import org.starl.session.PairKey;
import org.starl.session.Start;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as a beacon: each beacon has one encoding, and none is genuine without the key. */
public class BeaconFuzzTest {

  private static final SigningKey KEY = new SigningKey(new PairKey(new byte[PairKey.BYTES]));
  private static final RobotId ROBOT = new RobotId("bot1");

  public static void fuzzerTestOneInput(byte[] input) {
    Beacon beacon = Beacon.readOrNull(input, input.length);
    if (beacon == null) {
      return;
    }
    boolean isSigned = Beacon.keyId(input) != 0;
    if (!isSigned) {
      require(Arrays.equals(beacon.write(null), input), "another encoding");
    } else {
      // That a fuzzer finds a tag is as likely as that it finds the key.
      require(
          !Beacon.isSignedWith(KEY, input, input.length) || isSample(input),
          "signed without a key");
    }
    byte[] signed = beacon.write(KEY);
    require(Beacon.isSignedWith(KEY, signed, signed.length), "a signature that does not hold");
    require(beacon.equals(Beacon.readOrNull(signed, signed.length)), "signed, and not read");
    require(RobotId.isValid(beacon.robot().name()) && beacon.port() > 0, "no robot, no port");
  }

  private static boolean isSample(byte[] input) {
    return samples().stream().anyMatch(sample -> Arrays.equals(sample, input));
  }

  private static Beacon beacon(@Nullable InetAddress address, @Nullable RobotId to, Answer answer) {
    Start start = new Start(-5, 3, new Nonce(1, 2));
    return new Beacon(ROBOT, start, 7, address, 4747, to, new Nonce(3, 4), answer);
  }

  private static List<byte[]> samples() {
    return List.of(
        beacon(null, null, Answer.ACCEPTED).write(null),
        beacon(address(4), null, Answer.ACCEPTED).write(null),
        beacon(address(16), new RobotId("a".repeat(32)), Answer.LATER_START).write(KEY),
        beacon(address(4), new RobotId("bot0"), Answer.OTHER_STORAGE).write(KEY));
  }

  private static InetAddress address(int length) {
    byte[] bytes = new byte[length];
    bytes[0] = 10;
    try {
      return InetAddress.getByAddress(bytes);
    } catch (UnknownHostException e) {
      throw new AssertionError(e);
    }
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  /** An IPv4 address inside one of IPv6 was read as the former: two encodings of one beacon. */
  @Test
  void anIpv4MappedAddressIsRefused() {
    byte[] input = beacon(address(16), null, Answer.ACCEPTED).write(null);
    int addressAt = input.length - 2 - 16;
    Arrays.fill(input, addressAt, addressAt + 10, (byte) 0);
    Arrays.fill(input, addressAt + 10, addressAt + 12, (byte) 0xFF);
    fuzzerTestOneInput(input);

    assertThat(Beacon.readOrNull(input, input.length)).isNull();
  }

  @Test
  void theLongestBeaconIsAsLongAsStated() {
    RobotId longest = new RobotId("r".repeat(32));
    Start start = new Start(1, 1, new Nonce(1, 1));
    Beacon beacon =
        new Beacon(longest, start, 1, address(16), 1, longest, Nonce.NONE, Answer.ACCEPTED);

    assertThat(beacon.write(KEY)).hasSize(Beacon.MAX_BYTES);
  }

  @Test
  void onlyBeaconsAreDecodedAsBeacons() {
    MalformedBytes.feed(samples(), BeaconFuzzTest::fuzzerTestOneInput);
  }
}
