package org.starl.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Parameter;
import org.starl.apps.Scenario;
import org.starl.input.Form;
import org.starl.input.Quantity;
import org.starl.sim.Setting;
import org.starl.sim.fault.Envelope;
import org.starl.sim.fault.FaultGrammar;

/**
 * The JSON schema (draft 7) of {@link ScenarioFile}, for editors: which apps, settings and
 * parameters there are, and which values they take. It refuses nothing that a command would take, but
 * for a number or a yes in quotes; what depends on two values at once, it does not know.
 */
final class ScenarioSchema {

  /** The app's parameter that chooses one of its scenarios. */
  private static final String SCENARIO = "scenario";

  private static final List<Object> YES_NO = List.of(true, false, "yes", "no", "on", "off");

  private final Demos demos;

  ScenarioSchema(Demos demos) {
    this.demos = demos;
  }

  /** As JSON objects have it: maps, lists, texts, numbers. */
  Map<String, Object> json() {
    Map<String, Object> properties = new LinkedHashMap<>();
    properties.put(ScenarioFile.APP, apps());
    properties.putAll(settings());
    Map<String, Object> schema = new LinkedHashMap<>();
    schema.put("$schema", "http://json-schema.org/draft-07/schema#");
    schema.put("title", "StarL scenario");
    schema.put(
        "description",
        "What 'starl run FILE.yaml' runs: an app, and any settings and parameters of it.");
    schema.put("type", "object");
    schema.put("required", List.of(ScenarioFile.APP));
    schema.put("definitions", Map.of("setting", Map.of("enum", List.copyOf(properties.keySet()))));
    schema.put("properties", properties);
    schema.put("allOf", demos.all().stream().map(ScenarioSchema::parameters).toList());
    return schema;
  }

  /** The name of one of them. */
  Map<String, Object> apps() {
    return choice(
        demos.names(),
        demos.all().stream()
            .map(demo -> demo.name() + ": " + demo.summary())
            .collect(Collectors.joining("\n")));
  }

  /** Every setting by its key. */
  static Map<String, Object> settings() {
    Map<String, Object> settings = new LinkedHashMap<>();
    for (Setting<?> setting : Chosen.known()) {
      settings.put(setting.key(), setting(setting));
    }
    return settings;
  }

  private static Map<String, Object> setting(Setting<?> setting) {
    Map<String, Object> json = described(setting.meaning());
    if (setting.form() instanceof Form.Faults) {
      json.putAll(faults());
    } else if (setting.equals(Setting.CHAOS)) {
      json.putAll(chaos());
    } else {
      json.putAll(value(setting.form()));
    }
    // The time limit depends on the app, where nobody sets one.
    if (!setting.equals(Setting.DURATION)) {
      json.put("default", typed(setting.form(), setting.defaultText()));
    }
    return json;
  }

  /** Besides an envelope's name, {@code true} for the app's own. */
  private static Map<String, Object> chaos() {
    List<Object> values = new ArrayList<>(YES_NO);
    List<String> meanings = new ArrayList<>(List.of("true: what the app must bear"));
    for (Envelope envelope : Envelope.values()) {
      values.add(envelope.toString());
      meanings.add(envelope + ": " + envelope.meaning());
    }
    Map<String, Object> json = described("faults drawn by seed:\n" + String.join("\n", meanings));
    json.put("enum", values);
    return json;
  }

  /**
   * A text, or a list. In a list like {@code [loss(0.1,from=bot1)]} YAML parts at each comma, so
   * what goes on behind one is taken too: {@code from=bot1)}.
   */
  private static Map<String, Object> faults() {
    List<String> usages = new ArrayList<>();
    List<String> names = new ArrayList<>();
    for (FaultGrammar.Kind kind : FaultGrammar.kinds()) {
      usages.add(kind.usage() + ": " + kind.meaning());
      names.add(kind.name());
    }
    String begin = "\\s*(" + String.join("|", names) + ")\\s*(\\(.*)?$";
    Map<String, Object> part = new LinkedHashMap<>();
    part.put("type", List.of("string", "number"));
    part.put("pattern", "^(" + begin + "|\\s*[a-z]+\\s*=.*|\\s*[-+0-9].*)");
    part.put("patternErrorMessage", "expected a fault: " + String.join(", ", names));
    Map<String, Object> text = new LinkedHashMap<>();
    text.put("type", "string");
    text.put("pattern", "^(\\s*$|" + begin + ")");
    text.put("patternErrorMessage", "expected faults: " + String.join(", ", names));
    Map<String, Object> list = new LinkedHashMap<>();
    list.put("type", "array");
    list.put("items", part);
    Map<String, Object> json =
        described(
            "what goes wrong, a fault a line; "
                + FaultGrammar.TIMES
                + ":\n"
                + String.join("\n", usages));
    json.put("anyOf", List.of(list, text));
    return json;
  }

