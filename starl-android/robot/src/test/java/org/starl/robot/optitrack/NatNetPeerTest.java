package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.geometry.Pose;
import org.starl.platform.Clock;
import org.starl.robot.realtime.RealClock;

/**
 * The server as others decode it: PyPI's {@code natnet}, which shares nothing with this code. Runs
 * where the environment's {@code STARL_NATNET} is a folder that {@code pip install --target} has put
 * version 0.3.0 into.
 */
@Tag("realtime")
class NatNetPeerTest {

  private static final String PACKAGE = System.getenv("STARL_NATNET");
  private static final String SCRIPT = "natnet_peer.py";

  private final Clock clock = new RealClock();
  private final Loopback loopback = new Loopback();

  @ParameterizedTest
  @CsvSource({"3,1,false", "4,1,false", "4,2,false", "3,1,true", "4,1,true", "4,2,true"})
  void anIndependentDecoderReadsTheSame(
      int major, int minor, boolean isMulticast, @TempDir Path folder) throws Exception {
    assumeTrue(PACKAGE != null, "STARL_NATNET names no folder with PyPI's natnet");
    InetSocketAddress group = isMulticast ? Loopback.freeGroup() : null;
    if (isMulticast) {
      Loopback.assumeMulticast();
    }
    NatNetServerSettings settings =
        Loopback.server(
            group, new NatNetVersion(major, minor), new Axes(UpAxis.Z, BodyAxis.PLUS_X), 100);
    PoseSource source =
        () ->
            new PoseSource.Snapshot(
                clock.nowNs(),
                List.of(
                    new PoseSource.Body("bot0", new Pose(1500, -250, 0), true, 2),
                    new PoseSource.Body("Ännchen", new Pose(0, 0, StrictMath.PI), false, 0)));
    List<String> expected = expected(major + "." + minor);
    try (NatNetServer server = loopback.serve(settings, source, clock)) {
      assertThat(decode(folder, server.address().getPort(), group)).isEqualTo(expected);
    }
    assertThat(loopback.failures).isEmpty();
  }

  private static List<String> expected(String version) {
    // Names of a body's own markers came with version 4.
    String markers = version.equals("3.1") ? "None None None" : "Marker1 Marker2 Marker3";
    List<String> lines = new ArrayList<>();
    lines.add("server StarL " + version);
    lines.add(
        "marker set all bot0_Marker1 bot0_Marker2 bot0_Marker3"
            + " Ännchen_Marker1 Ännchen_Marker2 Ännchen_Marker3");
    lines.add("description 1 bot0 " + markers);
    lines.add("description 2 Ännchen " + markers);
    for (int frame = 0; frame < 3; frame++) {
      lines.add("body 1 1.500 -0.250 0.000 0.000 0.000 0.000 1.000 0.002 True");
      lines.add("body 2 0.000 0.000 0.000 0.000 0.000 1.000 0.000 0.000 False");
      lines.add("markers 3 [1]");
    }
    return lines;
  }

  private static List<String> decode(Path folder, int commandPort, InetSocketAddress group)
      throws IOException, InterruptedException {
    Path script = folder.resolve(SCRIPT);
    try (InputStream in = NatNetPeerTest.class.getResourceAsStream(SCRIPT)) {
      Files.copy(in, script);
    }
    List<String> command = new ArrayList<>();
    Collections.addAll(command, "python3", script.toString(), String.valueOf(commandPort));
    command.add(String.valueOf(group == null ? NatNetSettings.DATA_PORT : group.getPort()));
    command.add(group == null ? "-" : group.getAddress().getHostAddress());
    Path printed = folder.resolve("printed");
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("PYTHONPATH", PACKAGE);
    builder.environment().put("PYTHONIOENCODING", "utf-8");
    Process process = builder.redirectErrorStream(true).redirectOutput(printed.toFile()).start();
    boolean hasEnded = process.waitFor(60, TimeUnit.SECONDS);
    process.destroyForcibly();
    assertThat(hasEnded).isTrue();
    return Files.readAllLines(printed, StandardCharsets.UTF_8);
  }
}
