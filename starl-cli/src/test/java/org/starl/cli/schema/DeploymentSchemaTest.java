// Longer than 500 lines because the file with everything has each field of each kind.
package org.starl.cli.schema;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Demos;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.request.DeployedApp;
import org.starl.input.BadInput;
import org.starl.input.Field;
import org.starl.input.Form;
import org.starl.launch.DeploymentFile;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.DeploymentFormat;

/** Editors and {@code deploy check} accept the same deployment files. */
class DeploymentSchemaTest {

  private static final Path ROOT = Path.of("..");
  private static final Path COMMITTED = ROOT.resolve("docs/deployment.schema.json");
  private static final YAMLMapper YAML = new YAMLMapper();

  /** Of every kind, right for one field and wrong for another. */
  private static final String PUBLIC_KEY =
      "MFkwEwYHKoZIzj0CAQYIKoZIzj0DAQcDQgAEaxfR8uEsQkf4vOblY6RA8ncDfYEt6zOg9KE5RdiYwpZP40Li/hp/m47n"
          + "60p8D54WK84zV2sxXs7LtkBoN79R9Q==";

  private static final List<String> VALUES =
      List.of(
          ("0 1 -1 19 20 50 100 300 499.5 500 501 1000 1000.5 1001 3600000 3600001 0.5 -0.5 3.5 4.1 3.9"
                  + " 9600 65535 65536 2147483648 yes no true false maybe y z create1 create3 natnet json"
                  + " create simulated bumper my.key 239.255.42.99 239.255.42 224.0.0 192.168.1 192.168.1:4747 1.2.3.256 ff02::1 /dev/ttyUSB0 tcp:h:1 tcp:h"
                  + " tcp:h:0 tcp:h:65536"
                  + " h:4747 h:0 h:04747 h:65536 'h:' ':4747' 192.168.1.10 192.168.1.10:4747 [fe80::1]"
                  + " '[fe80::1]:4747' 'fe80::1' 'a b' ' ' '' [1] '{a}' 5d 0x1p3 NaN"
                  + " "
                  + "ros2 direct '/{robot}/pose' '{robot}/pose' /pose PoseStamped Pose map odom base_link reliable volatile /car Twist Bool hit "
                  + PUBLIC_KEY)
              .split(" (?=(?:[^']*'[^']*')*[^']*$)"));

  private static final JsonSchema SCHEMA =
      schema(new ObjectMapper().valueToTree(DeploymentSchema.json(demos())));

  @TempDir private Path folder;

  /** Two will do, and are quickly tried. */
  private static Demos demos() {
    return new Demos(
        Apps.ALL.all().stream()
            .filter(demo -> List.of("hello", "intersection").contains(demo.name()))
            .toList());
  }

  private static JsonSchema schema(JsonNode json) {
    return JsonSchemaFactory.getInstance(VersionFlag.V7).getSchema(json);
  }

  /**
   * One place in a file.
   *
   * @param path of the lines above it
   * @param kind which lines those have that have kinds, else empty
   * @param fields all that may stand there
   */
  private record Place(List<String> path, String kind, List<Field<?>> fields) {
    @Override
    public String toString() {
      return path + kind;
    }
  }

  private record Spot(Place place, Field<?> field) {
    @Override
    public String toString() {
      return place + " " + field.key();
    }
  }

  static List<Place> places() {
    List<Place> places = new ArrayList<>();
    add(places, List.of(), "", DeploymentFormat.FILE);
    return places;
  }

  private static void add(List<Place> places, List<String> path, String of, Form form) {
    switch (form) {
      case Form.Lines lines -> {
        places.add(new Place(path, of, lines.fields()));
        lines.fields().forEach(field -> add(places, under(path, field.key()), of, field.form()));
      }
      case Form.Kinds kinds ->
          kinds
              .kinds()
              .forEach((kind, fields) -> {
                List<Field<?>> all = new ArrayList<>(List.of(kinds.by()));
                all.addAll(fields);
                places.add(new Place(path, kind, all));
                fields.forEach(field -> add(places, under(path, field.key()), kind, field.form()));
              });
      case Form.Named named -> add(places, under(path, "bot0"), of, named.each());
      default -> {
        // One value.
      }
    }
  }