  /** If it is this app: its parameters, {@code #/definitions/setting}, and nothing else. */
  static Map<String, Object> parameters(Demo demo) {
    Map<String, Object> properties = new LinkedHashMap<>();
    for (Parameter parameter : demo.parameters()) {
      properties.put(parameter.key(), parameter(demo, parameter));
    }
    Object setting = Map.of("$ref", "#/definitions/setting");
    List<Object> keys = new ArrayList<>(List.of(setting));
    if (!properties.isEmpty()) {
      keys.add(Map.of("enum", List.copyOf(properties.keySet())));
    }
    Map<String, Object> rule = new LinkedHashMap<>();
    rule.put("properties", properties);
    rule.put("propertyNames", keys.size() == 1 ? setting : Map.of("anyOf", keys));
    Map<String, Object> json = new LinkedHashMap<>();
    Map<String, Object> condition = new LinkedHashMap<>();
    condition.put("properties", Map.of(ScenarioFile.APP, Map.of("const", demo.name())));
    condition.put("required", List.of(ScenarioFile.APP));
    json.put("if", condition);
    json.put("then", rule);
    return json;
  }

  private static Map<String, Object> parameter(Demo demo, Parameter parameter) {
    Form form = parameter.form();
    Map<String, Object> json = described(parameter.what());
    if (parameter.key().equals(SCENARIO) && !demo.scenarios().isEmpty()) {
      List<String> names = demo.scenarios().stream().map(Scenario::name).toList();
      json.putAll(
          choice(
              names,
              demo.scenarios().stream()
                  .map(scenario -> scenario.name() + ": " + scenario.what())
                  .collect(Collectors.joining("\n"))));
    } else if (parameter.defaultValue().isEmpty() && !(form instanceof Form.Text)) {
      json.put("anyOf", List.of(Map.of("const", ""), value(form)));
    } else {
      json.putAll(value(form));
    }
    json.put("default", typed(form, parameter.defaultValue()));
    return json;
  }

  private static Map<String, Object> described(String what) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("description", what);
    return json;
  }

  private static Map<String, Object> choice(List<String> values, String what) {
    Map<String, Object> json = described(what);
    json.put("enum", values);
    return json;
  }

  private static Map<String, Object> value(Form form) {
    Map<String, Object> json = new LinkedHashMap<>();
    switch (form) {
      case Form.Whole whole -> {
        json.put("type", "integer");
        json.put("minimum", whole.least());
        json.put("maximum", whole.most());
      }
      case Form.Amount amount -> json.putAll(amount(amount));
      case Form.Choice choice -> json.put("enum", choice.values());
      case Form.YesNo yesNo -> json.put("enum", YES_NO);
      case Form.Text text -> {
        boolean isAny = text.pattern().isEmpty();
        json.put("type", isAny ? List.of("string", "number", "boolean") : "string");
        if (!isAny) {
          json.put("pattern", text.pattern());
        }
      }
      case Form.Faults faults -> json.putAll(faults());
    }
    return json;
  }

  private static Map<String, Object> amount(Form.Amount amount) {
    Quantity quantity = amount.quantity();
    double most = quantity.mostWithoutUnit();
    boolean takesNumbers = amount.isAboveZero() ? most > 0 : most >= 0;
    Map<String, Object> json = new LinkedHashMap<>();
    if (isPlainNumber(amount)) {
      json.put("type", "number");
    } else {
      json.put("type", takesNumbers ? List.of("number", "string") : "string");
      json.put("pattern", amount.isAboveZero() ? quantity.patternAbove0() : quantity.pattern());
    }
    if (takesNumbers) {
      json.put(amount.isAboveZero() ? "exclusiveMinimum" : "minimum", 0);
      if (most < Double.POSITIVE_INFINITY) {
        json.put("maximum", (long) most);
      }
    }
    return json;
  }

  private static boolean isPlainNumber(Form form) {
    return form instanceof Form.Amount amount
        && (amount.quantity() == Quantity.NUMBER || amount.quantity() == Quantity.PROBABILITY);
  }

  /** A default as YAML would have it. */
  private static Object typed(Form form, String text) {
    if (form instanceof Form.Whole) {
      return Long.valueOf(text);
    }
    if (form instanceof Form.YesNo) {
      return Boolean.valueOf(text);
    }
    return isPlainNumber(form) ? Double.valueOf(text) : text;
  }
}
