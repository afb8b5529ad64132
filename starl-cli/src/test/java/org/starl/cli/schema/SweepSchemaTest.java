package org.starl.cli.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.campaign.SeedWork;
import org.starl.cli.campaign.SweepFile;
import org.starl.cli.command.Apps;
import org.starl.input.BadInput;

/** Editors and commands accept the same sweeps. */
class SweepSchemaTest {

  private static final Path ROOT = Path.of("..");
  private static final YAMLMapper YAML = new YAMLMapper();
  private static final JsonSchema SCHEMA =
      schema(new ObjectMapper().valueToTree(SweepSchema.json(Apps.ALL)));

  private static JsonSchema schema(JsonNode json) {
    return JsonSchemaFactory.getInstance(VersionFlag.V7).getSchema(json);
  }

  private static SeedWork read(String yaml) {
    return SeedWork.sweep(SweepFile.of("sweep.yaml", yaml), Apps.ALL);
  }

  static List<Path> sweepFiles() throws IOException {
    try (Stream<Path> files = Files.list(ROOT.resolve("scenarios/sweeps"))) {
      return files.sorted().toList();
    }
  }

  @ParameterizedTest
  @MethodSource("sweepFiles")
  void everySweepFileIsRightForEditorsAndCommands(Path file) throws IOException {
    String text = Files.readString(file);
    assertThat(text).startsWith("# yaml-language-server: $schema=../../docs/sweep.schema.json\n");
    JsonNode committed =
        new ObjectMapper().readTree(Files.readString(ROOT.resolve("docs/sweep.schema.json")));
    assertThat(schema(committed).validate(YAML.readTree(text))).isEmpty();
    assertThat(read(text).points()).isNotEmpty();
  }

  @Test
  void theSweepOfTheDocumentationIsValid() throws IOException {
    String page = Files.readString(ROOT.resolve("docs/scenarios.md"));
    String sweeps = page.substring(page.indexOf("## Sweeps"));
    String block = sweeps.substring(sweeps.indexOf("```yaml\n") + 8, sweeps.indexOf("\n```\n"));
    assertThat(SCHEMA.validate(YAML.readTree(block))).isEmpty();
    assertThat(read(block).points()).hasSize(18);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "seeds: 1..5; sweep: {robots: [1, 2]}",
        "seeds: 5; robots: 3; sweep: {messageLoss: 0..0.4 in 3}; show: end_s",
        "seeds: 1..5; sweep: {messageDelay: [10ms, 'uniform(10ms,20ms)']}; show: [end_s, tasks]",
        "seeds: 1..5; sweep: {messageLoss: 0.0..0.4}; samples: 4; sampleSeed: -7",
        "seeds: 1..5; sweep: {floorWidth: 4..8m in 3, faults: [loss(0.1), stuck(any)]}",
        "seeds: 1..5; app: intersection; sweep: {scenario: [open], arrivals: [4/min, 8/min]}"
      })
  void aSweepThatTheCommandTakesIsValid(String text) throws IOException {
    String yaml = yaml(text);
    assertThat(SCHEMA.validate(YAML.readTree(yaml))).as(yaml).isEmpty();
    assertThat(read(yaml).points()).isNotEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "seeds: 1..5",
        "sweep: {robots: [1, 2]}",
        "seeds: x; sweep: {robots: [1, 2]}",
        "seeds: 1..5; sweep: {}",
        "seeds: 1..5; sweep: {robot: [1, 2]}",
        "seeds: 1..5; sweep: {arrivals: [4/min]}",
        "seeds: 1..5; sweep: {samples: [4]}",
        "seeds: 1..5; app: intersection; sweep: {arrivals: [4]}",
        "seeds: 1..5; sweep: {robots: []}",
        "seeds: 1..5; sweep: {robots: [many]}",
        "seeds: 1..5; sweep: {robots: many}",
        "seeds: 1..5; sweep: {robots: [1]}; samples: 0",
        "seeds: 1..5; sweep: {robots: [1]}; sampleSeed: x",
        "seeds: 1..5; sweep: {robots: [1]}; show: [[end_s]]",
        "seeds: 1..5; sweep: {robots: [1]}; shows: [end_s]",
        "seeds: 1..5; app: helo; sweep: {robots: [1]}"
      })
  void aSweepThatTheCommandRefusesIsInvalid(String text) throws IOException {
    String yaml = yaml(text);
    assertThat(SCHEMA.validate(YAML.readTree(yaml))).as(yaml).isNotEmpty();
    assertThatExceptionOfType(BadInput.class).as(yaml).isThrownBy(() -> read(yaml));
  }

  private static String yaml(String text) {
    return (text.contains("app:") ? "" : "app: hello\n") + text.replace("; ", "\n") + "\n";
  }
}