  private static List<String> under(List<String> path, String key) {
    List<String> longer = new ArrayList<>(path);
    longer.add(key);
    return longer;
  }

  static List<Spot> spots() {
    List<Spot> spots = new ArrayList<>();
    for (Place place : places()) {
      place.fields().forEach(field -> spots.add(new Spot(place, field)));
    }
    return spots;
  }

  /** Everything that may be there: a robot's own key excludes the one key for all. */
  private static Map<String, Object> full(Place place) {
    Map<String, Object> file = full(place.kind());
    if (place.path().equals(List.of("robots", "bot0"))) {
      file.remove("key");
    } else {
      at(file, List.of("robots", "bot0")).remove("publicKey");
    }
    return file;
  }

  private static Map<String, Object> full(String kind) {
    return map(
        "app",
        "hello",
        "parameters",
        map("messageLoss", "0.3"),
        "seed",
        "7",
        "key",
        "my.key",
        "network",
        map(
            "port", "4747",
            "broadcasts", "yes",
            "beaconEveryMs", "50",
            "suspectAfterMs", "3600000",
            "loss", "0.1"),
        "positions",
        kind.equals("ros2")
            ? map(
                "source", "ros2",
                "topic", "'/{robot}/pose'",
                "type", "Odometry",
                "frame", "map",
                "sigmas", "3",
                "reliability", "reliable",
                "durability", "volatile",
                "errorMm", "5",
                "errorRad", "1")
            : kind.equals("json")
                ? map(
                    "source",
                    "json",
                    "port",
                    "1520",
                    "listen",
                    "192.168.1.10",
                    "sender",
                    "h",
                    "key",
                    "lines.key",
                    "errorMm",
                    "5",
                    "errorRad",
                    "1")
                : map(
                    "source", "natnet",
                    "server", "192.168.1.2",
                    "dataPort", "1511",
                    "multicast", "239.255.42.99",
                    "interface", "wlan0",
                    "version", "4.1",
                    "up", "z",
                    "errorMm", "5",
                    "errorRad", "0.02"),
        "world",
        "h:4000",
        "robots",
        map(
            "bot0",
            kind.equals("ros2")
                ? rosRobot()
                : map(
                    "platform",
                    "direct",
                    "address",
                    "192.168.1.10",
                    "rigidBody",
                    "car",
                    "publicKey",
                    PUBLIC_KEY,
                    "chassis",
                    chassis(kind),
                    "objects",
                    "positions")),
        "limits",
        map(
            "speedMmPerS",
            "300",
            "watchdogMs",
            "200",
            "positionMs",
            "500",
            "speedError",
            "0.05",
            "reactionMs",
            "100"));
  }

  private static Map<String, Object> rosRobot() {
    return map(
        "platform",
        "ros2",
        "address",
        "192.168.1.10",
        "rigidBody",
        "car",
        "publicKey",
        PUBLIC_KEY,
        "namespace",
        "/car",
        "axleMm",
        "160",
        "topics",
        map(
            "command",
            map(
                "name",
                "cmd_vel",
                "type",
                "Twist",
                "reliability",
                "reliable",
                "durability",
                "volatile"),
            "odometry",
            map("name", "odom", "reliability", "reliable", "durability", "volatile"),
            "contacts",
            map(
                "name",
                "hit",
                "type",
                "Bool",
                "nearMm",
                "200",
                "reliability",
                "reliable",
                "durability",
                "volatile")),
        "objects",
        "positions");
  }

  private static Map<String, Object> chassis(String kind) {
    if (kind.equals("simulated")) {
      return map("kind", "simulated");
    }
    Map<String, Object> create =
        map("kind", "create", "model", "create1", "port", "/dev/ttyUSB0", "baud", "9600");
    // Its world has no cameras that send JSON.
    if (!kind.equals("json")) {
      create.put("simulatedAt", "tcp:h:4001");
    }
    return create;
  }

