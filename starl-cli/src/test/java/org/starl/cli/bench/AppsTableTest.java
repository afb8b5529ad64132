package org.starl.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.starl.apps.Demo;
import org.starl.apps.Input;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.request.RunRequest;

/** {@code starl bench apps} on the files of the original StarL. */
class AppsTableTest {

  private static final Path DATA =
      Path.of(System.getProperty("starl.shared", "../../shared")).resolve("data");

  @BeforeAll
  static void theFilesAreThere() {
    assumeTrue(Files.isDirectory(DATA), "skipped: no folder " + DATA + " (set -Dstarl.shared)");
  }

  @Test
  void aRowForEachInputWithAndWithoutLoss() {
    Cli result =
        Cli.run(
            "bench",
            "apps",
            "--inputs",
            DATA.toString(),
            "--app",
            "intersection",
            "--seeds",
            "1..2");

    assertThat(result.status()).isZero();
    assertThat(result.out().subList(2, 4))
        .satisfiesExactly(
            row ->
                assertThat(row).startsWith("| intersection | intersection/ | none | 2 | 2 | 0 |"),
            row ->
                assertThat(row).startsWith("| intersection | intersection/ | 20 % | 2 | 2 | 0 |"));
  }

  @Test
  void everyInputIsThereAndCanBePlanned() {
    for (Demo demo : Apps.OWN.all()) {
      List<Input> inputs = demo.inputs(DATA);
      for (Input input : inputs) {
        assertThat(input.path()).as(demo.name() + " on " + input.name()).exists();
        assertThat(demo.defaults().keySet()).containsAll(input.parameters().keySet());
        RunRequest.Builder request = new RunRequest.Builder(demo);
        input.parameters().forEach((key, value) -> request.set("", key, value));
        assertThat(request.build().plan(1).simulation().build()).isNotNull();
      }
    }
  }
}
