package org.starl.cli.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;

/** What went wrong in Open-RMF (the table in docs/apps/fleet.md) goes well here. */
class RmfScenariosTest {

  private static final Path FOLDER = Path.of("../scenarios/rmf");

  private static void assertGood(String name, String... options) {
    Path map = FOLDER.resolve(name + ".building.yaml");
    String line = "campaign " + FOLDER.resolve(name + ".yaml") + " --set map=" + map;
    Cli run = Cli.line(Apps.ALL, line + " " + String.join(" ", options));
    assertThat(run.status()).as(run.text()).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"dock", "conveyor", "midlane", "two-groups", "corridor"})
  void everyDeliveryArrivesAndNoTwoRobotsAreInOneMutex(String name) throws IOException {
    String text = Files.readString(FOLDER.resolve(name + ".yaml"));
    assertThat(text)
        .startsWith("# yaml-language-server: $schema=../../docs/scenario.schema.json\n")
        .contains("\nmap: scenarios/rmf/" + name + ".building.yaml\n");
    assertThat(ScenarioSchemaTest.errors(text)).isEmpty();
    assertGood(name, "--seeds 1..4");
  }

  /** Two robots waited for each other, as one gave back the place to which it drove when it restarted. */
  @Test
  void aRobotThatRestartsOnItsWayKeepsThePlaceToWhichItDrives() {
    assertGood("two-groups", "--chaos --seeds 62..62");
  }

  /** It was on its lane, and said that it was on the one behind. */
  @Test
  void aRobotThatRestartsSomeMillimetresBehindAVertexPassesIt() {
    assertGood("dock", "--chaos --seeds 43..43");
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = {"dock", "conveyor", "midlane", "two-groups", "corridor"})
  void alsoWithChaos(String name) {
    assertGood(name, "--chaos --seeds 1..20");
  }
}
