package org.starl.cli.schema;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Parameter;
import org.starl.cli.command.Json;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.ScenarioFile;
import org.starl.input.Form;
import org.starl.sim.Setting;
import org.starl.sim.fault.Envelope;

/**
 * The JSON schema of {@link ScenarioFile}, for editors: the apps, settings and parameters, and
 * their values. It accepts the files that a command accepts, except numbers and booleans in quotes.
 * It does not check conditions between two values.
 */
public final class ScenarioSchema {

  /** The app's parameter that chooses one of its scenarios. */
  private static final String SCENARIO = "scenario";

  private ScenarioSchema() {}

  public static Map<String, Object> json(Demos demos) {
    return json(
        "StarL scenario",
        "A file for 'starl run FILE.yaml': an app, with any of its settings and parameters.",
        demos,
        Map.of(),
        List.of(),
        demo -> Map.of());
  }

  /**
   * The schema of a file that has a scenario and more.
   *
   * @param more properties
   * @param required some of them
   * @param rules more rules about these properties, for each app
   */
  static Map<String, Object> json(
      String title,
      String meaning,
      Demos demos,
      Map<String, Object> more,
      List<String> required,
      Function<Demo, Map<String, Object>> rules) {
    Map<String, Object> properties = new LinkedHashMap<>();
    properties.put(ScenarioFile.APP, apps(demos));
    properties.putAll(more);
    properties.putAll(settings());
    Map<String, Object> schema = JsonSchema.document(title, meaning);
    schema.put("type", "object");
    List<String> needed = new ArrayList<>(List.of(ScenarioFile.APP));
    needed.addAll(required);
    schema.put(JsonSchema.REQUIRED, needed);
    schema.put("definitions", Map.of("setting", Map.of("enum", List.copyOf(properties.keySet()))));
    schema.put(JsonSchema.PROPERTIES, properties);
    schema.put(
        "allOf", demos.all().stream().map(demo -> parameters(demo, rules.apply(demo))).toList());
    return schema;
  }

  /** The name of an app. */
  static Map<String, Object> apps(Demos demos) {
    Map<String, String> summaries = new LinkedHashMap<>();
    demos.all().forEach(demo -> summaries.put(demo.name(), demo.summary()));
    return choice("", summaries);
  }

  /** The parameters of a deployment of any app: settings with one value each. */
  static Map<String, Object> anyParameters() {
    Map<String, Object> properties = settings();
    properties.put(
        Setting.FAULTS.key(),
        JsonSchema.property(Setting.FAULTS.meaning(), new Form.Words("faults"), null));
    return Json.object("type", "object", JsonSchema.PROPERTIES, properties);
  }

  /** The settings, by their keys. */
  static Map<String, Object> settings() {
    Map<String, Object> settings = new LinkedHashMap<>();
    for (Setting<?> setting : RunRequest.known()) {
      Map<String, Object> json =
          setting.equals(Setting.CHAOS)
              ? chaos()
              : JsonSchema.property(setting.meaning(), setting.form(), null);
      // The default time limit depends on the app.
      if (!setting.equals(Setting.DURATION)) {
        JsonSchema.putDefault(json, setting.form(), setting.defaultText());
      }
      settings.put(setting.key(), json);
    }
    return settings;
  }

  /** An envelope's name, or {@code true} for the app's own. */
  private static Map<String, Object> chaos() {
    Map<String, String> meanings = new LinkedHashMap<>();
    meanings.put("true", "the faults that the app must tolerate");
    for (Envelope envelope : Envelope.values()) {
      meanings.put(envelope.toString(), envelope.meaning());
    }
    Map<String, Object> json = choice("faults drawn by seed:\n", meanings);
    List<Object> values = new ArrayList<>(JsonSchema.YES_NO);
    values.addAll(meanings.keySet().stream().skip(1).toList());
    json.put("enum", values);
    return json;
  }

  /** The parameters of an app, by their keys. */
  static Map<String, Object> parametersOf(Demo demo) {
    Map<String, Object> parameters = new LinkedHashMap<>();
    for (Parameter parameter : demo.parameters()) {
      parameters.put(parameter.key(), parameter(demo, parameter));
    }
    return parameters;
  }

  /**
   * If the file has this app: its parameters, {@code #/definitions/setting}, and no others.
   *
   * @param rules about other properties
   */
  static Map<String, Object> parameters(Demo demo, Map<String, Object> rules) {
    Map<String, Object> properties = parametersOf(demo);
    Object setting = Map.of("$ref", "#/definitions/setting");
    List<Object> keys = new ArrayList<>(List.of(setting));
    if (!properties.isEmpty()) {
      keys.add(Map.of("enum", List.copyOf(properties.keySet())));
    }
    properties.putAll(rules);
    Object names = keys.size() == 1 ? setting : Map.of("anyOf", keys);
    Object rule =
        Json.object(
            JsonSchema.DESCRIPTION,
            demo.summary(),
            JsonSchema.PROPERTIES,
            properties,
            "propertyNames",
            names);
    Object isApp = Map.of(ScenarioFile.APP, Map.of("const", demo.name()));
    Object condition =
        Json.object(JsonSchema.PROPERTIES, isApp, JsonSchema.REQUIRED, List.of(ScenarioFile.APP));
    return Json.object("if", condition, "then", rule);
  }

  private static Map<String, Object> parameter(Demo demo, Parameter parameter) {
    Form form = parameter.form();
    Map<String, Object> json = Json.object(JsonSchema.DESCRIPTION, parameter.text());
    if (parameter.key().equals(SCENARIO) && !demo.scenarios().isEmpty()) {
      Map<String, String> scenarios = new LinkedHashMap<>();
      demo.scenarios().forEach(scenario -> scenarios.put(scenario.name(), scenario.what()));
      json.putAll(choice("", scenarios));
    } else if (parameter.defaultValue().isEmpty() && !(form instanceof Form.Text)) {
      json.put("anyOf", List.of(Map.of("const", ""), JsonSchema.value(form)));
    } else {
      json.putAll(JsonSchema.value(form));
    }
    JsonSchema.putDefault(json, form, parameter.defaultValue());
    return json;
  }

  /**
   * One of several words.
   *
   * @param meanings of the words
   */
  private static Map<String, Object> choice(String heading, Map<String, String> meanings) {
    List<String> lines = new ArrayList<>();
    meanings.forEach((word, meaning) -> lines.add(word + ": " + meaning));
    return Json.object(
        JsonSchema.DESCRIPTION,
        heading + String.join("\n", lines),
        "enum",
        List.copyOf(meanings.keySet()));
  }
}
