package org.starl.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.robot.file.Field;
import org.starl.robot.file.Form;
import org.starl.robot.file.Grammar;
import org.starl.sim.Setting;

/**
 * The JSON schema (draft 7) of deployment files, for editors, drawn from the {@link Grammar} that reads
 * them. It refuses nothing that {@code deploy check} would take, but for what stands in quotes
 * needlessly; what depends on two values at once, or on the machine, it does not know.
 */
final class DeploymentSchema {

  private static final String APP = "app";
  private static final String PARAMETERS = "parameters";
  private static final String DESCRIPTION = "description";
  private static final String PROPERTIES = "properties";
  private static final String REQUIRED = "required";
  private static final String PATTERN = "pattern";

  private static final String PORT_NUMBER =
      "(6553[0-5]|655[0-2]\\d|65[0-4]\\d\\d|6[0-4]\\d{3}|[1-5]\\d{4}|[1-9]\\d{0,3})";
  private static final String NAME = "[^\\s:\\[\\]]+";
  private static final String BRACKETS = "\\[[^\\s\\[\\]]+\\]";
  private static final String HOST_PORT = "(" + NAME + "|" + BRACKETS + "):" + PORT_NUMBER;

  /** An IPv6 address may stand without brackets where no port follows. */
  private static final String HOST =
      "(" + NAME + "|" + BRACKETS + "|[^\\s:\\[\\]]*(:[^\\s:\\[\\]]*){2,})";

  private final Demos demos;

  DeploymentSchema(Demos demos) {
    this.demos = demos;
  }

  /** As JSON objects have it: maps, lists, texts, numbers. */
  Map<String, Object> json() {
    Map<String, Object> schema = new LinkedHashMap<>();
    schema.put("$schema", "http://json-schema.org/draft-07/schema#");
    schema.put("title", "StarL deployment");
    schema.put(DESCRIPTION, "What 'starl deploy' runs: an app on real robots.");
    List<String> settings = Chosen.known().stream().map(Setting::key).toList();
    schema.put("definitions", Map.of("setting", Map.of("enum", settings)));
    schema.putAll(lines(Grammar.FILE.fields()));
    Map<String, Object> properties = new LinkedHashMap<>(properties(Grammar.FILE.fields()));
    properties.put(APP, new ScenarioSchema(demos).apps());
    schema.put(PROPERTIES, properties);
    schema.put("allOf", demos.all().stream().map(DeploymentSchema::parameters).toList());
    return schema;
  }

  /** If it is this app: its parameters, and no others. */
  private static Map<String, Object> parameters(Demo demo) {
    Map<String, Object> rule = new LinkedHashMap<>(ScenarioSchema.parameters(demo));
    rule.computeIfPresent("then", (key, then) -> Map.of(PROPERTIES, Map.of(PARAMETERS, then)));
    return rule;
  }

  private static Map<String, Object> property(Field field) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put(DESCRIPTION, field.says());
    json.putAll(value(field.form()));
    String usual = field.usual();
    if (usual != null) {
      json.put("default", typed(field.form(), usual));
    }
    return json;
  }

  private static Map<String, Object> properties(List<Field> fields) {
    Map<String, Object> properties = new LinkedHashMap<>();
    fields.forEach(field -> properties.put(field.key(), property(field)));
    return properties;
  }

  private static Map<String, Object> value(Form form) {
    return switch (form) {
      case Form.Text text -> anyText();
      case Form.Choice choice -> Map.of("enum", choices(choice));
      case Form.YesNo yesNo -> Map.of("enum", List.of(true, false, "yes", "no"));
      case Form.Whole whole -> number("integer", whole.least(), whole.most());
      case Form.Amount amount -> number("number", amount.least(), amount.most());
      case Form.Address address ->
          text(
              address.needsPort() ? HOST_PORT : "(" + HOST_PORT + "|" + HOST + ")",
              address.needsPort() ? "expected HOST:PORT" : "expected HOST or HOST:PORT");
      case Form.Port port ->
          text("(tcp:" + HOST_PORT + "|(?!tcp:)\\S.*)", "expected a device or tcp:HOST:PORT");
      case Form.Lines lines -> lines(lines.fields());
      case Form.Kinds kinds -> kinds(kinds);
      case Form.Named named -> named(named);
      case Form.Parameters parameters -> settings();
    };
  }

  /** A number or a yes is one, too, unless it is quoted. */
  private static Map<String, Object> anyText() {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("type", List.of("string", "number", "boolean"));
    json.put(PATTERN, "\\S");
    return json;
  }

  private static Map<String, Object> number(String type, Number least, Number most) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("type", type);
    json.put("minimum", least);
    json.put("maximum", most);
    return json;
  }

  private static Map<String, Object> text(String pattern, String expected) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("type", "string");
    json.put(PATTERN, "^\\s*" + pattern + "\\s*$");
    json.put("patternErrorMessage", expected);
    return json;
  }

  /** A version stands there as a number, unless somebody quotes it. */
  private static List<Object> choices(Form.Choice choice) {
    List<Object> values = new ArrayList<>(choice.values());
    for (String value : choice.values()) {
      if (value.matches("\\d+\\.\\d+")) {
        values.add(Double.valueOf(value));
      }
    }
    return values;
  }

  private static Map<String, Object> lines(List<Field> fields) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("type", "object");
    json.put("additionalProperties", false);
    json.put(REQUIRED, needed(fields));
    json.put(PROPERTIES, properties(fields));
    return json;
  }

  private static List<String> needed(List<Field> fields) {
    return fields.stream().filter(Field::isNeeded).map(Field::key).toList();
  }

  /** If it is of this kind: what that has, and nothing else. */
  private static Map<String, Object> kinds(Form.Kinds kinds) {
    String by = kinds.by().key();
    List<Object> rules = new ArrayList<>();
    kinds
        .kinds()
        .forEach((kind, fields) -> {
          List<Field> all = new ArrayList<>(List.of(kinds.by()));
          all.addAll(fields);
          Map<String, Object> rule = new LinkedHashMap<>();
          rule.put("if", Map.of(PROPERTIES, Map.of(by, Map.of("const", kind))));
          rule.put("then", lines(all));
          rules.add(rule);
        });
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("type", "object");
    json.put(REQUIRED, List.of(by));
    json.put(PROPERTIES, properties(List.of(kinds.by())));
    json.put("allOf", rules);
    return json;
  }

  private static Map<String, Object> named(Form.Named named) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("type", "object");
    json.put("minProperties", 1);
    json.put("propertyNames", Map.of(PATTERN, "^[A-Za-z][A-Za-z0-9_.-]{0,31}$"));
    json.put("additionalProperties", lines(named.each().fields()));
    return json;
  }

  /** Each one value: faults are one text here. */
  private static Map<String, Object> settings() {
    Map<String, Object> properties = new LinkedHashMap<>(ScenarioSchema.settings());
    Map<String, Object> faults = new LinkedHashMap<>();
    faults.put(DESCRIPTION, Setting.FAULTS.meaning());
    faults.putAll(anyText());
    properties.put(Setting.FAULTS.key(), faults);
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("type", "object");
    json.put(PROPERTIES, properties);
    return json;
  }

  private static Object typed(Form form, String text) {
    return switch (form) {
      case Form.Whole whole -> Long.valueOf(text);
      case Form.Amount amount -> Double.valueOf(text);
      default -> text;
    };
  }
}
