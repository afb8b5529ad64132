package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.input.BadInput;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.RobotEntry;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as a deployment file: a deployment, or one line that names the file. */
public class DeploymentFileFuzzTest {

  // In a folder that is not there, so that no file's name in it means anything.
  private static final String FILE = "no-such-folder/fuzz.yaml";

  public static void fuzzerTestOneInput(byte[] input) {
    Deployment deployment;
    try {
      deployment = DeploymentFile.parse(FILE, input);
    } catch (BadInput refused) {
      requireLine(refused);
      return;
    }
    require(!deployment.robots().isEmpty(), "no robot in it");
    try {
      RobotEntry robot = deployment.robots().values().iterator().next();
      require(DeploymentFile.keys(deployment, robot) == null, "a key out of nowhere");
    } catch (BadInput refused) {
      requireLine(refused);
    }
  }

  private static void requireLine(BadInput refused) {
    String line = String.valueOf(refused.getMessage());
    boolean isShort = line.length() < 3_000;
    require(isShort && line.startsWith(FILE + ":"), line);
    require(line.chars().noneMatch(Character::isISOControl), "a line with controls: " + line);
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  /** A YAML reader returned null for this tagged number. */
  @Test
  void aNumberWithoutDigitsIsRefused() {
    byte[] input = "a: &x {b: !!int +, ? ,c : |\n }\n-]]]]]]1\n".getBytes(StandardCharsets.UTF_8);
    fuzzerTestOneInput(input);

    assertThatThrownBy(() -> DeploymentFile.parse(FILE, input)).isInstanceOf(BadInput.class);
  }

  @Test
  void anyBytesAreADeploymentOrRefusedInOneLine() throws IOException {
    Path crossing = Path.of("..", "..", "scenarios", "deployment", "crossing.yaml");
    String small =
        "app: intersection\nkey: k\nworld: h:1\npositions: {source: natnet, server: h, dataPort: 9}\n"
            + "robots:\n  a: {address: 'x:1', chassis: {kind: simulated}}\n"
            + "  b: {chassis: {kind: create, port: 'tcp:[::1]:4', simulatedAt: /dev/x}}\n"
            + "limits: {speedMmPerS: 1e2, watchdogMs: 40}\nnetwork: {loss: .5, broadcasts: yes}\n";
    assertThatCode(() -> DeploymentFile.parse(FILE, small.getBytes(StandardCharsets.UTF_8)))
        .doesNotThrowAnyException();
    MalformedBytes.feed(
        List.of(
            Files.readAllBytes(crossing),
            small.getBytes(StandardCharsets.UTF_8),
            small.replace("key: k", "key: \"k\\0\"").getBytes(StandardCharsets.UTF_8),
            small.replace("Port: 9", "Port: \"9\\n\\e\"").getBytes(StandardCharsets.UTF_8),
            small.replace("limits", "\"\\r\"").getBytes(StandardCharsets.UTF_8),
            small.replace("a: {", "\"\\a\": [").getBytes(StandardCharsets.UTF_8),
            "a: &x {b: !!int 1, ? c : |\n text\n, d: *x}\n---\n%YAML 1.1\n"
                .getBytes(StandardCharsets.UTF_8)),
        DeploymentFileFuzzTest::fuzzerTestOneInput);
  }
}
