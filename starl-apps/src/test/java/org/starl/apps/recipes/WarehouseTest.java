package org.starl.apps.recipes;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.sim.Setting;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;
import org.starl.sim.junit.RunChecks;
import org.starl.sim.junit.StarlTest;

/** The warehouse of docs/warehouse.md. */
class WarehouseTest {

  @Tag("long")
  @StarlTest(seeds = 10, chaos = Envelope.MOVING)
  void everyCrateArrivesOnce(Simulation.Builder simulation, RunChecks checks) {
    WarehouseDemo.fill(simulation, WarehouseDemo.ROBOTS, 8, WarehouseApp.Bug.NONE);
    checks.check(result -> assertThat(result.results()).hasSize(WarehouseDemo.ROBOTS));
  }

  @Test
  @Tag("long")
  void anAisleWhoseDirectionsDoNotExcludeEachOtherIsFound() {
    // Reach tubes keep the bodies apart; so robots stand at both ends, each in the other's way.
    assertThat(firstSeedThatLosesAnOrder(WarehouseApp.Bug.NO_CONFLICT, Envelope.NONE)).isOne();
  }

  @Test
  @Tag("long")
  void aCarrierThatBelievesAfterARestartThatItHasDeliveredIsFound() {
    assertThat(firstSeedThatLosesAnOrder(WarehouseApp.Bug.FORGETS, Envelope.MOVING)).isPositive();
  }

  /** Of the first ten seeds; 0 if none does. */
  private static long firstSeedThatLosesAnOrder(WarehouseApp.Bug bug, Envelope chaos) {
    for (long seed = 1; seed <= 10; seed++) {
      Simulation.Builder simulation =
          Simulation.builder()
              .seed(seed)
              .settings(SimSettings.builder().set(Setting.CHAOS, chaos).build());
      WarehouseDemo.fill(simulation, WarehouseDemo.ROBOTS, 8, bug);
      SimResult result = simulation.build().run();
      if (result.spec().violations().stream().anyMatch(v -> v.lemma().equals("no_order_lost"))) {
        return seed;
      }
    }
    return 0;
  }

  @Test
  void thePageShowsTheCodeThatRuns() throws IOException {
    Path sources = Path.of("src/test/java/org/starl/apps/recipes");
    String code =
        Files.readString(sources.resolve("WarehouseApp.java"))
            + Files.readString(sources.resolve("WarehouseSpec.java"));
    Matcher block =
        Pattern.compile("```java\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(Path.of("../docs/warehouse.md")));
    int blocks = 0;
    while (block.find()) {
      assertThat(code).contains(block.group(1).stripTrailing());
      blocks++;
    }
    assertThat(blocks).isGreaterThan(4);
  }
}