  private static Map<String, Object> map(Object... keysAndValues) {
    Map<String, Object> map = new LinkedHashMap<>();
    for (int i = 0; i < keysAndValues.length; i += 2) {
      map.put((String) keysAndValues[i], keysAndValues[i + 1]);
    }
    return map;
  }

  // The line above an indented line is such a mapping.
  @SuppressWarnings("unchecked")
  private static Map<String, Object> at(Map<String, Object> file, List<String> path) {
    Map<String, Object> here = file;
    for (String key : path) {
      here = (Map<String, Object>) here.get(key);
    }
    return here;
  }

  private static String yaml(Object value) {
    if (value instanceof Map<?, ?> map) {
      StringBuilder text = new StringBuilder("{");
      map.forEach((key, each) ->
          text.append(text.length() == 1 ? "" : ", ").append(key).append(": ").append(yaml(each)));
      return text.append("}").toString();
    }
    return (String) value;
  }

  private String errorOrNone(String yaml) throws IOException {
    Path file = folder.resolve("my.yaml");
    Files.writeString(file, yaml);
    try {
      Deployment deployment = DeploymentFile.read(file.toString());
      DeployedApp.of(deployment, demos());
      return "";
    } catch (BadInput error) {
      return String.valueOf(error.getMessage());
    }
  }

  private void assertAgree(String yaml) throws IOException {
    String error = errorOrNone(yaml);
    if (error.isEmpty()) {
      assertThat(SCHEMA.validate(YAML.readTree(yaml))).as(yaml).isEmpty();
    } else {
      assertThat(SCHEMA.validate(YAML.readTree(yaml))).as("%s: %s", yaml, error).isNotEmpty();
    }
  }

  @ParameterizedTest
  @MethodSource("places")
  void aFileWithEverythingIsRight(Place place) throws IOException {
    Map<String, Object> file = full(place);
    assertThat(at(file, place.path()).keySet())
        .containsExactlyElementsOf(place.fields().stream().map(Field::key).toList());

    assertThat(errorOrNone(yaml(file))).isEmpty();
    assertAgree(yaml(file));
  }

  @ParameterizedTest
  @MethodSource("places")
  void anUnknownFieldIsRefusedAndTheKnownOnesAreNamed(Place place) throws IOException {
    Map<String, Object> file = full(place);
    at(file, place.path()).put("zzz", "1");

    assertThat(errorOrNone(yaml(file)))
        .contains("'zzz'")
        .endsWith(
            "expected one of " + new TreeSet<>(place.fields().stream().map(Field::key).toList()));
    assertAgree(yaml(file));
  }

  @ParameterizedTest
  @MethodSource("spots")
  void aFieldAcceptsTheValuesOfItsReader(Spot spot) throws IOException {
    int taken = 0;
    int refused = 0;
    for (String value : VALUES) {
      Map<String, Object> file = full(spot.place());
      at(file, spot.place().path()).put(spot.field().key(), value);
      String yaml = yaml(file);
      boolean isRead = errorOrNone(yaml).isEmpty();
      if (isRead && !isUnquoted(spot, yaml)) {
        taken++;
      } else if (!isRead) {
        refused++;
      }
      if (!isRead || !isUnquoted(spot, yaml)) {
        assertAgree(yaml);
      }
    }
    boolean isOfLines =
        spot.field().form() instanceof Form.Lines
            || spot.field().form() instanceof Form.Named
            || spot.field().form() instanceof Form.Parameters;
    // A value is not lines; every other field takes one of the values, or, as a kind, a file of its
    // own.
    assertThat(refused).as("refused of %s", spot).isPositive();
    if (!isOfLines && !(spot.field().form() instanceof Form.Kinds) && !isOfApp(spot)) {
      assertThat(taken).as("taken of %s", spot).isPositive();
    }
  }

  private static boolean isOfApp(Spot spot) {
    return spot.field().key().equals("app");
  }

  /** Whether YAML reads the text of a field as a number: quotes prevent that. */
  private static boolean isUnquoted(Spot spot, String yaml) throws IOException {
    JsonNode node = YAML.readTree(yaml);
    for (String key : spot.place().path()) {
      node = node.get(key);
    }
    Form form = spot.field().form();
    return (form instanceof Form.Address || form instanceof Form.Port)
        && !node.get(spot.field().key()).isTextual();
  }

