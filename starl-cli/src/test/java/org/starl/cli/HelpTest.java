package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.apps.Scenario;
import org.starl.bench.Workload;
import org.starl.cli.command.Apps;
import org.starl.cli.request.RunRequest;
import org.starl.sim.Setting;

/** Help, {@code list}, and small commands. */
class HelpTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "list",
        "run",
        "campaign",
        "merge",
        "sweep",
        "check",
        "prove",
        "verify-determinism",
        "record",
        "replay",
        "serve",
        "schema",
        "completion",
        "compile",
        "language-server",
        "new",
        "bench"
      })
  void everyHelpTextHasAnExample(String command) {
    Cli cli = Cli.run(command, "--help");
    assertThat(cli.status()).isZero();
    assertThat(cli.err()).isEmpty();
    assertThat(cli.out()).anyMatch(line -> line.startsWith("Usage: starl " + command));
    assertThat(cli.out()).anyMatch(line -> line.startsWith("Example: starl " + command));
  }

  @Test
  void helpWithACommandIsTheHelpTextOfTheCommand() {
    for (String command : List.of("run", "deploy", "bench")) {
      assertThat(Cli.run("help", command).out()).isEqualTo(Cli.run(command, "--help").out());
    }
    assertThat(Cli.run("help").out()).isEqualTo(Cli.run("--help").out());
  }

  @Test
  void everyWorkloadThatBenchTakesIsInTheList() {
    List<String> listed =
        Cli.run("list").out().stream()
            .filter(line -> line.startsWith("bench "))
            .map(line -> line.substring("bench ".length(), line.indexOf(':')))
            .sorted()
            .toList();
    String refused = Cli.run("bench", "nope").err().get(0);
    String known = refused.substring(refused.indexOf("expected ") + "expected ".length());
    assertThat(List.of(known.split(", | or "))).containsExactlyInAnyOrderElementsOf(listed);
  }

  @Test
  void theMainCommandHasHelpAndVersion() {
    Cli cli = Cli.run("--help");
    assertThat(cli.status()).isZero();
    assertThat(cli.text()).contains("list", "run", "campaign", "Example: starl run intersection");
    assertThat(Cli.run("--version").text()).startsWith("StarL ");
    assertThat(Cli.run("run", "--version").text()).startsWith("StarL ");
  }

  @Test
  void listHasALineForEach() {
    Cli cli = Cli.run("list");
    assertThat(cli.status()).isZero();
    for (Demo demo : Apps.ALL.all()) {
      String kind = demo.kind() == Demo.Kind.APP ? "app " : "primitive ";
      assertThat(cli.out()).containsOnlyOnce(kind + demo.name() + ": " + demo.summary());
      for (Scenario scenario : demo.scenarios()) {
        assertThat(cli.out())
            .containsOnlyOnce("  scenario " + scenario.name() + ": " + scenario.what());
      }
      for (Parameter parameter : demo.parameters()) {
        assertThat(cli.out()).anyMatch(line -> line.startsWith("  " + parameter.key() + "="));
      }
    }
    Workload.all()
        .forEach(load -> assertThat(cli.out()).anyMatch(l -> l.startsWith("bench " + load.name())));
    for (Setting<?> setting : RunRequest.known()) {
      assertThat(cli.out())
          .anyMatch(line -> line.startsWith("  " + setting.key() + "=" + setting.defaultText()));
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "b1 --robots 10 --style blocking",
        "b1 --robots 10 --style step",
        "b2 --robots 10 --style blocking",
        "b3a --robots 10 --style step",
        "b4b --robots 8 --style blocking"
      })
  void benchMeasures(String args) throws IOException {
    Cli cli = Cli.run(("bench --runs 1 --json " + args).split(" "));
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out()).hasSize(1);
    JsonNode json = new ObjectMapper().readTree(cli.text());
    assertThat(json.get("workload").asText()).isEqualTo(args.split(" ")[0]);
    assertThat(json.get("n").asText()).isEqualTo(args.split(" ")[2]);
    assertThat(json.get("events").asLong()).isPositive();
    assertThat(json.get("cpu_s").isNumber()).isTrue();
  }

  @Test
  void benchComparesTheCostOfAnEntryWithTheory() throws IOException {
    Cli table = Cli.run("bench", "mutex", "--robots", "4");
    assertThat(table.status()).as("%s", table).isZero();
    assertThat(table.out()).hasSize(4);
    assertThat(table.out().get(3)).startsWith("| 4 | 20 (20) | 9.0 (9) | ");
    JsonNode two =
        new ObjectMapper().readTree(Cli.run("bench", "mutex", "--robots", "2", "--json").text());
    assertThat(two.get("free_ms").asDouble()).isEqualTo(two.get("free_theory_ms").asDouble());
    // Both ask at once: one enters after its answer, the other a message after it has left.
    assertThat(two.get("busy_most_ms").asDouble()).isEqualTo(130);
    assertThat(two.get("busy_bound_ms").asDouble()).isEqualTo(140);
  }

  @Test
  void determinismIsVerified() throws IOException {
    Cli cli = Cli.run("verify-determinism", "hello", "--seed", "7");
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text()).contains("hello, seed 7: ", "equal, byte by byte: ");
    Cli json = Cli.run("verify-determinism", "hello", "--seed", "7", "--json");
    JsonNode object = new ObjectMapper().readTree(json.text());
    assertThat(object.get("equal").asBoolean()).isTrue();
    assertThat(object.get("lines").asLong()).isPositive();
    assertThat(object.get("runs").size()).isGreaterThanOrEqualTo(2);
  }

  @Test
  void listAsJsonHasAnObjectForEach() throws IOException {
    Cli plain = Cli.run("list");
    Cli json = Cli.run("list", "--json");
    assertThat(json.status()).isZero();
    // The plain list has headings: of settings, faults, envelopes.
    assertThat(json.out()).hasSize(plain.out().size() - 3);
    List<String> names = new ArrayList<>();
    for (String line : json.out()) {
      JsonNode item = new ObjectMapper().readTree(line);
      assertThat(item.path("what").asText()).as(line).isNotEmpty();
      names.add(item.path("kind").asText() + " " + item.path("name").asText());
    }
    assertThat(names)
        .contains("app intersection", "scenario figure7", "parameter debris", "setting robots")
        .contains("fault stuck(WHO)", "envelope logical");
  }
}
