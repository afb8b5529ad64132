package org.starl.robot.udp;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.List;
import javax.crypto.Mac;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as a beacon: what is one has one spelling, and no robot is believed without the key. */
public class BeaconFuzzTest {

  private static final DeploymentKey KEY = new DeploymentKey(new byte[DeploymentKey.BYTES]);
  private static final Mac MAC = KEY.newMac();
  private static final Beacon.Codec UNSIGNED = new Beacon.Codec(null);
  private static final Beacon.Codec SIGNED = new Beacon.Codec(KEY);
  private static final int TAG_BYTES = 16;

  public static void fuzzerTestOneInput(byte[] input) {
    Beacon beacon = UNSIGNED.readOrNull(input, input.length);
    if (beacon != null) {
      require(Arrays.equals(UNSIGNED.write(beacon), input), "another spelling");
      require(RobotId.isValid(beacon.robot().name()) && beacon.port() > 0, "no robot, no port");
    }
    // That a fuzzer finds a tag is as likely as that it finds the key.
    require(
        SIGNED.readOrNull(input, input.length) == null || isSample(input),
        "a beacon without the key");
    byte[] signed = Arrays.copyOf(input, input.length + TAG_BYTES);
    MAC.update(input);
    System.arraycopy(MAC.doFinal(), 0, signed, input.length, TAG_BYTES);
    Beacon believed = SIGNED.readOrNull(signed, signed.length);
    boolean fits = signed.length <= Beacon.MAX_BYTES;
    require(beacon == null || !fits || beacon.equals(believed), "signed, and not read");
    require(believed == null || Arrays.equals(SIGNED.write(believed), signed), "another spelling");
  }

  private static boolean isSample(byte[] input) {
    return samples().stream().anyMatch(sample -> Arrays.equals(sample, input));
  }

  private static List<byte[]> samples() {
    RobotId robot = new RobotId("bot1");
    return List.of(
        UNSIGNED.write(new Beacon(robot, 5, 7, null, 4747)),
        UNSIGNED.write(new Beacon(robot, 5, 7, address(4), 4747)),
        UNSIGNED.write(new Beacon(robot, -1, Long.MAX_VALUE, address(16), 65_535)),
        SIGNED.write(new Beacon(robot, 5, 7, address(4), 4747)));
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

  /** An IPv4 address inside one of IPv6 was read as the former: two spellings of one beacon. */
  @Test
  void anIpv4MappedAddressIsRefused() {
    byte[] input = UNSIGNED.write(new Beacon(new RobotId("b"), 5, 7, address(16), 4747));
    int addressAt = input.length - 2 - 16;
    Arrays.fill(input, addressAt, addressAt + 10, (byte) 0);
    Arrays.fill(input, addressAt + 10, addressAt + 12, (byte) 0xFF);
    fuzzerTestOneInput(input);

    assertThat(UNSIGNED.readOrNull(input, input.length)).isNull();
  }

  @Test
  void onlyBeaconsAreDecodedAsBeacons() {
    MalformedBytes.feed(samples(), BeaconFuzzTest::fuzzerTestOneInput);
  }
}
