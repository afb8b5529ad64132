package org.starl.cli.schema;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import com.networknt.schema.ValidationMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Demo;
import org.starl.apps.Parameter;
import org.starl.cli.command.Apps;
import org.starl.cli.request.RunOptions;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.ScenarioFile;
import org.starl.input.BadInput;
import org.starl.input.Form;
import org.starl.sim.Setting;
import org.starl.sim.SimSettings;
import picocli.CommandLine;

/** Editors and commands accept the same scenario files. */
class ScenarioSchemaTest {

  private static final Path ROOT = Path.of("..");
  private static final Path COMMITTED = ROOT.resolve("docs/scenario.schema.json");
  private static final String FIRST_LINE =
      "# yaml-language-server: $schema=../docs/scenario.schema.json";
  private static final YAMLMapper YAML = new YAMLMapper();

  /** Of every kind, right for one setting and wrong for another. */
  private static final List<String> VALUES =
      List.of(
          "0 1 -1 4 2147483647 2147483648 0.5 1.5 -0.5 100 yes no on off true false maybe word 7up",
          "0ms 100ms 1.5s 2min 1h 60 5sec -3s 0mm 20mm 2.5cm 3m 5miles 0.5m/s 500mm/s 3deg 0.05rad",
          "uniform(10ms,20ms) normal(100ms,20ms) exponential(50ms) constant(5ms) uniform banana(1)",
          "uniform(10ms STOP_ON_COLLISION BUMPERCARS logical hostile none logica half crash(bot1)",
          "crash(bot1,at=12s,restart=5s) loss(0.3);crash(any) sight crush(bot1) robot_1.a 1s2 ms m",
          "1s#17 12.3s#17;14s#4 1s# #17");

  private static final JsonSchema SCHEMA =
      schema(new ObjectMapper().valueToTree(ScenarioSchema.json(Apps.ALL)));

  private static JsonSchema schema(JsonNode json) {
    return JsonSchemaFactory.getInstance(VersionFlag.V7).getSchema(json);
  }

  static Set<ValidationMessage> errors(String yaml) throws IOException {
    return SCHEMA.validate(YAML.readTree(yaml));
  }

  private static RunRequest request(Path file) {
    RunOptions.OfApp options = new RunOptions.OfApp();
    new CommandLine(options).parseArgs(file.toString());
    return options.request(Apps.ALL);
  }

  static List<Path> scenarioFiles() throws IOException {
    try (Stream<Path> files = Files.list(ROOT.resolve("scenarios"))) {
      return files.filter(Files::isRegularFile).sorted().toList();
    }
  }

  static Stream<Setting<?>> settings() {
    return RunRequest.known().stream();
  }

  static Stream<Demo> demos() {
    return Apps.ALL.all().stream();
  }

  @ParameterizedTest
  @MethodSource("scenarioFiles")
  void everyScenarioFileIsRightForEditorsAndCommands(Path file) throws IOException {
    assertThat(file.toString()).endsWith(".yaml");
    String text = Files.readString(file);
    assertThat(text).startsWith(FIRST_LINE + "\n");
    assertThat(
            schema(new ObjectMapper().readTree(Files.readString(COMMITTED)))
                .validate(YAML.readTree(text)))
        .isEmpty();
    // An app of another module is planned there.
    if (Apps.ALL.byName(ScenarioFile.read(file.toString()).app()).isPresent()) {
      assertThat(request(file).plan(1).simulation().build().plan().monitors()).isNotEmpty();
    }
  }

  @Test
  void theScenarioOfTheDocumentationIsValid() throws IOException {
    String page = Files.readString(ROOT.resolve("docs/scenarios.md"));
    String block = page.substring(page.indexOf("```yaml\n") + 8, page.indexOf("\n```\n"));
    assertThat(errors(block)).isEmpty();
  }

  @Test
  void everyAppHasAScenarioFile() throws IOException {
    assertThat(scenarioFiles())
        .extracting(file -> file.getFileName().toString())
        .containsAll(
            demos()
                .filter(demo -> demo.kind() == Demo.Kind.APP)
                .map(demo -> demo.name() + ".yaml")
                .toList());
  }

  @ParameterizedTest
  @MethodSource("settings")
  void aSettingAcceptsTheValuesOfItsReader(Setting<?> setting) throws IOException {
    int taken = 0;
    for (String value : String.join(" ", VALUES).split(" ")) {
      boolean isChaos = setting.equals(Setting.CHAOS);
      boolean isRead =
          isChaos && value.matches("true|false|yes|no|on|off") || isRead(setting, value);
      String yaml = "app: hello\n" + setting.key() + ": " + value + "\n";
      boolean isNumberForText =
          setting.form() instanceof Form.Text
              && !YAML.readTree(yaml).get(setting.key()).isTextual();
      if (isRead && !isNumberForText) {
        assertThat(errors(yaml)).as(yaml).isEmpty();
        taken++;
      } else if (!isRead) {
        assertThat(errors(yaml)).as(yaml).isNotEmpty();
      }
    }
    assertThat(taken).isPositive();
  }

  private static boolean isRead(Setting<?> setting, String value) {
    try {
      SimSettings.builder().read(setting, value);
      return true;
    } catch (BadInput error) {
      return false;
    }
  }

  @ParameterizedTest
  @MethodSource("demos")
  void anAppTakesItsParametersDefaultsAndNoOtherParameter(Demo demo) throws IOException {
    StringBuilder yaml = new StringBuilder("app: " + demo.name() + "\n");
    for (Parameter parameter : demo.parameters()) {
      String value = parameter.defaultValue();
      yaml.append(parameter.key()).append(": ").append(value.isEmpty() ? "''" : value).append('\n');
    }
    assertThat(errors(yaml.toString())).as(yaml.toString()).isEmpty();
    assertThat(errors(yaml + "zzz: 1\n")).isNotEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "faults: [crash(bot2,at=12s,restart=5s), loss(0.3,until=60s), sight]",
        "faults: [burst(2s,200ms,0.9,from=bot1), delay(uniform(10ms,200ms),to=bot2), drift(any,-9ppm)]",
        "faults:\n  - crash(bot2,at=12s,restart=5s)\n  - partition(bot0+bot1|bot2)",
        "faults: crash(bot2,at=12s,restart=5s); loss(0.3)",
        "faults: []"
      })
  void faultsAreAcceptedInEveryNotation(String faults) throws IOException {
    assertThat(errors("app: hello\n" + faults + "\n")).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "robots: 4",
        "app: helo",
        "app: hello\nsections: 4",
        "app: hello\nrobot: 4",
        "app: hello\nrobots: [4]",
        "app: mutex\nsections: 27",
        "app: mutex\nmembers: some",
        "app: intersection\nscenario: figure8",
        "app: intersection\narrivals: 20",
        "app: intersection\narrivals: 0/min",
        "app: hello\nfaults: [crush(bot2,at=12s)]",
        "app: hello\nfaults: crush(bot2)",
        "app: hello\nfaults:\n  a: b"
      })
  void valuesThatCommandsRefuseAreInvalid(String yaml) throws IOException {
    assertThat(errors(yaml + "\n")).isNotEmpty();
  }
}
