package org.starl.processes;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What a fleet does where a process fails. */
class FleetTest {

  private final List<String> told = new ArrayList<>();

  private FleetResult run(String... main) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    command.addAll(List.of(main));
    FleetSettings settings = FleetSettings.within(Duration.ofSeconds(150));
    try (Fleet fleet = new Fleet(FaultyMain.blueprint(), command, settings, told::add)) {
      return fleet.run();
    }
  }

  @Test
  void aBugInAProcessEndsTheRunAndIsShown() throws IOException {
    FleetResult fleet = run(FaultyMain.class.getName());
    assertThat(fleet.isSafe()).isFalse();
    assertThat(fleet.errors()).as("%s", told).hasSize(1);
    assertThat(fleet.errors().get(0))
        .startsWith("bot1: java.lang.IllegalStateException: the bug")
        .contains("FaultyMain$Faulty.callStarL");
  }

  @Test
  void aProcessThatDoesNotComeUpEndsTheRun() throws IOException {
    FleetResult fleet = run("org.starl.NoSuchProgram");
    assertThat(fleet.isGood()).isFalse();
    assertThat(fleet.errors()).hasSize(1);
    assertThat(fleet.errors().get(0)).contains("its process ended by itself, with status 1");
    assertThat(told).anyMatch(line -> line.contains("NoSuchProgram"));
  }
}