  /** Whether this field decides the kind, and its default is another kind than the file's. */
  private static boolean isOtherKind(Spot spot) {
    return spot.field().key().equals("platform")
        && !spot.place().kind().equals(spot.field().defaultText());
  }

  @ParameterizedTest
  @MethodSource("spots")
  void schemaAndReaderRequireTheSameFields(Spot spot) throws IOException {
    Map<String, Object> file = full(spot.place());
    at(file, spot.place().path()).remove(spot.field().key());
    // No field describes these: a board needs an app, and the two lines below need each other.
    boolean isAppOfBoards = spot.field().key().equals("app");
    boolean isKeyOfBroadcasts =
        (spot.field().key().equals("key") && spot.place().path().isEmpty())
            || spot.field().key().equals("publicKey");
    boolean isWorldOfSimulated = spot.field().key().equals("world") || isOtherKind(spot);

    assertThat(errorOrNone(yaml(file)).isEmpty())
        .as(yaml(file))
        .isEqualTo(
            !spot.field().isNeeded()
                && !isAppOfBoards
                && !isKeyOfBroadcasts
                && !isWorldOfSimulated);
    if (!isAppOfBoards && !isKeyOfBroadcasts && !isWorldOfSimulated) {
      assertAgree(yaml(file));
    }
  }

  @ParameterizedTest
  @MethodSource("spots")
  void everyFieldHasADescriptionAndDefault(Spot spot) throws IOException {
    Field<?> field = spot.field();
    assertThat(field.meaning()).isNotBlank().doesNotEndWith(".");
    if (field.key().matches(".*(Ms|Mm|Rad|MmPerS)")) {
      assertThat(field.meaning()).containsPattern("in (ms|mm|rad|mm/s)\\b");
    }
    if (field.defaultText() != null && !isOtherKind(spot)) {
      Map<String, Object> file = full(spot.place());
      String text = field.defaultText();
      at(file, spot.place().path()).put(field.key(), text.contains("{") ? "'" + text + "'" : text);
      assertThat(errorOrNone(yaml(file))).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{messageLoss: 0.3, speedError: 0.05}",
        "{messageLoss: 2}",
        "{zones: 3}",
        "{faults: [sight]}",
        "{faults: sight}",
        "{faults: crush}",
        "{seed: 3}"
      })
  void parametersAreThoseOfTheApp(String parameters) throws IOException {
    Map<String, Object> file = full(places().get(0));
    file.put("parameters", parameters);
    String yaml = yaml(file);
    // Which texts are faults, only the scenario's schema knows.
    if (!parameters.contains("crush")) {
      assertAgree(yaml);
    }
    file.put("app", "intersection");
    file.put("parameters", "{scenario: figure7, debris: 0}");
    assertThat(errorOrNone(yaml(file))).isEmpty();
    assertAgree(yaml(file));
  }

  static List<Path> deployments() throws IOException {
    try (Stream<Path> files = Files.list(ROOT.resolve("scenarios/deployment"))) {
      return files.filter(file -> file.toString().endsWith(".yaml")).sorted().toList();
    }
  }

  @ParameterizedTest
  @MethodSource("deployments")
  void everyDeploymentIsRightForEditorsAndCommands(Path file) throws IOException {
    String text = Files.readString(file);
    assertThat(text)
        .startsWith("# yaml-language-server: $schema=../../docs/deployment.schema.json\n");
    JsonNode committed = new ObjectMapper().readTree(Files.readString(COMMITTED));
    assertThat(schema(committed).validate(YAML.readTree(text))).isEmpty();
    assertThat(DeploymentFile.read(file.toString()).robots()).isNotEmpty();
  }

  @Test
  void noOtherKindOfFileHasASchema() {
    Cli cli = Cli.run("schema", "picture");

    assertThat(cli.status()).isEqualTo(2);
    assertThat(cli.err()).hasSize(1);
    assertThat(cli.err().get(0)).contains("picture", "scenario, sweep, deployment");
  }
}
